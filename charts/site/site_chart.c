/* site_chart.c - see site_chart.h. */
#include "charts/site/site_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "charts/room/contour_lines.h"
#include "charts/room/plan_strip.h"
#include "charts/room/room_plan.h"
#include "charts/sheet/hatch.h"
#include "charts/sheet/labels.h"
#include "charts/sheet/page.h"
#include "charts/site/site_shape.h"
#include "charts/site/sky_bands.h"

struct site_drawing {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_site_sheet *sheet;
    struct pp_room_plan frame; /* of the site's x and y */
    struct pp_labels *labels;
};

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

/* Extent of the rooms and their surroundings; for a plot, of the rooms and the plot. */
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
        for (int k = 0; k < sheet->shapes[i].count; k++) {
            double xy[2] = {sheet->shapes[i].corners[k].x,
                            sheet->shapes[i].corners[k].y};
            for (int d = 0; d < 2; d++)
                xy[d] = fmin(fmax(xy[d], rooms.low[d] - reach), rooms.high[d] + reach);
            pp_bounds2_add(&box, xy[0], xy[1]);
        }
    return box;
}

static struct pp_box frame_box(const struct pp_room_plan *frame)
{
    double width = (frame->extent.high[0] - frame->extent.low[0]) * frame->mm_per_m;
    double height = (frame->extent.high[1] - frame->extent.low[1]) * frame->mm_per_m;
    return (struct pp_box){frame->x, frame->y - height, width, height};
}

/* Largest common scale at which the site fits, with a border for windows' figures. */
static void fit_site_scale(struct site_drawing *drawing, struct pp_box room)
{
    struct pp_room_plan *frame = &drawing->frame;
    double border = 3.0 * drawing->style.scale;
    frame->extent = site_extent(drawing->sheet);
    frame->scale = 20.0;
    for (int i = 0; i < 100; i++) {
        frame->mm_per_m = 1000.0 / frame->scale;
        struct pp_box box = frame_box(frame);
        if (box.width + 2.0 * border <= room.width
            && box.height + 2.0 * border <= room.height)
            break;
        frame->scale = pp_room_plan_usual_scale(frame->scale * 1.001);
    }
    struct pp_box box = frame_box(frame);
    frame->x = room.x + 0.5 * (room.width - box.width);
    frame->y = room.y + 0.5 * (room.height + box.height);
    drawing->labels->field = room;
}

/* ---- existing and proposed shapes ---- */

/* True if it is the name of a room, which shapes of other rooms' outsides have. */
static bool is_room_name(const struct pp_site_sheet *sheet, const char *name)
{
    for (int i = 0; i < sheet->shape_count; i++)
        if (sheet->shapes[i].is_room && sheet->shapes[i].name
            && strcmp(sheet->shapes[i].name, name) == 0)
            return true;
    return false;
}

/* Area of a shape seen from above, and its centroid in `middle`. */
static double covered_m2(const struct pp_site_shape *shape, double middle[2])
{
    double area = 0.0;
    middle[0] = middle[1] = 0.0;
    for (int i = 0; i < shape->count; i++) {
        const struct pp_vec3 *p = &shape->corners[i];
        const struct pp_vec3 *q = &shape->corners[(i + 1) % shape->count];
        area += 0.5 * (p->x * q->y - q->x * p->y);
        middle[0] += p->x / shape->count;
        middle[1] += p->y / shape->count;
    }
    return fabs(area);
}

/* Properties of all shapes with the same name together. */
struct named_thing {
    double area_m2, middle[2]; /* of the largest shape */
    double top_m;
    bool first; /* true for the first shape with the name */
};

static struct named_thing gather_named(const struct pp_site_sheet *sheet, int index)
{
    const struct pp_site_shape *asked = &sheet->shapes[index];
    struct named_thing thing = {.area_m2 = -1.0, .top_m = -INFINITY, .first = true};
    for (int i = 0; i < sheet->shape_count; i++) {
        const struct pp_site_shape *shape = &sheet->shapes[i];
        double middle[2];
        if (!shape->name || shape->is_room || shape->when != asked->when
            || strcmp(shape->name, asked->name) != 0)
            continue;
        thing.first &= i >= index;
        thing.top_m = fmax(thing.top_m, shape->top_m);
        double area = covered_m2(shape, middle);
        if (area > thing.area_m2) {
            thing.area_m2 = area;
            thing.middle[0] = middle[0];
            thing.middle[1] = middle[1];
        }
    }
    return thing;
}

