/* site_chart.c - see site_chart.h. */
#include "charts/site/site_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "charts/room/contour_lines.h"
#include "charts/room/plan_strip.h"
#include "charts/room/room_plan.h"
#include "charts/sheet/hatch.h"
#include "charts/sheet/page.h"
#include "charts/site/site_crowns.h"
#include "charts/site/site_names.h"
#include "charts/site/site_shape.h"
#include "charts/site/strip_table.h"
#include "charts/site/sky_bands.h"
#include "model/geometry/tolerance.h"

/* ---- extent ---- */

static struct pp_bounds2 room_bounds(const struct pp_site_sheet *sheet)
{
    struct pp_bounds2 box = pp_bounds2_empty();
    for (int i = 0; i < sheet->shape_count; i++)
        for (int k = 0; sheet->shapes[i].is_room && k < sheet->shapes[i].count; k++)
            pp_bounds2_add(&box, sheet->shapes[i].corners[k].x,
                           sheet->shapes[i].corners[k].y);
    return box;
}

/* Extends the box to a point, but not farther than `reach` from the rooms. */
static void add_within(struct pp_bounds2 *box, const struct pp_bounds2 *rooms,
                       double reach, double x, double y)
{
    pp_bounds2_add(box, fmin(fmax(x, rooms->low[0] - reach), rooms->high[0] + reach),
                   fmin(fmax(y, rooms->low[1] - reach), rooms->high[1] + reach));
}

/* Extent (m) of the rooms and their surroundings. If there is a plot, only of the rooms
 * and the plot. */
static struct pp_bounds2 site_extent(const struct pp_site_sheet *sheet)
{
    struct pp_bounds2 rooms = room_bounds(sheet);
    for (int i = 0; i < sheet->cell_count; i++)
        for (int k = 0; k < 4; k++)
            pp_bounds2_add(&rooms, sheet->cells[i].corners[k][0],
                           sheet->cells[i].corners[k][1]);
    if (sheet->cell_count > 0)
        return rooms;
    double reach = fmax(
        1.5 * fmax(rooms.high[0] - rooms.low[0], rooms.high[1] - rooms.low[1]), 30.0);
    struct pp_bounds2 box = rooms;
    for (int i = 0; i < sheet->shape_count; i++)
        for (int k = 0; k < sheet->shapes[i].count; k++)
            add_within(&box, &rooms, reach, sheet->shapes[i].corners[k].x,
                       sheet->shapes[i].corners[k].y);
    for (int i = 0; i < sheet->tree_count; i++)
        for (int k = 0; k < 2; k++) {
            const struct pp_site_tree *tree = &sheet->trees[i];
            double radius = (k ? 0.5 : -0.5) * tree->crown_width_m;
            add_within(&box, &rooms, reach, tree->foot.x + radius,
                       tree->foot.y + radius);
        }
    return box;
}

/* Smallest denominator of a scale that is at least `least`. Besides the usual scales it
 * may be 1:300, 1:400, 1:600 ... (as on triangular scale rulers), which may fill the
 * sheet better. */
static double site_scale(double least)
{
    static const double more[] = {3.0, 4.0, 6.0};
    double scale = pp_room_plan_usual_scale(least);
    double power = pow(10.0, floor(log10(fmax(least, 100.0))));
    for (int i = 0; i < 3; i++)
        if (more[i] * power >= least * (1.0 - 1e-9))
            scale = fmin(scale, more[i] * power);
    return scale;
}

/* Sets the largest usual scale at which the site fits, with a border for the values at
 * windows. */
static void fit_site_scale(struct pp_site_drawing *drawing, struct pp_box room)
{
    struct pp_room_plan *frame = &drawing->frame;
    double border = 3.0 * drawing->style.scale;
    frame->extent = site_extent(drawing->sheet);
    frame->scale = 20.0;
    for (int i = 0; i < 100; i++) {
        frame->mm_per_m = 1000.0 / frame->scale;
        struct pp_box box = pp_site_names_frame(frame);
        if (box.width + 2.0 * border <= room.width
            && box.height + 2.0 * border <= room.height)
            break;
        frame->scale = site_scale(frame->scale * 1.001);
    }
    struct pp_box box = pp_site_names_frame(frame);
    frame->x = room.x + 0.5 * (room.width - box.width);
    frame->y = room.y + 0.5 * (room.height + box.height);
    drawing->labels->field = room;
}

