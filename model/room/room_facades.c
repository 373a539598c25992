/* room_facades.c - see room_facades.h. */
#include "model/room/room_facades.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/geometry/tolerance.h"
#include "model/room/room_parts.h"

static bool outline_is_upright(const struct pp_polygon *outline)
{
    return fabs(outline->normal.z) < 1e-6;
}

static bool has_roof_above(const struct pp_world *world)
{
    for (int i = 0; i < world->opening_count; i++)
        if (!outline_is_upright(&world->openings[i].outer))
            return true;
    return false;
}

static bool has_facade(const struct pp_room *room, const char *wall)
{
    for (int i = 0; i < room->facade_count; i++)
        if (strcmp(room->facades[i].wall, wall) == 0)
            return true;
    return false;
}

/* Appends the facade; removes it again if the room then has mistakes, as when the
 * facade crosses the room. */
static enum pp_status try_facade(struct pp_room *room, struct pp_facade_part facade,
                                 bool *good, struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&room->facades, room->facade_count, sizeof *room->facades, err);
    if (status != PP_OK)
        return status;
    room->facades[room->facade_count++] = facade;
    status = pp_room_is_sound(good, room, err);
    if (!*good)
        room->facade_count--;
    return status;
}

/* True if the wall, extended at its left or right end as seen from outside, would be in
 * front of a window in another wall, round a corner of the house. */
static bool hides_a_window(const struct pp_world *world, const struct pp_surface *wall,
                           bool to_the_right, double reach_m)
{
    const struct pp_vec3 up = {0.0, 0.0, 1.0};
    const struct pp_vec3 along =
        pp_vec_scale(pp_vec_cross(wall->outline.normal, up), to_the_right ? 1.0 : -1.0);
    struct pp_vec3 end = wall->outline.vertices[0];
    for (int i = 1; i < wall->outline.count; i++)
        if (pp_vec_dot(wall->outline.vertices[i], along) > pp_vec_dot(end, along))
            end = wall->outline.vertices[i];
    end = pp_vec_add(end, pp_vec_scale(along, reach_m));
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_polygon *other = &world->openings[i].outer;
        const struct pp_vec3 from = pp_vec_sub(end, other->vertices[0]);
        if (&world->surfaces[world->openings[i].face] != wall
            && outline_is_upright(other)
            && pp_vec_dot(from, other->normal) < -PP_TOUCH_M)
            return true;
    }
    return false;
}

/* Adds a facade to the wall. Tries both sides, then one, then none: a wall cannot
 * extend beyond an inner corner, nor beyond an outer corner if there is a window around
 * it. */
static enum pp_status extend(struct pp_room *room, const struct pp_world *world,
                             const struct pp_surface *wall, double reach_m, double up_m,
                             int *added, struct pp_error *err)
{
    static const double sides[][2] = {{1, 1}, {1, 0}, {0, 1}, {0, 0}};
    const bool blocked[] = {hides_a_window(world, wall, false, reach_m),
                            hides_a_window(world, wall, true, reach_m)};
    struct pp_facade_part facade = {.wall = strdup(wall->name),
                                    .up_m = up_m,
                                    .down_m = reach_m,
                                    .depth_m = NAN,
                                    .reflectance = 0.2};
    if (!facade.wall)
        return pp_fail_memory(err);
    bool good = false;
    enum pp_status status = PP_OK;
    for (size_t i = 0; i < sizeof sides / sizeof *sides && !good && status == PP_OK;
         i++) {
        if ((sides[i][0] > 0.0 && blocked[0]) || (sides[i][1] > 0.0 && blocked[1]))
            continue;
        facade.left_m = sides[i][0] * reach_m;
        facade.right_m = sides[i][1] * reach_m;
        status = try_facade(room, facade, &good, err);
    }
    *added += good;
    if (!good)
        free(facade.wall);
    return status;
}

enum pp_status pp_room_facades_add(struct pp_room *room, const struct pp_world *world,
                                   double reach_m, int *added, struct pp_error *err)
{
    double up_m = has_roof_above(world) ? 0.0 : reach_m;
    enum pp_status status = PP_OK;
    *added = 0;
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        const struct pp_surface *wall = &world->surfaces[world->openings[i].face];
        if (wall->name && outline_is_upright(&wall->outline)
            && !has_facade(room, wall->name))
            status = extend(room, world, wall, reach_m, up_m, added, err);
    }
    return status;
}
