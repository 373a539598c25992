/* plan_frame.c - see plan_frame.h. */
#include "charts/room/plan_frame.h"

#include <math.h>

double pp_plan_frame_wall_mm(const struct pp_style *style)
{
    return 1.3 * style->thick;
}

bool pp_plan_frame_is_shade(const struct pp_surface *surface)
{
    return surface->is_shade && surface->owner >= 0 && surface->role == PP_FREE_SURFACE;
}

/* Adds corners to the extent. Corners more than `most` metres outside the room are
 * moved to that limit. */
static void add_corners(struct pp_bounds2 *outer, const struct pp_room_plan *plan,
                        const struct pp_vec3 *corners, int count, double most)
{
    const struct pp_bounds2 *room = &plan->extent;
    for (int i = 0; i < count; i++)
        pp_bounds2_add(
            outer, fmin(fmax(corners[i].x, room->low[0] - most), room->high[0] + most),
            fmin(fmax(corners[i].y, room->low[1] - most), room->high[1] + most));
}

/* True if the pane is the top of a crown that is nearer to the room than most_m. */
static bool is_crown_near(const struct pp_room_plan *plan,
                          const struct pp_outer_pane *pane, double most_m)
{
    const struct pp_bounds2 *room = &plan->extent;
    if (pane->tree < 0 || !(pane->outline.normal.z > 0.5))
        return false;
    const struct pp_tree *tree = &plan->world->trees[pane->tree];
    double x = fmax(room->low[0] - tree->foot.x, tree->foot.x - room->high[0]);
    double y = fmax(room->low[1] - tree->foot.y, tree->foot.y - room->high[1]);
    return fmax(x, y) - 0.5 * tree->crown_width_m < most_m;
}

/* Extent (m) of the room with the parts drawn outside: reveals, overhangs and balconies
 * of windows, crowns of trees, and facades, which continue for at most 0.5 m. */
static struct pp_bounds2 outer_extent(const struct pp_room_plan *plan)
{
    static const double balcony_m = 2.5, facade_m = 0.5;
    const struct pp_world *world = plan->world;
    struct pp_bounds2 outer = plan->extent;
    for (int i = 0; i < world->opening_count; i++)
        add_corners(&outer, plan, world->openings[i].outer.vertices,
                    world->openings[i].outer.count, balcony_m);
    for (int i = world->face_count; i < world->surface_count; i++)
        if (pp_plan_frame_is_shade(&world->surfaces[i]))
            add_corners(&outer, plan, world->surfaces[i].outline.vertices,
                        world->surfaces[i].outline.count, balcony_m);
    for (int i = 0; i < world->outer_pane_count; i++)
        if (is_crown_near(plan, &world->outer_panes[i], balcony_m))
            add_corners(&outer, plan, world->outer_panes[i].outline.vertices,
                        world->outer_panes[i].outline.count, balcony_m);
    for (int i = 0; i < world->facade_count; i++)
        add_corners(&outer, plan, world->facades[i].corners, 4, facade_m);
    return outer;
}

double pp_plan_frame_walls_mm(const struct pp_room_plan *plan,
                              const struct pp_style *style, enum pp_plan_side side)
{
    const struct pp_bounds2 outer = outer_extent(plan), *room = &plan->extent;
    const double out_m[] = {[PP_PLAN_LEFT] = room->low[0] - outer.low[0],
                            [PP_PLAN_RIGHT] = outer.high[0] - room->high[0],
                            [PP_PLAN_ABOVE] = outer.high[1] - room->high[1],
                            [PP_PLAN_BELOW] = room->low[1] - outer.low[1]};
    return fmax(pp_plan_frame_wall_mm(style), plan->mm_per_m * out_m[side])
           + 0.5 * style->scale;
}

double pp_plan_frame_x(const struct pp_room_plan *plan, double x)
{
    return plan->x + (x - plan->extent.low[0]) * plan->mm_per_m;
}

double pp_plan_frame_y(const struct pp_room_plan *plan, double y)
{
    return plan->y - (y - plan->extent.low[1]) * plan->mm_per_m;
}

void pp_plan_frame_ends(const struct pp_room_plan *plan,
                        const struct pp_polygon *outline, double ends[2][2],
                        double out[2])
{
    struct pp_vec3 right = pp_vec_cross(pp_vec(0, 0, 1), outline->normal);
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < outline->count; i++) {
        double along = pp_vec_dot(right, outline->vertices[i]);
        if (along < low) {
            low = along;
            ends[0][0] = pp_plan_frame_x(plan, outline->vertices[i].x);
            ends[0][1] = pp_plan_frame_y(plan, outline->vertices[i].y);
        }
        if (along > high) {
            high = along;
            ends[1][0] = pp_plan_frame_x(plan, outline->vertices[i].x);
            ends[1][1] = pp_plan_frame_y(plan, outline->vertices[i].y);
        }
    }
    double level = hypot(outline->normal.x, outline->normal.y);
    out[0] = -outline->normal.x / level;
    out[1] = outline->normal.y / level;
}

bool pp_plan_frame_is_in_wall(const struct pp_world *world,
                              const struct pp_opening *opening)
{
    struct pp_vec3 corner = opening->inner.vertices[0];
    return opening->slope_rad >= 75.0 * PP_RAD
           && pp_region_edge_distance(&world->plane, corner.x, corner.y) < 0.05;
}