/* ---- gardens ---- */

static void draw_garden(struct pp_site_drawing *drawing,
                        const struct pp_site_garden *garden)
{
    cairo_t *cr = drawing->cr;
    const struct pp_style *style = &drawing->style;
    cairo_set_fill_rule(cr, CAIRO_FILL_RULE_WINDING);
    for (int i = 0; i < garden->dark.count; i++)
        pp_contour_lines_path(cr, &drawing->frame, &garden->dark.list[i]);
    pp_hatch_path(cr, pp_site_names_frame(&drawing->frame), 0.8 * style->scale,
                  style->hair, PP_GREY_LINE);
    double dashes[] = {0.3 * style->scale, 0.9 * style->scale};
    cairo_new_path(cr);
    for (int i = 0; i < garden->count; i++)
        cairo_line_to(cr, pp_plan_frame_x(&drawing->frame, garden->corners[i][0]),
                      pp_plan_frame_y(&drawing->frame, garden->corners[i][1]));
    cairo_close_path(cr);
    pp_style_line(cr, style->medium, PP_INK);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
    cairo_set_dash(cr, dashes, 2, 0.0);
    cairo_stroke(cr);
    cairo_set_dash(cr, NULL, 0, 0.0);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_BUTT);
}

/* ---- a plot ---- */

/* Writes the height in its cell: to a decimetre, to a metre, or not at all, depending
 * on the space. */
static void say_height(struct pp_site_drawing *drawing, const struct pp_site_cell *cell,
                       double x, double y, double width)
{
    static const char *const forms[] = {"%.1f", "%.0f"};
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5};
    for (int i = 0; i < 2 && cell->height_m > 0.0; i++) {
        char words[16];
        snprintf(words, sizeof words, forms[i], cell->height_m);
        if (pp_lettering_measure(drawing->cr, &drawing->style, &set, x, y, words).width
            > width)
            continue;
        pp_lettering_draw(drawing->cr, &drawing->style, &set, x, y, words);
        return;
    }
}

static void draw_cells(struct pp_site_drawing *drawing)
{
    const struct pp_site_sheet *sheet = drawing->sheet;
    cairo_t *cr = drawing->cr;
    double highest = 0.0;
    for (int i = 0; i < sheet->cell_count; i++)
        highest = fmax(highest, sheet->cells[i].height_m);
    for (int i = 0; i < sheet->cell_count; i++) {
        const struct pp_site_cell *cell = &sheet->cells[i];
        double middle[2] = {0.0, 0.0}, x[4], y[4];
        cairo_new_path(cr);
        for (int k = 0; k < 4; k++) {
            x[k] = pp_plan_frame_x(&drawing->frame, cell->corners[k][0]);
            y[k] = pp_plan_frame_y(&drawing->frame, cell->corners[k][1]);
            middle[0] += 0.25 * x[k];
            middle[1] += 0.25 * y[k];
            cairo_line_to(cr, x[k], y[k]);
        }
        cairo_close_path(cr);
        pp_style_grey(cr, 1.0 - 0.4 * cell->height_m / fmax(highest, 1e-9));
        cairo_fill_preserve(cr);
        pp_style_line(cr, drawing->style.hair, PP_GREY_TEXT);
        cairo_stroke(cr);
        say_height(drawing, cell, middle[0], middle[1],
                   hypot(x[1] - x[0], y[1] - y[0]));
    }
}

/* ---- windows ---- */

/* Rotation of text along a line, so that the text is not upside down. */
static double upright_turn(double turn)
{
    if (turn > PP_PI / 2.0 + 1e-6)
        turn -= PP_PI;
    if (turn <= -PP_PI / 2.0 + 1e-6)
        turn += PP_PI;
    return turn;
}

/* True if the text fits into the window's strip. */
static bool strip_fits(const struct pp_site_drawing *drawing,
                       const struct pp_site_window *window, const char *words)
{
    const struct pp_lettering set = {.size = PP_TEXT_SMALL};
    double strip =
        pp_vec_length(pp_vec_sub(window->to, window->from)) * drawing->frame.mm_per_m;
    return pp_lettering_measure(drawing->cr, &drawing->style, &set, 0.0, 0.0, words)
               .width
           < strip - 0.4;
}

