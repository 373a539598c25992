/* lumen_scope.c - tests whether room, windows and rooflights are within the scope of
 * the lumen method. */
#include "methods/lumen/lumen_scope.h"

#include <stddef.h>

#include "methods/refusals.h"

/* Lengths (m) and cosines up to this count as 0. */
static const double small = 1e-3;

/* Permitted deviations of a window from the table's window; chosen here, not
 * published. */
static const double sill_within_m = 0.30, level_within_m = 0.05;
static const double reveal_most = 0.2; /* largest depth of a reveal divided by the
                                        * window's height */

static const struct pp_surface *floor_of(const struct pp_world *world)
{
    for (int i = 0; i < world->face_count; i++)
        if (world->surfaces[i].role == PP_FLOOR)
            return &world->surfaces[i];
    return NULL;
}

/* True if the room has one rectangular floor, one ceiling, both level, and four
 * vertical walls. */
static bool is_box(const struct pp_world *world)
{
    int of_role[PP_ROLE_COUNT] = {0};
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_surface *face = &world->surfaces[i];
        double z = face->role == PP_WALL ? 0.0 : face->role == PP_FLOOR ? 1.0 : -1.0;
        if (fabs(face->outline.normal.z - z) > small)
            return false;
        of_role[face->role]++;
    }
    if (of_role[PP_FLOOR] != 1 || of_role[PP_CEILING] != 1 || of_role[PP_WALL] != 4)
        return false;
    const struct pp_polygon *floor = &floor_of(world)->outline;
    for (int i = 0; i < floor->count; i++) {
        struct pp_vec3 v = floor->vertices[i], next = floor->vertices[(i + 1) % 4];
        struct pp_vec3 last = floor->vertices[(i + 3) % 4];
        if (floor->count != 4
            || fabs(pp_vec_dot(pp_vec_unit(pp_vec_sub(next, v)),
                               pp_vec_unit(pp_vec_sub(last, v))))
                   > small)
            return false;
    }
    return true;
}

const char *pp_lumen_scope_refuses_room(const struct pp_world *world)
{
    if (!is_box(world))
        return "the tables apply only to a rectangular plan with a horizontal ceiling";
    if (!world->is_empty)
        return "the tables apply to empty rooms; this room has objects in it";
    double floor = floor_of(world)->front;
    if (floor < 0.10 - small || floor > 0.50 + small)
        return "the tables apply to floor reflectances of 0.1 to 0.5 (they were "
               "calculated for 0.3)";
    return pp_refusals_if_luminous(world);
}

bool pp_lumen_scope_is_rooflight(const struct pp_opening *opening)
{
    return opening->slope_rad < small;
}

/* The least and greatest coordinate of the polygon along a direction. */
static void polygon_range(double range[2], const struct pp_polygon *polygon,
                          struct pp_vec3 along)
{
    range[0] = INFINITY;
    range[1] = -INFINITY;
    for (int i = 0; i < polygon->count; i++) {
        double place = pp_vec_dot(polygon->vertices[i], along);
        range[0] = fmin(range[0], place);
        range[1] = fmax(range[1], place);
    }
}

/* Returns the reason if another window in the same wall is at another height, or a
 * window in another wall is not opposite; else NULL. */
static const char *refuses_neighbours(const struct pp_world *world,
                                      const struct pp_opening *opening)
{
    double own[2], other[2];
    polygon_range(own, &opening->inner, opening->up);
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *neighbour = &world->openings[i];
        if (pp_lumen_scope_is_rooflight(neighbour))
            continue;
        if (neighbour->face != opening->face) {
            if (pp_vec_dot(neighbour->inner.normal, opening->inner.normal)
                > small - 1.0)
                return "is neither in the same wall as the other windows nor in the "
                       "opposite wall";
            continue;
        }
        polygon_range(other, &neighbour->inner, opening->up);
        if (fabs(own[0] - other[0]) > level_within_m
            || fabs(own[1] - other[1]) > level_within_m)
            return "has a sill or head at a different height from the windows beside "
                   "it";
    }
    return NULL;
}

/* True if the stretch of wall beside the opening is longer than is allowed for windows
 * spread along the wall. way: side, 1 or -1 along the opening. */
static bool leaves_wall_bare(const struct pp_world *world,
                             const struct pp_opening *opening, double way)
{
    struct pp_vec3 along = pp_vec_scale(opening->along, way);
    double own[2], wall[2], other[2];
    polygon_range(own, &opening->inner, along);
    polygon_range(wall, &world->surfaces[opening->face].outline, along);
    double gap_m = wall[1] - own[1], most_m = opening->height_m;
    for (int i = 0; i < world->opening_count; i++) {
        if (world->openings[i].face != opening->face || &world->openings[i] == opening)
            continue;
        polygon_range(other, &world->openings[i].inner, along);
        if (other[0] > own[1] - small && other[0] - own[1] < gap_m) {
            gap_m = other[0] - own[1];
            most_m = 2.0 * opening->height_m;
        }
    }
    return gap_m > most_m + small;
}

