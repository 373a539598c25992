/* elevation_chart.c - see elevation_chart.h. */
#include "charts/site/elevation_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "charts/room/contour_lines.h"
#include "charts/room/plan_strip.h"
#include "charts/room/room_elevation.h"
#include "charts/room/room_plan.h"
#include "charts/sheet/page.h"
#include "charts/site/site_crowns.h"
#include "charts/site/sky_bands.h"

enum { LABELS_MOST = 1000 };

struct elevation_drawing {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_elevation_sheet *sheet;
    double scale;                      /* denominator of the scale: 200 for 1:200 */
    struct pp_box labels[LABELS_MOST]; /* written so far */
    int label_count;
};

/* ---- positions on paper ---- */

/* Plan frame used for an elevation: its x and y are u and v of the wall. x, y: position
 * on paper of the low corner. */
static struct pp_room_plan frame_of(const struct elevation_drawing *drawing,
                                    const struct pp_site_elevation *elevation, double x,
                                    double y)
{
    struct pp_room_plan frame = {
        .scale = drawing->scale, .mm_per_m = 1000.0 / drawing->scale, .x = x, .y = y};
    for (int k = 0; k < 2; k++) {
        frame.extent.low[k] = elevation->low[k];
        frame.extent.high[k] = elevation->high[k];
    }
    return frame;
}

static double width_mm(const struct elevation_drawing *drawing,
                       const struct pp_site_elevation *elevation)
{
    return (elevation->high[0] - elevation->low[0]) * 1000.0 / drawing->scale;
}

static double height_mm(const struct elevation_drawing *drawing,
                        const struct pp_site_elevation *elevation)
{
    return (elevation->high[1] - elevation->low[1]) * 1000.0 / drawing->scale;
}

/* ---- one elevation ---- */

static void trace_region(cairo_t *cr, const struct pp_room_plan *frame,
                         const struct pp_region *region)
{
    for (int r = 0; r < region->count; r++) {
        cairo_new_sub_path(cr);
        for (int i = 0; i < region->rings[r].count; i++)
            cairo_line_to(cr, pp_plan_frame_x(frame, region->rings[r].xy[i][0]),
                          pp_plan_frame_y(frame, region->rings[r].xy[i][1]));
        cairo_close_path(cr);
    }
}

/* Fills the bands in order of decreasing sky component. Each band covers part of the
 * bands drawn before. */
static void fill_wall(struct elevation_drawing *drawing,
                      const struct pp_room_plan *frame,
                      const struct pp_elevation_wall *wall)
{
    cairo_t *cr = drawing->cr;
    cairo_save(cr);
    trace_region(cr, frame, &wall->outline);
    cairo_clip(cr);
    pp_sky_bands_colour(cr, PP_SITE_LEVELS, true);
    cairo_paint(cr);
    cairo_set_fill_rule(cr, CAIRO_FILL_RULE_WINDING);
    for (int band = PP_SITE_LEVELS - 1; band >= 0; band--) {
        for (int i = 0; i < wall->below.count; i++)
            if (wall->below.list[i].level == pp_site_sheet_levels[band])
                pp_contour_lines_path(cr, frame, &wall->below.list[i]);
        pp_sky_bands_colour(cr, band, true);
        cairo_fill(cr);
    }
    cairo_restore(cr);
}

static void draw_wall(struct elevation_drawing *drawing,
                      const struct pp_room_plan *frame,
                      const struct pp_elevation_wall *wall)
{
    cairo_t *cr = drawing->cr;
    fill_wall(drawing, frame, wall);
    pp_style_line(cr, drawing->style.hair, PP_GREY_TEXT);
    for (int i = 0; i < wall->lines.count; i++)
        pp_contour_lines_path(cr, frame, &wall->lines.list[i]);
    cairo_stroke(cr);
    pp_style_line(cr, drawing->style.thin, PP_INK);
    trace_region(cr, frame, &wall->outline);
    cairo_stroke(cr);
}

