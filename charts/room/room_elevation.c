/* room_elevation.c - draws outlines of a wall and its openings, a dashed horizon, and a
 * cross. */
#include "charts/room/room_elevation.h"

#include <math.h>

#include "charts/room/device_drawing.h"

/* Coordinates of a point in the plane of the wall (m), from the foot of the
 * perpendicular from the eye. */
static void elevation_xy(const struct pp_room_elevation *elevation,
                         struct pp_vec3 point, double xy[2])
{
    struct pp_vec3 v = pp_vec_sub(point, elevation->eye);
    xy[0] = pp_vec_dot(v, elevation->first->along);
    xy[1] = pp_vec_dot(v, elevation->first->up);
}

void pp_room_elevation_init(struct pp_room_elevation *elevation,
                            const struct pp_world *world,
                            const struct pp_opening *opening, struct pp_vec3 eye)
{
    const struct pp_polygon *outline = &world->surfaces[opening->face].outline;
    *elevation = (struct pp_room_elevation){
        .world = world, .first = opening, .eye = eye, .extent = pp_bounds2_empty()};
    elevation->distance_m =
        fabs(pp_vec_dot(pp_vec_sub(outline->vertices[0], eye), opening->inner.normal));
    pp_bounds2_add(&elevation->extent, 0.0, 0.0);
    for (int i = 0; i < outline->count; i++) {
        double xy[2];
        elevation_xy(elevation, outline->vertices[i], xy);
        pp_bounds2_add(&elevation->extent, xy[0], xy[1]);
    }
}

void pp_room_elevation_place(const struct pp_room_elevation *elevation,
                             struct pp_vec3 point, double *x, double *y)
{
    double xy[2];
    elevation_xy(elevation, point, xy);
    *x = elevation->x + xy[0] * elevation->mm_per_m;
    *y = elevation->y - xy[1] * elevation->mm_per_m;
}

static void trace_outline(cairo_t *cr, const struct pp_room_elevation *elevation,
                          const struct pp_polygon *outline)
{
    cairo_new_sub_path(cr);
    for (int i = 0; i < outline->count; i++) {
        double xy[2];
        elevation_xy(elevation, outline->vertices[i], xy);
        cairo_line_to(cr, elevation->x + xy[0] * elevation->mm_per_m,
                      elevation->y - xy[1] * elevation->mm_per_m);
    }
    cairo_close_path(cr);
}

void pp_room_elevation_hatch(cairo_t *cr, const struct pp_style *style)
{
    double x0, y0, x1, y1, apart = 2.0 * style->scale;
    cairo_path_extents(cr, &x0, &y0, &x1, &y1);
    cairo_save(cr);
    cairo_stroke_preserve(cr);
    cairo_clip(cr);
    for (double x = x0 - (y1 - y0); x < x1; x += apart) {
        cairo_move_to(cr, x, y1);
        cairo_line_to(cr, x + (y1 - y0), y0);
    }
    cairo_stroke(cr);
    cairo_restore(cr);
}

/* Draws the doors and dados of the wall. */
static void draw_covers(cairo_t *cr, const struct pp_style *style,
                        const struct pp_room_elevation *elevation)
{
    const struct pp_world *world = elevation->world;
    pp_style_line(cr, style->thin, PP_INK);
    for (int i = world->face_count; i < world->surface_count; i++) {
        const struct pp_surface *cover = &world->surfaces[i];
        if (cover->role != PP_COVER || cover->owner != elevation->first->face)
            continue;
        trace_outline(cr, elevation, &cover->outline);
        pp_room_elevation_hatch(cr, style);
    }
}

void pp_room_elevation_draw(cairo_t *cr, const struct pp_style *style,
                            const struct pp_room_elevation *elevation)
{
    const struct pp_world *world = elevation->world;
    double scale = elevation->mm_per_m, arm = 2.0 * style->scale;
    const double dashes[] = {3.0 * style->scale, 1.2 * style->scale};
    trace_outline(cr, elevation, &world->surfaces[elevation->first->face].outline);
    pp_style_line(cr, style->thick, PP_INK);
    cairo_stroke(cr);
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].face == elevation->first->face) {
            trace_outline(cr, elevation, &world->openings[i].inner);
            pp_device_drawing_front(cr, style, &world->openings[i]);
            pp_style_line(cr, style->medium, PP_INK);
            cairo_stroke(cr);
        }
    draw_covers(cr, style, elevation);
    pp_style_line(cr, style->thin, PP_INK);
    cairo_set_dash(cr, dashes, 2, 0.0);
    cairo_move_to(cr, elevation->x + elevation->extent.low[0] * scale, elevation->y);
    cairo_line_to(cr, elevation->x + elevation->extent.high[0] * scale, elevation->y);
    cairo_stroke(cr);
    cairo_set_dash(cr, NULL, 0, 0.0);
    cairo_move_to(cr, elevation->x - arm, elevation->y);
    cairo_line_to(cr, elevation->x + arm, elevation->y);
    cairo_move_to(cr, elevation->x, elevation->y - arm);
    cairo_line_to(cr, elevation->x, elevation->y + arm);
    pp_style_line(cr, style->medium, PP_INK);
    cairo_stroke(cr);
}