/* Makes the text of a window's strip: name and, unless it is in the table, value; only
 * the value if both do not fit. */
static void window_words(const struct pp_site_drawing *drawing,
                         const struct pp_site_window *window, char *words, size_t room)
{
    double percent = 100.0 * window->component;
    snprintf(words, room, "%s", window->label);
    if (drawing->in_table)
        return;
    snprintf(words, room, "%s\u00a0\u00a0%.1f", window->label, percent);
    if (!strip_fits(drawing, window, words))
        snprintf(words, room, "%.1f", percent);
}

/* True if name and value of every window fit into its strip. */
static bool figures_fit(const struct pp_site_drawing *drawing)
{
    for (int i = 0; i < drawing->sheet->window_count; i++) {
        const struct pp_site_window *window = &drawing->sheet->windows[i];
        char words[48];
        snprintf(words, sizeof words, "%s\u00a0\u00a0%.1f", window->label,
                 100.0 * window->component);
        if (!strip_fits(drawing, window, words))
            return false;
    }
    return true;
}

/* True if the name of every window fits into its strip. */
static bool names_fit(const struct pp_site_drawing *drawing)
{
    const struct pp_site_sheet *sheet = drawing->sheet;
    for (int i = 0; i < sheet->window_count; i++)
        if (!strip_fits(drawing, &sheet->windows[i], sheet->windows[i].label))
            return false;
    return true;
}

/* Draws a strip in front of the window, as long as the window. The strip of the lowest
 * storey is next to the wall. */
static void draw_window(struct pp_site_drawing *drawing,
                        const struct pp_site_window *window)
{
    cairo_t *cr = drawing->cr;
    const struct pp_style *style = &drawing->style;
    double deep = pp_site_names_deep(style);
    double fx = pp_plan_frame_x(&drawing->frame, window->from.x);
    double fy = pp_plan_frame_y(&drawing->frame, window->from.y);
    double tx = pp_plan_frame_x(&drawing->frame, window->to.x);
    double ty = pp_plan_frame_y(&drawing->frame, window->to.y);
    double ox = window->out.x, oy = -window->out.y;
    double near = pp_site_names_near(style, window->storey);
    cairo_new_path(cr);
    cairo_move_to(cr, fx + near * ox, fy + near * oy);
    cairo_line_to(cr, tx + near * ox, ty + near * oy);
    cairo_line_to(cr, tx + (near + deep) * ox, ty + (near + deep) * oy);
    cairo_line_to(cr, fx + (near + deep) * ox, fy + (near + deep) * oy);
    cairo_close_path(cr);
    pp_labels_note_path(drawing->labels, cr, -1);
    int band = pp_sky_bands_of(window->component);
    pp_sky_bands_colour(cr, band, false);
    cairo_fill_preserve(cr);
    pp_style_line(cr, pp_sky_bands_is_lost(window) ? style->medium : style->hair,
                  PP_INK);
    cairo_stroke(cr);

    char words[48];
    double x = 0.5 * (fx + tx) + (near + 0.5 * deep) * ox,
           y = 0.5 * (fy + ty) + (near + 0.5 * deep) * oy;
    struct pp_lettering set = {.size = PP_TEXT_SMALL,
                               .across = 0.5,
                               .down = 0.5,
                               .turn_rad = upright_turn(atan2(ty - fy, tx - fx)),
                               .grey = pp_sky_bands_is_dark(band) ? 1.0 : PP_INK};
    window_words(drawing, window, words, sizeof words);
    if (strip_fits(drawing, window, words) && !drawing->names_before)
        pp_lettering_draw(cr, style, &set, x, y, words);
}

/* ---- the sheet ---- */

static bool has_when(const struct pp_site_sheet *sheet, enum pp_site_when when)
{
    for (int i = 0; i < sheet->shape_count; i++)
        if (sheet->shapes[i].when == when && sheet->shapes[i].is_level)
            return true;
    return false;
}

