/* section_line.c - finds the line of a section in a room and places points on it. */
#include "studies/section_line.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/geometry/bounds.h"
#include "model/room/position.h"

/* Greatest spacing of the points along the line (m). */
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

enum pp_status pp_section_place_read(struct pp_section_place *place, const char *text,
                                     struct pp_error *err)
{
    *place = (struct pp_section_place){0};
    bool along_x = strncmp(text, "y=", 2) == 0, along_y = strncmp(text, "x=", 2) == 0;
    if (along_x || along_y) {
        place->kind = along_x ? PP_SECTION_AT_Y : PP_SECTION_AT_X;
        return pp_text_parse_number(text + 2, &place->at_m)
                   ? PP_OK
                   : pp_fail(err, PP_BAD_INPUT, "x=M or y=M in metres, such as x=2.1");
    }
    if (!*text || strlen(text) >= sizeof place->opening)
        return pp_fail(err, PP_BAD_INPUT,
                       "x=M or y=M in metres, or the name of a window");
    place->kind = PP_SECTION_THROUGH;
    snprintf(place->opening, sizeof place->opening, "%s", text);
    return PP_OK;
}

static bool is_window(const struct pp_opening *opening)
{
    return fabs(opening->inner.normal.z) < 0.7;
}

/* The largest window (`window` true) or the largest rooflight; NULL: there is none. */
static const struct pp_opening *largest(const struct pp_world *world, bool window)
{
    const struct pp_opening *found = NULL;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        if (is_window(opening) == window
            && (!found || opening->inner.area_m2 > found->inner.area_m2))
            found = opening;
    }
    return found;
}

/* Direction of the room's longer side. */
static struct pp_vec3 longer_side(const struct pp_world *world)
{
    struct pp_bounds3 room = pp_position_bounds(world);
    return room.high.y - room.low.y > room.high.x - room.low.x ? pp_vec(0.0, 1.0, 0.0)
                                                               : pp_vec(1.0, 0.0, 0.0);
}

/* Finds the line through the middle of an opening, along the normal of a window. For a
 * rooflight, the line has the direction of the normal of the largest window or, without
 * windows, of the room's longer side. */
static void start_at_opening(const struct pp_world *world,
                             const struct pp_opening *opening, struct pp_vec3 *start,
                             struct pp_vec3 *way)
{
    const struct pp_opening *window =
        is_window(opening) ? opening : largest(world, true);
    *start = pp_polygon_middle(&opening->inner);
    *way =
        window
            ? pp_vec_unit(pp_vec(window->inner.normal.x, window->inner.normal.y, 0.0))
            : longer_side(world);
}

/* Finds the default line: through the largest window or the largest rooflight,
 * whichever is larger; without openings, through the middle of the room. */
static void start_of_room(const struct pp_world *world, struct pp_vec3 *start,
                          struct pp_vec3 *way)
{
    const struct pp_opening *window = largest(world, true),
                            *rooflight = largest(world, false);
    if (rooflight && (!window || rooflight->inner.area_m2 > window->inner.area_m2))
        window = rooflight;
    if (window) {
        start_at_opening(world, window, start, way);
        return;
    }
    struct pp_bounds3 room = pp_position_bounds(world);
    *way = longer_side(world);
    *start = pp_vec_scale(pp_vec_add(room.low, room.high), 0.5);
}

/* Length of the line from its start to the end of the room, in steps of 1 cm. */
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

/* Moves the start back to the point where the line enters the room. */
static void go_back(const struct pp_world *world, struct pp_vec3 *start,
                    struct pp_vec3 way)
{
    double before = free_length(world, *start, pp_vec_scale(way, -1.0));
    *start = pp_vec_along(*start, -before, way);
}

/* Finds the longest part within the room of a line parallel to the x or y axis. Returns
 * false if there is none. */
static bool start_at(const struct pp_world *world, const struct pp_section_place *place,
                     struct pp_vec3 *start, struct pp_vec3 *way)
{
    static const double probe_m = 0.05;
    struct pp_bounds3 room = pp_position_bounds(world);
    bool along_x = place->kind == PP_SECTION_AT_Y;
    double longest = 0.0, end = along_x ? room.high.x : room.high.y;
    *way = along_x ? pp_vec(1.0, 0.0, 0.0) : pp_vec(0.0, 1.0, 0.0);
    for (double s = (along_x ? room.low.x : room.low.y) + 0.5 * probe_m; s < end;
         s += probe_m) {
        struct pp_vec3 at = pp_vec(along_x ? s : place->at_m, along_x ? place->at_m : s,
                                   world->working_plane_m);
        if (!pp_position_in_room(world, at))
            continue;
        go_back(world, &at, *way);
        double length = free_length(world, at, *way);
        if (length > longest) {
            longest = length;
            *start = at;
        }
        s = fmax(s, (along_x ? at.x : at.y) + length);
    }
    return longest > 0.0;
}

/* Finds start and direction of the line. PP_BAD_INPUT if the position is outside the
 * room, or no opening has the given name. */
static enum pp_status find_start(const struct pp_study_room *room,
                                 const struct pp_section_place *place,
                                 struct pp_vec3 *start, struct pp_vec3 *way,
                                 struct pp_error *err)
{
    const struct pp_world *world = room->world;
    if (place->kind == PP_SECTION_AT_X || place->kind == PP_SECTION_AT_Y) {
        struct pp_bounds3 bounds = pp_position_bounds(world);
        bool x = place->kind == PP_SECTION_AT_X;
        if (!start_at(world, place, start, way))
            return pp_fail(err, PP_BAD_INPUT,
                           "%s: --cut %s=%g is outside the room; expected %g to %g",
                           room->file, x ? "x" : "y", place->at_m,
                           x ? bounds.low.x : bounds.low.y,
                           x ? bounds.high.x : bounds.high.y);
        return PP_OK;
    }
    const struct pp_opening *through = NULL;
    for (int i = 0; i < world->opening_count; i++)
        if (place->kind == PP_SECTION_THROUGH
            && strcmp(world->openings[i].label, place->opening) == 0)
            through = &world->openings[i];
    if (place->kind == PP_SECTION_THROUGH && !through)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: --cut: no window is called \"%s\"; expected x=M, y=M or "
                       "the name of a window",
                       room->file, place->opening);
    if (through)
        start_at_opening(world, through, start, way);
    else
        start_of_room(world, start, way);
    start->z = world->working_plane_m;
    if (pp_position_in_room(world, *start))
        go_back(world, start, *way);
    return PP_OK;
}

enum pp_status pp_section_line(struct pp_study_room *room,
                               const struct pp_section_place *place,
                               struct pp_error *err)
{
    struct pp_vec3 start, way;
    enum pp_status status = find_start(room, place, &start, &way, err);
    if (status != PP_OK)
        return status;
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
            place->kind == PP_SECTION_OF_ROOM
                ? "%s: the points are not on one straight line, and a section "
                  "through the largest window has no space for two points; use "
                  "--points with points on a straight line, or --cut"
                : "%s: the section at --cut has no space for two points; "
                  "expected another place",
            room->file);
    }
    if (room->receivers != room->world->receivers)
        free(room->receivers);
    room->receivers = receivers;
    room->receiver_count = good;
    return PP_OK;
}