/* Draws doors white with diagonal lines, since no sky component is shown on a door. */
static void draw_doors(struct elevation_drawing *drawing,
                       const struct pp_room_plan *frame,
                       const struct pp_elevation_wall *wall)
{
    cairo_t *cr = drawing->cr;
    for (int i = 0; i < wall->door_count; i++) {
        const struct pp_bounds2 *door = &wall->doors[i];
        double x = pp_plan_frame_x(frame, door->low[0]);
        double y = pp_plan_frame_y(frame, door->high[1]);
        cairo_new_path(cr);
        cairo_rectangle(cr, x, y, pp_plan_frame_x(frame, door->high[0]) - x,
                        pp_plan_frame_y(frame, door->low[1]) - y);
        pp_style_grey(cr, 1.0);
        cairo_fill_preserve(cr);
        pp_style_line(cr, drawing->style.thin, PP_INK);
        pp_room_elevation_hatch(cr, &drawing->style);
    }
}

static struct pp_box window_box(const struct pp_room_plan *frame,
                                const struct pp_site_elevation *elevation,
                                const struct pp_site_window *window)
{
    double from = pp_plan_frame_x(frame, pp_vec_dot(window->from, elevation->right));
    double to = pp_plan_frame_x(frame, pp_vec_dot(window->to, elevation->right));
    double top = pp_plan_frame_y(frame, window->from.z + window->height_m);
    return (struct pp_box){from, top, to - from,
                           pp_plan_frame_y(frame, window->from.z) - top};
}

/* Registers the place of a label. Returns false if it would overlap another label, or
 * if there are too many labels. */
static bool reserve_label(struct elevation_drawing *drawing,
                          const struct pp_lettering *set, double x, double y,
                          const char *words)
{
    struct pp_box box =
        pp_lettering_measure(drawing->cr, &drawing->style, set, x, y, words);
    for (int i = 0; i < drawing->label_count; i++)
        if (pp_lettering_boxes_overlap(box, drawing->labels[i]))
            return false;
    if (drawing->label_count == LABELS_MOST)
        return false;
    drawing->labels[drawing->label_count++] = box;
    return true;
}

/* Writes the component on white over the middle of a window that is too small for it,
 * unless the words would cover those of another window. */
static void say_on_white(struct elevation_drawing *drawing,
                         const struct pp_site_window *window, struct pp_box box)
{
    char words[80];
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5};
    snprintf(words, sizeof words, "%s\n%.1f", window->label, 100.0 * window->component);
    double x = box.x + 0.5 * box.width, y = box.y + 0.5 * box.height;
    if (reserve_label(drawing, &set, x, y, words))
        pp_lettering_draw_on_white(drawing->cr, &drawing->style, &set, x, y, words);
}

/* Writes name, existing and proposed component in the window, as far as there is space.
 * A name that does not fit is written above the window. */
static void say_component(struct elevation_drawing *drawing,
                          const struct pp_site_window *window, struct pp_box box)
{
    char former[16], now[16];
    bool dark = pp_sky_bands_is_dark(pp_sky_bands_of(window->component));
    struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5};
    snprintf(now, sizeof now, "%.1f", 100.0 * window->component);
    snprintf(former, sizeof former, "%.1f", 100.0 * window->before);
    struct pp_box size =
        pp_lettering_measure(drawing->cr, &drawing->style, &set, 0.0, 0.0, now);
    struct pp_box name = pp_lettering_measure(drawing->cr, &drawing->style, &set, 0.0,
                                              0.0, window->label);
    if (size.width > box.width || size.height > box.height) {
        say_on_white(drawing, window, box);
        return;
    }
    bool compared = isfinite(window->before) && box.height > 2.1 * size.height;
    int lines = compared ? 2 : 1;
    bool named = box.height > (lines + 1.2) * size.height && name.width < box.width;
    double x = box.x + 0.5 * box.width;
    double y =
        box.y + 0.5 * box.height - 0.5 * (lines + (named ? 1 : 0) - 1) * size.height;
    set.grey = dark ? 1.0 : PP_INK;
    if (named) {
        pp_lettering_draw(drawing->cr, &drawing->style, &set, x, y, window->label);
        y += size.height;
    } else {
        const struct pp_lettering above = {
            .size = PP_TEXT_SMALL, .across = 0.5, .down = 1.0};
        if (reserve_label(drawing, &above, x, box.y - 0.3, window->label))
            pp_lettering_draw(drawing->cr, &drawing->style, &above, x, box.y - 0.3,
                              window->label);
    }
    if (compared) {
        pp_lettering_draw(drawing->cr, &drawing->style, &set, x, y, former);
        y += size.height;
    }
    set.bold = true;
    pp_lettering_draw(drawing->cr, &drawing->style, &set, x, y, now);
}

