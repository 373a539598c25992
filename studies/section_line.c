/* section_line.c - finds the line of a section in a room and puts points on it.
 */
#include "studies/section_line.h"

#include <math.h>
#include <stdlib.h>

#include "model/room/position.h"

#include "model/geometry/bounds.h"

/* Spacing of the points along the line (m), at most. */
static const double step_m = 0.25;

bool pp_section_line_is_straight(const struct pp_receiver *receivers, int count)
{
    if (count < 2)
        return false;
    struct pp_vec3 first = receivers[0].position;
    struct pp_vec3 way = pp_vec_sub(receivers[count - 1].position, first);
    double length = pp_vec_length(way);
    for (int i = 0; i < count; i++) {
        struct pp_vec3 to = pp_vec_sub(receivers[i].position, first);
        if (fabs(to.z) > 1e-6 || pp_vec_length(pp_vec_cross(way, to)) > 1e-6 * length)
            return false;
    }
    return length > 1e-6;
}

static const struct pp_opening *largest_window(const struct pp_world *world)
{
    const struct pp_opening *largest = NULL;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        bool upright = fabs(opening->inner.normal.z) < 0.7;
        if (upright && (!largest || opening->inner.area_m2 > largest->inner.area_m2))
            largest = opening;
    }
    return largest;
}

static struct pp_vec3 polygon_middle(const struct pp_polygon *polygon)
{
    struct pp_vec3 sum = pp_vec(0.0, 0.0, 0.0);
    for (int i = 0; i < polygon->count; i++)
        sum = pp_vec_add(sum, polygon->vertices[i]);
    return pp_vec_scale(sum, 1.0 / polygon->count);
}

/* The line's start on the working plane and its direction. */
static void choose_start(const struct pp_world *world, struct pp_vec3 *start,
                         struct pp_vec3 *way)
{
    const struct pp_opening *window = largest_window(world);
    if (window) {
        struct pp_vec3 normal = window->inner.normal;
        *start = polygon_middle(&window->inner);
        *way = pp_vec_unit(pp_vec(normal.x, normal.y, 0.0));
    } else {
        struct pp_bounds3 bounds = pp_position_bounds(world);
        struct pp_vec3 low = bounds.low, high = bounds.high;
        bool along_y = high.y - low.y > high.x - low.x;
        *way = along_y ? pp_vec(0.0, 1.0, 0.0) : pp_vec(1.0, 0.0, 0.0);
        *start = along_y ? pp_vec((low.x + high.x) / 2.0, low.y, 0.0)
                         : pp_vec(low.x, (low.y + high.y) / 2.0, 0.0);
    }
    start->z = world->working_plane_m;
}

/* Length of the line from its start to the end of the room, to a centimetre. */
static double free_length(const struct pp_world *world, struct pp_vec3 start,
                          struct pp_vec3 way)
{
    static const double probe_m = 0.01, furthest_m = 1000.0;
    double length = 0.0;
    while (length < furthest_m
           && pp_position_in_room(world, pp_vec_along(start, length + probe_m, way)))
        length += probe_m;
    return length;
}

enum pp_status pp_section_line(struct pp_study_room *room, struct pp_error *err)
{
    struct pp_vec3 start, way;
    choose_start(room->world, &start, &way);
    double length = free_length(room->world, start, way);
    int count = (int)ceil(length / step_m - 1e-9);
    struct pp_receiver *receivers = calloc((size_t)count + 1, sizeof *receivers);
    if (!receivers)
        return pp_fail_memory(err);

    const struct pp_vec3 up = pp_vec(0.0, 0.0, 1.0);
    int good = 0;
    for (int i = 0; i < count; i++) {
        struct pp_vec3 at = pp_vec_along(start, (i + 0.5) * length / count, way);
        if (!pp_position_receiver_fault(room->world, at, up))
            receivers[good++] = (struct pp_receiver){.position = at, .normal = up};
    }
    if (good < 2) {
        free(receivers);
        return pp_fail(
            err, PP_BAD_INPUT,
            "%s: the room file has no line of points, and the largest window leaves no "
            "room for a line in front of it; expected --points on a line",
            room->file);
    }
    if (room->receivers != room->world->receivers)
        free(room->receivers);
    room->receivers = receivers;
    room->receiver_count = good;
    return PP_OK;
}