/* True if no point of the plan is farther from the nearest rooflight than the height of
 * the ceiling above the working plane. Tested on a grid of 32 by 32. */
static bool is_spread(const struct pp_world *world)
{
    enum { GRID = 32 };
    const struct pp_polygon *floor = &floor_of(world)->outline;
    struct pp_vec3 corner = floor->vertices[0];
    struct pp_vec3 a = pp_vec_sub(floor->vertices[1], corner);
    struct pp_vec3 b = pp_vec_sub(floor->vertices[3], corner);
    double reach_m = world->height_m - world->working_plane_m;
    for (int k = 0; k <= (GRID + 1) * (GRID + 1) - 1; k++) {
        struct pp_vec3 p =
            pp_vec_along(pp_vec_along(corner, (double)(k / (GRID + 1)) / GRID, a),
                         (double)(k % (GRID + 1)) / GRID, b);
        double nearest_m = INFINITY;
        for (int i = 0; i < world->opening_count; i++) {
            const struct pp_opening *opening = &world->openings[i];
            if (!pp_lumen_scope_is_rooflight(opening))
                continue;
            double along[2], up[2];
            polygon_range(along, &opening->inner, opening->along);
            polygon_range(up, &opening->inner, opening->up);
            double x = pp_vec_dot(p, opening->along), y = pp_vec_dot(p, opening->up);
            double dx = fmax(fmax(along[0] - x, x - along[1]), 0.0);
            double dy = fmax(fmax(up[0] - y, y - up[1]), 0.0);
            nearest_m = fmin(nearest_m, hypot(dx, dy));
        }
        if (nearest_m > reach_m + small)
            return false;
    }
    return true;
}

static const char *refuses_window(const struct pp_world *world,
                                  const struct pp_opening *opening)
{
    double z[2];
    if (!opening->rectangle || fabs(opening->up.z - 1.0) > small)
        return "is not a vertical rectangle, the only shape that the tables cover";
    if (opening->glass.diffusing)
        return "has diffusing glass, but the tables are for clear glass";
    if (opening->reveal_m > reveal_most * opening->height_m + small)
        return "has a reveal deeper than one fifth of its height";
    polygon_range(z, &opening->inner, opening->up);
    if (fabs(z[0] - world->working_plane_m) > sill_within_m + small)
        return "has its sill more than 0.30 m above or below the working plane";
    const char *why = refuses_neighbours(world, opening);
    if (why)
        return why;
    if (leaves_wall_bare(world, opening, 1.0) || leaves_wall_bare(world, opening, -1.0))
        return "leaves too much wall without glass; the tables are for evenly spread "
               "windows";
    return NULL;
}

const char *pp_lumen_scope_refuses_opening(const struct pp_world *world,
                                           const struct pp_opening *opening)
{
    if (pp_lumen_scope_is_rooflight(opening))
        return is_spread(world)
                   ? NULL
                   : "is not one of a set of rooflights spread evenly over the ceiling";
    if (pp_refusals_unless_vertical(opening))
        return "slopes, but the tables are for vertical windows and horizontal "
               "rooflights";
    return refuses_window(world, opening);
}

void pp_lumen_scope_room_size(double *width_m, double *depth_m,
                              const struct pp_world *world,
                              const struct pp_opening *opening)
{
    const struct pp_polygon *floor = &floor_of(world)->outline;
    bool top = pp_lumen_scope_is_rooflight(opening);
    struct pp_vec3 along =
        top ? pp_vec_unit(pp_vec_sub(floor->vertices[1], floor->vertices[0]))
            : opening->along;
    struct pp_vec3 away =
        top ? pp_vec_unit(pp_vec_sub(floor->vertices[3], floor->vertices[0]))
            : opening->inner.normal;
    double range[2];
    polygon_range(range, floor, along);
    *width_m = range[1] - range[0];
    polygon_range(range, floor, away);
    *depth_m = range[1] - range[0];
}

double pp_lumen_scope_ceiling_reflectance(const struct pp_world *world)
{
    for (int i = 0; i < world->face_count; i++)
        if (world->surfaces[i].role == PP_CEILING)
            return world->surfaces[i].front;
    return NAN;
}

double pp_lumen_scope_wall_reflectance(const struct pp_world *world, int left_out)
{
    double sum = 0.0, area_m2 = 0.0;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_surface *face = &world->surfaces[i];
        if (face->role != PP_WALL || i == left_out)
            continue;
        sum += face->front * face->outline.area_m2;
        area_m2 += face->outline.area_m2;
    }
    for (int i = world->face_count; i < world->surface_count; i++) {
        const struct pp_surface *cover = &world->surfaces[i];
        if (cover->role == PP_COVER && cover->owner != left_out)
            sum += (cover->front - world->surfaces[cover->owner].front)
                   * cover->outline.area_m2;
    }
    return sum / area_m2;
}