static int gather_keys(const struct pp_site_sheet *sheet, struct pp_key keys[8])
{
    int count = PP_SKY_BANDS;
    pp_sky_bands_keys(keys);
    if (has_when(sheet, PP_SITE_NEW)) {
        keys[count] = (struct pp_key){.kind = PP_KEY_HATCH, .curve.dashes = {1.4}};
        snprintf(keys[count++].words, sizeof keys->words, "proposed");
    }
    if (has_when(sheet, PP_SITE_GONE)) {
        keys[count] = (struct pp_key){
            .kind = PP_KEY_LINE, .curve = pp_style_curve(1), .grey = PP_GREY_TEXT};
        snprintf(keys[count++].words, sizeof keys->words, "to be demolished");
    }
    if (sheet->garden_count > 0) {
        keys[count] = (struct pp_key){.kind = PP_KEY_HATCH, .curve.dashes = {0.8}};
        snprintf(keys[count++].words, sizeof keys->words,
                 "garden with under 2 h of sun on 21 March");
    }
    return count;
}

/* True if the point is above or below a corner of the shape. */
static bool has_corner_at(const struct pp_site_shape *shape, struct pp_vec3 at)
{
    for (int i = 0; i < shape->count; i++)
        if (hypot(shape->corners[i].x - at.x, shape->corners[i].y - at.y) < PP_SAME_M)
            return true;
    return false;
}

/* True for a vertical side of a block that is to be demolished. The dashed outline of
 * the block's top shows it; dashes of both, drawn one over the other, look like a solid
 * line. */
static bool is_under_edge(const struct pp_site_sheet *sheet,
                          const struct pp_site_shape *side)
{
    if (side->is_level || side->when != PP_SITE_GONE || side->ends)
        return false; /* ends: a part of a mesh, whose lines are drawn only once */
    for (int i = 0; i < sheet->shape_count; i++) {
        const struct pp_site_shape *top = &sheet->shapes[i];
        bool is_same = top->is_level && top->when == PP_SITE_GONE && !top->ends;
        for (int k = 0; k < side->count && is_same; k++)
            is_same = has_corner_at(top, side->corners[k]);
        if (is_same)
            return true;
    }
    return false;
}

static void draw_site(struct pp_site_drawing *drawing)
{
    const struct pp_site_sheet *sheet = drawing->sheet;
    struct pp_box box = pp_site_names_frame(&drawing->frame);
    cairo_t *cr = drawing->cr;
    cairo_save(cr);
    /* Extends the clip by one line width, so that lines on the edge of the drawing are
     * not halved. */
    double line = drawing->style.hair;
    cairo_rectangle(cr, box.x - line, box.y - line, box.width + 2.0 * line,
                    box.height + 2.0 * line);
    cairo_clip(cr);
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < sheet->shape_count; i++)
            if ((sheet->shapes[i].when == PP_SITE_GONE) == (pass == 1)
                && !is_under_edge(sheet, &sheet->shapes[i]))
                pp_site_shape_draw(drawing->cr, &drawing->style, &drawing->frame, box,
                                   &sheet->shapes[i]);
    for (int i = 0; i < sheet->garden_count; i++)
        draw_garden(drawing, &sheet->gardens[i]);
    draw_cells(drawing);
    for (int i = 0; i < sheet->tree_count; i++)
        pp_site_crowns_draw_plan(cr, &drawing->style, &drawing->frame,
                                 &sheet->trees[i]);
    cairo_restore(cr);
    for (int i = 0; i < sheet->window_count; i++)
        draw_window(drawing, &sheet->windows[i]);
    if (drawing->names_before)
        pp_site_names_windows(drawing);
    pp_site_names_draw(drawing);
}

/* ---- the values at windows ---- */

/* Places the site in the field. If the values of windows do not all fit into their
 * strips, they are listed in a table beside or below the site. A table that is too
 * large is left for the next sheet. */
static void lay_site(struct pp_site_drawing *drawing, struct pp_box field)
{
    double gap = 5.0 * drawing->style.scale;
    fit_site_scale(drawing, field);
    if (figures_fit(drawing))
        return;
    bool beside = field.width > 1.2 * field.height;
    struct pp_box table =
        pp_strip_table_size(drawing, (beside ? 0.95 : 0.35) * field.height);
    drawing->on_next = table.width > (beside ? 0.45 : 1.0) * field.width;
    if (drawing->on_next)
        return;
    drawing->in_table = true;
    if (beside) {
        table.x = field.x + field.width - table.width;
        table.y = field.y;
        field.width -= table.width + gap;
    } else {
        table.x = field.x;
        table.y = field.y + field.height - table.height;
        field.height -= table.height + gap;
    }
    fit_site_scale(drawing, field);
    pp_strip_table_draw(drawing, table);
    drawing->names_before = !names_fit(drawing);
}