/* Writes name and height, once for all shapes of that name. */
static void name_shape(struct site_drawing *drawing, int index)
{
    const struct pp_site_shape *shape = &drawing->sheet->shapes[index];
    struct pp_box box = frame_box(&drawing->frame);
    char words[96], height[32];
    if (!shape->name || shape->is_room || is_room_name(drawing->sheet, shape->name))
        return;
    const struct named_thing thing = gather_named(drawing->sheet, index);
    if (!thing.first)
        return;
    pp_style_metres(height, sizeof height, thing.top_m - drawing->sheet->ground_m);
    snprintf(words, sizeof words, "%.40s%s\n%s", shape->name,
             shape->when == PP_SITE_NEW    ? ", proposed"
             : shape->when == PP_SITE_GONE ? ", existing"
                                           : "",
             height);
    struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5};
    double x = pp_room_plan_x(&drawing->frame, thing.middle[0]);
    double y = pp_room_plan_y(&drawing->frame, thing.middle[1]);
    bool is_off =
        x < box.x || x > box.x + box.width || y < box.y || y > box.y + box.height;
    if (is_off && drawing->sheet->cell_count > 0)
        return;
    x = fmin(fmax(x, box.x), box.x + box.width);
    y = fmin(fmax(y, box.y), box.y + box.height);
    double line = 1.5 * drawing->style.text[PP_TEXT_SMALL];
    for (int tries = 0; tries < 6; tries++) {
        struct pp_box said =
            pp_lettering_measure(drawing->cr, &drawing->style, &set, x, y, words);
        if (pp_labels_is_free(drawing->labels, said))
            break;
        y += (tries % 2 ? -1.0 : 1.0) * (tries + 1) * line;
    }
    struct pp_box said =
        pp_lettering_draw_on_white(drawing->cr, &drawing->style, &set, x, y, words);
    pp_labels_note_box(drawing->labels, said);
}

/* ---- gardens ---- */

static void draw_garden(struct site_drawing *drawing,
                        const struct pp_site_garden *garden)
{
    cairo_t *cr = drawing->cr;
    const struct pp_style *style = &drawing->style;
    cairo_set_fill_rule(cr, CAIRO_FILL_RULE_WINDING);
    for (int i = 0; i < garden->dark.count; i++)
        pp_contour_lines_path(cr, &drawing->frame, &garden->dark.list[i]);
    pp_hatch_path(cr, frame_box(&drawing->frame), 0.8 * style->scale, style->hair,
                  PP_GREY_LINE);
    double middle[2] = {0.0, 0.0}, dashes[] = {0.3 * style->scale, 0.9 * style->scale};
    cairo_new_path(cr);
    for (int i = 0; i < garden->count; i++) {
        for (int k = 0; k < 2; k++)
            middle[k] += garden->corners[i][k] / garden->count;
        cairo_line_to(cr, pp_room_plan_x(&drawing->frame, garden->corners[i][0]),
                      pp_room_plan_y(&drawing->frame, garden->corners[i][1]));
    }
    cairo_close_path(cr);
    pp_style_line(cr, style->medium, PP_INK);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
    cairo_set_dash(cr, dashes, 2, 0.0);
    cairo_stroke(cr);
    cairo_set_dash(cr, NULL, 0, 0.0);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_BUTT);
    char words[96] = "";
    if (garden->name)
        pp_page_say(words, sizeof words, "%.40s", garden->name);
    if (isfinite(garden->share))
        pp_page_say(words, sizeof words, "%s%.0f\u00a0%%", garden->name ? "\n" : "",
                    100.0 * garden->share);
    struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5};
    if (words[0])
        pp_labels_note_box(drawing->labels,
                           pp_lettering_draw_on_white(
                               cr, style, &set,
                               pp_room_plan_x(&drawing->frame, middle[0]),
                               pp_room_plan_y(&drawing->frame, middle[1]), words));
}

/* ---- a plot ---- */

/* Writes the height in its cell, to a decimetre, to a metre, or not at all, depending
 * on the space. */