static void draw_window(struct elevation_drawing *drawing,
                        const struct pp_room_plan *frame,
                        const struct pp_site_elevation *elevation,
                        const struct pp_site_window *window)
{
    cairo_t *cr = drawing->cr;
    struct pp_box box = window_box(frame, elevation, window);
    cairo_rectangle(cr, box.x, box.y, box.width, box.height);
    pp_sky_bands_colour(cr, pp_sky_bands_of(window->component), false);
    cairo_fill_preserve(cr);
    pp_style_line(
        cr, pp_sky_bands_is_lost(window) ? drawing->style.thick : drawing->style.thin,
        PP_INK);
    cairo_stroke(cr);
}

/* Adds a box, given in u and v, to the path. */
static void trace_box(cairo_t *cr, const struct pp_room_plan *frame,
                      const struct pp_bounds2 *box)
{
    double x = pp_plan_frame_x(frame, box->low[0]);
    double y = pp_plan_frame_y(frame, box->high[1]);
    cairo_rectangle(cr, x, y, pp_plan_frame_x(frame, box->high[0]) - x,
                    pp_plan_frame_y(frame, box->low[1]) - y);
}

/* Draws facades behind the walls in a pale tint, cut off at the edges of the
 * drawing. */
static void draw_elevation_facades(struct elevation_drawing *drawing,
                                   const struct pp_room_plan *frame,
                                   const struct pp_site_elevation *elevation)
{
    cairo_t *cr = drawing->cr;
    const struct pp_bounds2 all = {{elevation->low[0], elevation->low[1]},
                                   {elevation->high[0], elevation->high[1]}};
    cairo_save(cr);
    cairo_new_path(cr);
    trace_box(cr, frame, &all);
    cairo_clip(cr);
    for (int i = 0; i < elevation->facade_count; i++)
        trace_box(cr, frame, &elevation->facades[i]);
    pp_style_grey(cr, 0.96);
    cairo_fill_preserve(cr);
    pp_style_line(cr, drawing->style.thin, PP_GREY_LINE);
    cairo_stroke(cr);
    cairo_restore(cr);
}

/* Draws outlines of balconies and other shading in front of walls and windows. */
static void draw_elevation_shades(struct elevation_drawing *drawing,
                                  const struct pp_room_plan *frame,
                                  const struct pp_site_elevation *elevation)
{
    cairo_new_path(drawing->cr);
    for (int i = 0; i < elevation->shade_count; i++)
        trace_box(drawing->cr, frame, &elevation->shades[i]);
    pp_style_line(drawing->cr, drawing->style.medium, PP_INK);
    cairo_stroke(drawing->cr);
}

/* True if the box does not cover any window or door. */
static bool is_free_of_openings(const struct elevation_drawing *drawing,
                                const struct pp_room_plan *frame,
                                const struct pp_site_elevation *elevation,
                                const struct pp_elevation_wall *wall, struct pp_box box)
{
    for (int i = 0; i < elevation->window_count; i++)
        if (pp_lettering_boxes_overlap(
                box, window_box(frame, elevation,
                                &drawing->sheet->site.windows[elevation->windows[i]])))
            return false;
    for (int i = 0; i < wall->door_count; i++) {
        const struct pp_bounds2 *door = &wall->doors[i];
        double x = pp_plan_frame_x(frame, door->low[0]),
               y = pp_plan_frame_y(frame, door->high[1]);
        struct pp_box place = {x, y, pp_plan_frame_x(frame, door->high[0]) - x,
                               pp_plan_frame_y(frame, door->low[1]) - y};
        if (pp_lettering_boxes_overlap(box, place))
            return false;
    }
    return true;
}

/* Writes the name of the wall's room at the lower edge of the wall, at the leftmost
 * place where it does not cover an opening, or else at the upper edge. A name that does
 * not fit is omitted. */