static void draw_site_sheet(struct pp_site_drawing *drawing, struct pp_canvas *canvas)
{
    const struct pp_style *style = &drawing->style;
    const struct pp_site_sheet *sheet = drawing->sheet;
    struct pp_key keys[8];
    char foot[1024] = "";
    pp_page_say(
        foot, sizeof foot,
        "Figures at windows show the vertical sky component in per cent; that of the "
        "lowest storey is next to the wall. Heights are above the ground.");
    if (sheet->french_m > 0.0)
        pp_page_say(foot, sizeof foot,
                    "Figures for full-height windows are at %g m above the floor, all "
                    "others at the centre of the window.",
                    sheet->french_m);
    if (sheet->cell_count > 0)
        pp_page_say(foot, sizeof foot,
                    "Figures on the plot show the permitted height of each cell in "
                    "metres (darker: higher); the volume is %.0f\u00a0m³. Figures at "
                    "windows are for the site with this envelope.",
                    sheet->cells_m3);
    if (sheet->garden_count > 0)
        pp_page_say(foot, sizeof foot,
                    "Figures in gardens show the share of the area with two hours of "
                    "sun or more on 21 March; target: half [BR209].");
    bool has_former = false;
    for (int i = 0; i < sheet->tree_count; i++)
        has_former |= sheet->trees[i].when == PP_SITE_GONE;
    if (sheet->tree_count > 0)
        pp_site_crowns_say(foot, sizeof foot, has_former);
    if (sheet->has_before)
        pp_page_say(foot, sizeof foot,
                    "A heavy frame marks windows with less than 27\u00a0%% and less "
                    "than 0.8 of the existing value [BR209].");
    struct pp_page page = {sheet->title,
                           sheet->cell_count > 0
                               ? "The largest envelope on the plot, with the vertical "
                                 "sky component of windows, CIE overcast sky"
                               : "Site plan, with the vertical sky component of "
                                 "windows, CIE overcast sky",
                           foot};
    struct pp_box body = pp_page_draw(canvas, style, &page);
    int key_count = gather_keys(sheet, keys);
    double strip = pp_plan_strip_height(style, key_count);
    lay_site(drawing, (struct pp_box){body.x, body.y, body.width,
                                      body.height - strip - 5.0 * style->scale});
    draw_site(drawing);
    pp_plan_strip_draw(
        drawing->cr, style,
        (struct pp_box){body.x, body.y + body.height - strip, body.width, strip},
        drawing->frame.scale, sheet->north_rad, keys, key_count);
}

/* Draws the table on a separate sheet. */
static enum pp_status draw_table_sheet(struct pp_site_drawing *drawing,
                                       struct pp_canvas *canvas, struct pp_error *err)
{
    enum pp_status status = pp_canvas_next_sheet(canvas, err);
    if (status != PP_OK)
        return status;
    const struct pp_page page = {drawing->sheet->title,
                                 "Vertical sky component of windows, CIE overcast sky",
                                 "In per cent. Bold: less than 27\u00a0% and less "
                                 "than 0.8 of the existing value [BR209]."};
    pp_strip_table_draw(drawing, pp_page_draw(canvas, &drawing->style, &page));
    return PP_OK;
}

enum pp_status pp_site_chart_draw(struct pp_canvas *canvas,
                                  const struct pp_site_sheet *sheet,
                                  struct pp_error *err)
{
    struct pp_site_drawing drawing = {.cr = pp_canvas_cairo(canvas),
                                      .style = pp_page_style(canvas),
                                      .sheet = sheet,
                                      .labels = calloc(1, sizeof *drawing.labels)};
    if (!drawing.labels)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    draw_site_sheet(&drawing, canvas);
    if (drawing.on_next && pp_canvas_has_sheets(canvas))
        status = draw_table_sheet(&drawing, canvas, err);
    free(drawing.labels);
    return status;
}