static void say_height(struct site_drawing *drawing, const struct pp_site_cell *cell,
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

static void draw_cells(struct site_drawing *drawing)
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
            x[k] = pp_room_plan_x(&drawing->frame, cell->corners[k][0]);
            y[k] = pp_room_plan_y(&drawing->frame, cell->corners[k][1]);
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

/* Draws a strip as long as the window in front of it, the lowest storey next to the
 * wall. */
static void draw_window(struct site_drawing *drawing,
                        const struct pp_site_window *window)
{
    cairo_t *cr = drawing->cr;
    const struct pp_style *style = &drawing->style;
    double deep = 2.6 * style->scale;
    double fx = pp_room_plan_x(&drawing->frame, window->from.x);
    double fy = pp_room_plan_y(&drawing->frame, window->from.y);
    double tx = pp_room_plan_x(&drawing->frame, window->to.x);
    double ty = pp_room_plan_y(&drawing->frame, window->to.y);
    double ox = window->out.x, oy = -window->out.y;
    double near = 0.5 * style->medium + window->storey * deep;
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

    char words[16];
    double turn = atan2(ty - fy, tx - fx);
    if (turn > PP_PI / 2.0 + 1e-6)
        turn -= PP_PI;
    if (turn <= -PP_PI / 2.0 + 1e-6)
        turn += PP_PI;
    struct pp_lettering set = {.size = PP_TEXT_SMALL,
                               .across = 0.5,
                               .down = 0.5,
                               .turn_rad = turn,
                               .grey = pp_sky_bands_is_dark(band) ? 1.0 : PP_INK};
    snprintf(words, sizeof words, "%.1f", 100.0 * window->component);
    struct pp_box size = pp_lettering_measure(cr, style, &set, 0.0, 0.0, words);
    if (size.width < hypot(tx - fx, ty - fy))
        pp_lettering_draw(cr, style, &set, 0.5 * (fx + tx) + (near + 0.5 * deep) * ox,
                          0.5 * (fy + ty) + (near + 0.5 * deep) * oy, words);
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
                 "garden: under 2 h of sun on 21 March");
    }
    return count;
}

static void draw_site(struct site_drawing *drawing)
{
    const struct pp_site_sheet *sheet = drawing->sheet;
    struct pp_box box = frame_box(&drawing->frame);
    cairo_t *cr = drawing->cr;
    cairo_save(cr);
    cairo_rectangle(cr, box.x, box.y, box.width, box.height);
    cairo_clip(cr);
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < sheet->shape_count; i++)
            if ((sheet->shapes[i].when == PP_SITE_GONE) == (pass == 1))
                pp_site_shape_draw(drawing->cr, &drawing->style, &drawing->frame, box,
                                   &sheet->shapes[i]);
    for (int i = 0; i < sheet->garden_count; i++)
        draw_garden(drawing, &sheet->gardens[i]);
    draw_cells(drawing);
    cairo_restore(cr);
    for (int i = 0; i < sheet->window_count; i++)
        draw_window(drawing, &sheet->windows[i]);
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < sheet->shape_count; i++)
            if ((sheet->shapes[i].when == PP_SITE_GONE) == (pass == 1))
                name_shape(drawing, i);
}

static void draw_site_sheet(struct site_drawing *drawing, struct pp_canvas *canvas)
{
    const struct pp_style *style = &drawing->style;
    const struct pp_site_sheet *sheet = drawing->sheet;
    struct pp_key keys[8];
    char foot[768] = "";
    pp_page_say(foot, sizeof foot,
                "Figures in front of windows: vertical sky component in per cent, "
                "lowest storey next to the wall. Heights are above the ground.");
    if (sheet->french_m > 0.0)
        pp_page_say(foot, sizeof foot,
                    "Windows down to the floor: at %g m above the floor; all others at "
                    "their centre.",
                    sheet->french_m);
    if (sheet->cell_count > 0)
        pp_page_say(
            foot, sizeof foot,
            "Plot: permitted height of each cell in metres, darker for higher; "
            "%.0f\u00a0m³ in all. Figures at windows are those with this envelope.",
            sheet->cells_m3);
    if (sheet->garden_count > 0)
        pp_page_say(foot, sizeof foot,
                    "Gardens: share of the area with two hours of sun or more on 21 "
                    "March; target: half [BR209].");
    if (sheet->has_before)
        pp_page_say(foot, sizeof foot,
                    "Heavy frame: under 27\u00a0%% and under 0.8 of the existing value "
                    "[BR209].");
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
    fit_site_scale(drawing, (struct pp_box){body.x, body.y, body.width,
                                            body.height - strip - 5.0 * style->scale});
    draw_site(drawing);
    pp_plan_strip_draw(
        drawing->cr, style,
        (struct pp_box){body.x, body.y + body.height - strip, body.width, strip},
        drawing->frame.scale, sheet->north_rad, keys, key_count);
}

enum pp_status pp_site_chart_draw(struct pp_canvas *canvas,
                                  const struct pp_site_sheet *sheet,
                                  struct pp_error *err)
{
    struct site_drawing drawing = {.cr = pp_canvas_cairo(canvas),
                                   .style = pp_page_style(canvas),
                                   .sheet = sheet,
                                   .labels = calloc(1, sizeof *drawing.labels)};
    if (!drawing.labels)
        return pp_fail_memory(err);
    draw_site_sheet(&drawing, canvas);
    free(drawing.labels);
    return PP_OK;
}
