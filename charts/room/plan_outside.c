/* plan_outside.c - see plan_outside.h. */
#include "charts/room/plan_outside.h"

#include <math.h>

/* Draws the outer faces of walls that have a facade at the height of the cut. */
static void draw_facades(cairo_t *cr, const struct pp_style *style,
                         const struct pp_room_plan *plan)
{
    const struct pp_world *world = plan->world;
    pp_style_line(cr, style->medium, PP_INK);
    for (int i = 0; i < world->facade_count; i++) {
        const struct pp_vec3 *corners = world->facades[i].corners;
        if (corners[0].z > world->working_plane_m
            || corners[3].z < world->working_plane_m)
            continue;
        cairo_move_to(cr, pp_plan_frame_x(plan, corners[0].x),
                      pp_plan_frame_y(plan, corners[0].y));
        cairo_line_to(cr, pp_plan_frame_x(plan, corners[1].x),
                      pp_plan_frame_y(plan, corners[1].y));
    }
    cairo_stroke(cr);
}

static bool is_upright(const struct pp_polygon *outline)
{
    return fabs(outline->normal.z) < 1e-3;
}

/* Sets a thin pen, dashed for objects above the cut. */
static void set_pen(cairo_t *cr, const struct pp_style *style, bool above)
{
    double dashes[] = {1.4 * style->scale, 0.8 * style->scale};
    pp_style_line(cr, style->thin, PP_GREY_LINE);
    if (above)
        cairo_set_dash(cr, dashes, 2, 0.0);
}

/* Traces a horizontal surface as an outline, and a vertical surface as a line. */
static void trace_shade(cairo_t *cr, const struct pp_room_plan *plan,
                        const struct pp_polygon *outline)
{
    if (is_upright(outline)) {
        double ends[2][2], out[2];
        pp_plan_frame_ends(plan, outline, ends, out);
        cairo_move_to(cr, ends[0][0], ends[0][1]);
        cairo_line_to(cr, ends[1][0], ends[1][1]);
        return;
    }
    for (int k = 0; k < outline->count; k++)
        cairo_line_to(cr, pp_plan_frame_x(plan, outline->vertices[k].x),
                      pp_plan_frame_y(plan, outline->vertices[k].y));
    cairo_close_path(cr);
}

/* True if a vertical surface stands on the edge of a slab of the same window, like a
 * parapet. Only the outline of the slab is then drawn. */
static bool is_on_slab(const struct pp_world *world, const struct pp_surface *upright)
{
    struct pp_vec3 middle = pp_polygon_middle(&upright->outline);
    for (int i = world->face_count; i < world->surface_count; i++) {
        const struct pp_surface *slab = &world->surfaces[i];
        if (!pp_plan_frame_is_shade(slab) || slab->owner != upright->owner
            || is_upright(&slab->outline))
            continue;
        for (int k = 0; k < slab->outline.count; k++) {
            struct pp_vec3 a = slab->outline.vertices[k];
            struct pp_vec3 b = slab->outline.vertices[(k + 1) % slab->outline.count];
            double length = hypot(b.x - a.x, b.y - a.y);
            double off =
                ((b.x - a.x) * (middle.y - a.y) - (b.y - a.y) * (middle.x - a.x))
                / length;
            if (fabs(off) < 1e-3)
                return true;
        }
    }
    return false;
}

static void draw_shades(cairo_t *cr, const struct pp_style *style,
                        const struct pp_room_plan *plan)
{
    const struct pp_world *world = plan->world;
    for (int i = world->face_count; i < world->surface_count; i++) {
        const struct pp_polygon *outline = &world->surfaces[i].outline;
        double low = INFINITY;
        if (!pp_plan_frame_is_shade(&world->surfaces[i])
            || (is_upright(outline) && is_on_slab(world, &world->surfaces[i])))
            continue;
        for (int k = 0; k < outline->count; k++)
            low = fmin(low, outline->vertices[k].z);
        trace_shade(cr, plan, outline);
        set_pen(cr, style, low > world->working_plane_m);
        cairo_stroke(cr);
    }
}

/* Draws the crowns of trees, which are dashed above the cut. */
static void draw_crowns(cairo_t *cr, const struct pp_style *style,
                        const struct pp_room_plan *plan)
{
    const struct pp_world *world = plan->world;
    for (int i = 0; i < world->outer_pane_count; i++) {
        const struct pp_outer_pane *pane = &world->outer_panes[i];
        if (pane->tree < 0 || !(pane->outline.normal.z > 0.5))
            continue;
        const struct pp_tree *tree = &world->trees[pane->tree];
        trace_shade(cr, plan, &pane->outline);
        set_pen(cr, style, tree->foot.z + tree->crown_base_m > world->working_plane_m);
        cairo_stroke(cr);
    }
}

/* Draws the furniture that the working plane does not cut. Furniture that it cuts is
 * drawn with the plan. */
static void draw_furniture(cairo_t *cr, const struct pp_style *style,
                           const struct pp_room_plan *plan)
{
    const struct pp_world *world = plan->world;
    for (int i = 0; i < world->fitting_count; i++) {
        const struct pp_fitting *fitting = &world->fittings[i];
        bool above = fitting->low_m >= world->working_plane_m;
        if (!above && fitting->high_m > world->working_plane_m)
            continue;
        for (int k = 0; k < fitting->corner_count; k++)
            cairo_line_to(cr, pp_plan_frame_x(plan, fitting->xy[k][0]),
                          pp_plan_frame_y(plan, fitting->xy[k][1]));
        cairo_close_path(cr);
        set_pen(cr, style, above);
        cairo_stroke(cr);
    }
}

void pp_plan_outside_draw(cairo_t *cr, const struct pp_style *style,
                          const struct pp_room_plan *plan)
{
    double left = pp_plan_frame_walls_mm(plan, style, PP_PLAN_LEFT),
           right = pp_plan_frame_walls_mm(plan, style, PP_PLAN_RIGHT),
           above = pp_plan_frame_walls_mm(plan, style, PP_PLAN_ABOVE),
           below = pp_plan_frame_walls_mm(plan, style, PP_PLAN_BELOW);
    double top = pp_plan_frame_y(plan, plan->extent.high[1]);
    cairo_save(cr);
    cairo_new_path(cr);
    cairo_rectangle(
        cr, plan->x - left, top - above,
        (plan->extent.high[0] - plan->extent.low[0]) * plan->mm_per_m + left + right,
        (plan->extent.high[1] - plan->extent.low[1]) * plan->mm_per_m + above + below);
    cairo_clip(cr);
    draw_facades(cr, style, plan);
    draw_shades(cr, style, plan);
    draw_crowns(cr, style, plan);
    draw_furniture(cr, style, plan);
    cairo_restore(cr);
}