static void name_elevation_room(struct elevation_drawing *drawing,
                                const struct pp_room_plan *frame,
                                const struct pp_site_elevation *elevation,
                                const struct pp_elevation_wall *wall)
{
    struct pp_bounds2 extent = pp_region_bounds(&wall->outline);
    double gap = 0.8 * drawing->style.scale, step = drawing->style.scale;
    double right = pp_plan_frame_x(frame, extent.high[0]) - gap;
    for (int top = 0; wall->room && top < 2; top++) {
        const struct pp_lettering set = {.size = PP_TEXT_SMALL, .down = 1.0 - top};
        double y = top ? pp_plan_frame_y(frame, extent.high[1]) + 0.5 * gap
                       : pp_plan_frame_y(frame, extent.low[1]) - 0.5 * gap;
        for (double x = pp_plan_frame_x(frame, extent.low[0]) + gap;; x += step) {
            struct pp_box box = pp_lettering_measure(drawing->cr, &drawing->style, &set,
                                                     x, y, wall->room);
            if (!(x + box.width < right))
                break;
            if (!is_free_of_openings(drawing, frame, elevation, wall, box))
                continue;
            pp_lettering_draw(drawing->cr, &drawing->style, &set, x, y, wall->room);
            return;
        }
    }
}

static const struct pp_lettering title_lettering = {
    .size = PP_TEXT_BODY, .bold = true, .down = 1.0};

static void say_title(char *words, size_t room,
                      const struct pp_site_elevation *elevation)
{
    static const char *const ways[] = {"North", "North-east", "East", "South-east",
                                       "South", "South-west", "West", "North-west"};
    int way = (int)floor(elevation->bearing_rad / (PP_PI / 4.0) + 0.5) % 8;
    snprintf(words, room, "%s elevation, %.0f\u00b0%s", ways[way],
             elevation->bearing_rad / PP_RAD,
             elevation->layer > 0 ? ", walls further back" : "");
}

/* Width of the elevation or of its title, whichever is greater. */
static double space_across(const struct elevation_drawing *drawing,
                           const struct pp_site_elevation *elevation)
{
    char title[96];
    say_title(title, sizeof title, elevation);
    struct pp_box box = pp_lettering_measure(drawing->cr, &drawing->style,
                                             &title_lettering, 0.0, 0.0, title);
    return fmax(width_mm(drawing, elevation), box.width);
}

/* Draws an elevation and its title. x, y: upper left corner of the title, on paper. */
static void draw_elevation(struct elevation_drawing *drawing,
                           const struct pp_site_elevation *elevation, double x,
                           double y)
{
    cairo_t *cr = drawing->cr;
    const struct pp_style *style = &drawing->style;
    double head = 1.6 * style->text[PP_TEXT_BODY];
    struct pp_room_plan frame =
        frame_of(drawing, elevation, x, y + head + height_mm(drawing, elevation));
    char title[96];
    say_title(title, sizeof title, elevation);
    pp_lettering_draw(cr, style, &title_lettering, x, y + head - style->scale, title);
    draw_elevation_facades(drawing, &frame, elevation);
    for (int i = 0; i < elevation->wall_count; i++)
        draw_wall(drawing, &frame, &elevation->walls[i]);
    for (int i = 0; i < elevation->wall_count; i++)
        draw_doors(drawing, &frame, &elevation->walls[i]);
    for (int i = 0; i < elevation->window_count; i++)
        draw_window(drawing, &frame, elevation,
                    &drawing->sheet->site.windows[elevation->windows[i]]);
    pp_site_crowns_draw_front(cr, style, &frame, elevation, &drawing->sheet->site);
    for (int i = 0; i < elevation->window_count; i++) {
        const struct pp_site_window *window =
            &drawing->sheet->site.windows[elevation->windows[i]];
        say_component(drawing, window, window_box(&frame, elevation, window));
    }
    draw_elevation_shades(drawing, &frame, elevation);
    for (int i = 0; i < elevation->wall_count; i++)
        name_elevation_room(drawing, &frame, elevation, &elevation->walls[i]);
    double ground = pp_plan_frame_y(&frame, drawing->sheet->site.ground_m);
    pp_style_line(cr, style->thick, PP_INK);
    cairo_move_to(cr, x - 2.0 * style->scale, ground);
    cairo_line_to(cr, x + width_mm(drawing, elevation) + 2.0 * style->scale, ground);
    cairo_stroke(cr);
}

/* ---- the sheet ---- */

