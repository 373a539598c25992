/* note_drawings.c - fits the drawings of charts/room into a narrow column. */
#include "charts/note/note_drawings.h"

#include <math.h>
#include <stdio.h>

#include "charts/room/room_elevation.h"
#include "charts/room/room_plan.h"
#include "charts/section/room_section.h"

/* Draws the caption below a drawing, from its left edge. If `drawn` is false, only
 * measures. Returns the height. */
static double caption(cairo_t *cr, const struct pp_style *style, struct pp_box box,
                      double y, const char *words, bool drawn)
{
    const struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT, .width = box.width};
    return (drawn ? pp_lettering_draw : pp_lettering_measure)(cr, style, &set, box.x, y,
                                                              words)
        .height;
}

static double draw_note_plan(cairo_t *cr, const struct pp_style *style,
                             const struct pp_report *report, struct pp_box box)
{
    struct pp_room_plan plan = {0};
    struct pp_vec3 point = report->receivers[0].position;
    char words[96];
    pp_room_plan_fit(&plan, report->world, style, box.width, box.height);
    pp_room_plan_place(&plan, style, box, true);
    double bottom = plan.y + pp_room_plan_border(&plan, style, PP_PLAN_BELOW);
    pp_room_plan_draw(cr, style, &plan);
    pp_style_marker(cr, style, PP_DISC, pp_plan_frame_x(&plan, point.x),
                    pp_plan_frame_y(&plan, point.y));
    snprintf(words, sizeof words, "Plan 1:%g, with the point", plan.scale);
    return bottom - box.y + caption(cr, style, box, bottom, words, true);
}

static double draw_section(cairo_t *cr, const struct pp_style *style,
                           const struct pp_report *report,
                           const struct pp_section_cut *cut, struct pp_box box)
{
    double outside = 5.0 * style->scale, head = 3.0 * style->scale;
    struct pp_room_section section = {.world = report->world,
                                      .cut = cut,
                                      .report = report,
                                      .no_sights = true,
                                      .no_caption = true};
    char words[128];
    pp_room_section_fit(&section, style, box.width - 2.0 * outside, box.height);
    double length = cut->length_m * section.mm_per_m;
    section.x = box.x + 0.5 * (box.width - length);
    section.y = box.y + head;
    section.left_mm = section.right_mm = outside;
    section.head_mm = head;
    pp_room_section_draw(cr, style, &section);
    snprintf(words, sizeof words,
             "Section 1:%g through the point, %.2f\u00a0m above the floor",
             1000.0 / section.mm_per_m, cut->height_m);
    double used = head + section.height_mm + style->scale;
    return used + caption(cr, style, box, box.y + used, words, true);
}

enum pp_status pp_note_drawings_room(double *height, cairo_t *cr,
                                     const struct pp_style *style,
                                     const struct pp_report *report, struct pp_box box,
                                     struct pp_error *err)
{
    struct pp_section_cut cut;
    enum pp_status status =
        pp_section_cut_init(&cut, report->world, report->receivers, 1, err);
    if (status != PP_OK)
        return status;
    double gap = 4.0 * style->scale;
    struct pp_box part = {box.x, box.y, box.width, 0.45 * box.height};
    *height = draw_note_plan(cr, style, report, part) + gap;
    part.y += *height;
    part.height = box.height - *height;
    *height += draw_section(cr, style, report, &cut, part) + gap;
    pp_section_cut_clear(&cut);
    return PP_OK;
}

/* Tints the area of the opening. */
static void tint_opening(cairo_t *cr, const struct pp_room_elevation *elevation,
                         const struct pp_opening *opening)
{
    cairo_new_path(cr);
    for (int i = 0; i < opening->inner.count; i++) {
        struct pp_vec3 v = pp_vec_sub(opening->inner.vertices[i], elevation->eye);
        cairo_line_to(
            cr,
            elevation->x + pp_vec_dot(v, elevation->first->along) * elevation->mm_per_m,
            elevation->y - pp_vec_dot(v, elevation->first->up) * elevation->mm_per_m);
    }
    cairo_close_path(cr);
    pp_style_grey(cr, PP_GREY_GRID);
    cairo_fill(cr);
}

double pp_note_drawings_opening(cairo_t *cr, const struct pp_style *style,
                                const struct pp_report *report, int index,
                                struct pp_box box, bool drawn)
{
    const struct pp_opening *opening = &report->world->openings[index];
    const char *wall = report->world->surfaces[opening->face].name;
    struct pp_room_elevation elevation;
    char words[224];
    pp_room_elevation_init(&elevation, report->world, opening,
                           report->receivers[0].position);
    const struct pp_bounds2 *extent = &elevation.extent;
    double border = style->scale, wide = extent->high[0] - extent->low[0],
           high = extent->high[1] - extent->low[1];
    double scale = pp_room_plan_usual_scale(
        1000.0
        / fmin((box.width - 2.0 * border) / wide, (box.height - 2.0 * border) / high));
    elevation.mm_per_m = 1000.0 / scale;
    elevation.x = box.x + 0.5 * (box.width - wide * elevation.mm_per_m)
                  - extent->low[0] * elevation.mm_per_m;
    elevation.y = box.y + border + extent->high[1] * elevation.mm_per_m;
    if (drawn) {
        tint_opening(cr, &elevation, opening);
        pp_room_elevation_draw(cr, style, &elevation);
    }
    snprintf(words, sizeof words,
             "Window %s, %s%.40s from inside, 1:%g; the cross is opposite the point, "
             "%.2f\u00a0m away",
             opening->label, wall ? "wall " : "its face", wall ? wall : "", scale,
             elevation.distance_m);
    double used = 2.0 * border + high * elevation.mm_per_m + style->scale;
    return used + caption(cr, style, box, box.y + used, words, drawn);
}