/* Places the elevations in rows, from the upper left corner of the box. If `drawn` is
 * false, only checks the space. Returns true if they fit. */
static bool flow(struct elevation_drawing *drawing, struct pp_box box, bool drawn)
{
    const struct pp_style *style = &drawing->style;
    double head = 1.6 * style->text[PP_TEXT_BODY], gap = 9.0 * style->scale;
    double x = box.x + 2.0 * style->scale, y = box.y, row = 0.0;
    bool fits = true;
    for (int i = 0; i < drawing->sheet->count; i++) {
        const struct pp_site_elevation *elevation = &drawing->sheet->elevations[i];
        double width = space_across(drawing, elevation);
        double height = head + height_mm(drawing, elevation);
        if (row > 0.0 && x + width > box.x + box.width) {
            y += row + gap;
            x = box.x + 2.0 * style->scale;
            row = 0.0;
        }
        fits &= x + width <= box.x + box.width && y + height <= box.y + box.height;
        if (drawn)
            draw_elevation(drawing, elevation, x, y);
        x += width + gap;
        row = fmax(row, height);
    }
    return fits;
}

static void find_scale(struct elevation_drawing *drawing, struct pp_box box)
{
    drawing->scale = 20.0;
    for (int i = 0; i < 100 && !flow(drawing, box, false); i++)
        drawing->scale = pp_room_plan_usual_scale(drawing->scale * 1.001);
}

static void say_elevation_foot(const struct elevation_drawing *drawing, char *foot,
                               size_t room)
{
    const struct pp_site_sheet *site = &drawing->sheet->site;
    pp_page_say(
        foot, room,
        "Figures are in per cent, for the centre of the outer face of each window%s.",
        site->has_before ? "; existing values are above them, in light type" : "");
    pp_page_say(foot, room, "A label that would cover another is omitted.");
    if (site->french_m > 0.0)
        pp_page_say(foot, room,
                    "Figures for full-height windows are at %g m above the floor.",
                    site->french_m);
    if (site->has_before)
        pp_page_say(foot, room,
                    "A heavy frame marks windows with less than 27\u00a0%% and less "
                    "than 0.8 of the existing value.");
    int crowns = 0;
    for (int i = 0; i < drawing->sheet->count; i++)
        crowns += drawing->sheet->elevations[i].crown_count;
    if (crowns > 0)
        pp_site_crowns_say(foot, room, false);
    pp_page_say(
        foot, room,
        "With 27\u00a0%% or more, conventional window design usually gives reasonable "
        "daylight. With 15 to 27\u00a0%%, larger windows or changes to the room layout "
        "are usually needed. With 5 to 15\u00a0%%, adequate daylight is very difficult "
        "to achieve, and below 5\u00a0%% often impossible [BR209].");
}

static void draw_elevation_sheet(struct elevation_drawing *drawing,
                                 struct pp_canvas *canvas)
{
    const struct pp_style *style = &drawing->style;
    const struct pp_elevation_sheet *sheet = drawing->sheet;
    struct pp_key keys[PP_SKY_BANDS];
    char foot[1280] = "";
    say_elevation_foot(drawing, foot, sizeof foot);
    struct pp_page page = {sheet->site.title,
                           "Vertical sky component on external walls and at their "
                           "windows, CIE overcast sky",
                           foot};
    struct pp_box body = pp_page_draw(canvas, style, &page);
    pp_sky_bands_keys(keys);
    double strip = pp_plan_strip_height(style, PP_SKY_BANDS);
    struct pp_box field = {body.x, body.y, body.width,
                           body.height - strip - 5.0 * style->scale};
    find_scale(drawing, field);
    flow(drawing, field, true);
    pp_plan_strip_draw(
        drawing->cr, style,
        (struct pp_box){body.x, body.y + body.height - strip, body.width, strip},
        drawing->scale, NAN, keys, PP_SKY_BANDS);
}

enum pp_status pp_elevation_chart_draw(struct pp_canvas *canvas,
                                       const struct pp_elevation_sheet *sheet,
                                       struct pp_error *err)
{
    (void)err;
    struct elevation_drawing drawing = {
        .cr = pp_canvas_cairo(canvas), .style = pp_page_style(canvas), .sheet = sheet};
    draw_elevation_sheet(&drawing, canvas);
    return PP_OK;
}
