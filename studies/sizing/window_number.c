/* window_number.c - places windows at equal distances along their wall, and finds the
 * numbers of windows that are valid for the room. */
#include "studies/sizing/window_number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/room/building.h"

/* Maximum number of windows tried in a wall, which limits the duration of the search.
 * The value was chosen, not measured. */
enum { NUMBER_MOST = 200 };

/* Checks the windows: PP_BAD_INPUT unless they are in the same wall and have the same
 * size and sill height. */
static enum pp_status check_alike(const struct pp_room *room, const int *openings,
                                  int opening_count, struct pp_error *err)
{
    struct pp_room_opening first = pp_room_opening_at(room, openings[0]);
    for (int i = 1; i < opening_count; i++) {
        struct pp_room_opening other = pp_room_opening_at(room, openings[i]);
        if (strcmp(first.wall, other.wall) != 0)
            return pp_fail(
                err, PP_BAD_INPUT,
                "the windows on lines %d and %d are in different walls, but windows "
                "can be added to only one wall; expected --wall %s or --wall %s",
                first.line, other.line, first.wall, other.wall);
        if (first.place.width_m != other.place.width_m
            || first.place.height_m != other.place.height_m
            || first.place.sill_m != other.place.sill_m)
            return pp_fail(err, PP_BAD_INPUT,
                           "the windows on lines %d and %d differ in size or sill "
                           "height, but added windows are copies of one window; "
                           "expected --window LINE",
                           first.line, other.line);
    }
    return PP_OK;
}

double pp_window_number_wall_length(const struct pp_world *world, int opening)
{
    struct pp_vec3 along = world->openings[opening].along;
    const struct pp_polygon *wall =
        &world->surfaces[world->openings[opening].face].outline;
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < wall->count; k++) {
        double at = pp_vec_dot(along, wall->vertices[k]);
        low = fmin(low, at);
        high = fmax(high, at);
    }
    return high - low;
}

/* Length of a wall, for a room whose world does not exist yet. */
static enum pp_status wall_length(double *length_m, const struct pp_room *room,
                                  int index, struct pp_error *err)
{
    struct pp_mistakes mistakes;
    struct pp_world *world = NULL;
    pp_mistakes_init(&mistakes, "room");
    enum pp_status status = pp_world_create(&world, room, &mistakes, err);
    if (status == PP_OK)
        *length_m = pp_window_number_wall_length(world, index);
    pp_world_destroy(world);
    pp_mistakes_clear(&mistakes);
    return status;
}

/* Distance of window i of `number` windows from the start of the wall (m), rounded to a
 * millimetre. */
static double left_of(int i, int number, double width_m, double wall_m)
{
    double left = wall_m * (i + 0.5) / number - 0.5 * width_m;
    return fmax(round(1000.0 * left) / 1000.0, 0.0);
}

enum pp_status pp_window_number_room(struct pp_room **changed,
                                     const struct pp_room *room, const int *openings,
                                     int opening_count, int number,
                                     struct pp_error *err)
{
    double wall_m = 0.0;
    *changed = NULL;
    enum pp_status status = wall_length(&wall_m, room, openings[0], err);
    if (status == PP_OK)
        status = pp_room_copy(changed, room, err);
    struct pp_opening_place place = pp_room_opening_at(room, openings[0]).place;
    for (int i = 0; i < number && number != opening_count && status == PP_OK; i++) {
        place.left_m = left_of(i, number, place.width_m, wall_m);
        if (i < opening_count)
            pp_room_set_place(*changed, openings[i], place);
        else
            status = pp_room_repeat_opening(*changed, openings[opening_count - 1],
                                            place, err);
    }
    for (int i = opening_count - 1; i >= number && status == PP_OK; i--)
        pp_room_remove_opening(*changed, openings[i]);
    if (status != PP_OK) {
        pp_room_destroy(*changed);
        *changed = NULL;
    }
    return status;
}

enum pp_status pp_window_number_choices(int **numbers, int *count,
                                        const struct pp_room *room, const int *openings,
                                        int opening_count, struct pp_error *err)
{
    double wall_m = 0.0;
    *numbers = NULL;
    *count = 0;
    enum pp_status status = check_alike(room, openings, opening_count, err);
    if (status == PP_OK)
        status = wall_length(&wall_m, room, openings[0], err);
    if (status != PP_OK)
        return status;
    double width_m = pp_room_opening_at(room, openings[0]).place.width_m;
    int most = (int)fmin(floor(wall_m / width_m + 1e-6), NUMBER_MOST);
    most = most > opening_count ? most : opening_count;
    *numbers = malloc((size_t)most * sizeof **numbers);
    if (!*numbers)
        return pp_fail_memory(err);
    for (int number = 1; number <= most && status == PP_OK; number++) {
        struct pp_room *changed = NULL;
        bool sound = false;
        status =
            pp_window_number_room(&changed, room, openings, opening_count, number, err);
        if (status == PP_OK)
            status = pp_room_is_sound(&sound, changed, err);
        pp_room_destroy(changed);
        if (sound)
            (*numbers)[(*count)++] = number;
    }
    if (status != PP_OK) {
        free(*numbers);
        *numbers = NULL;
    }
    return status;
}
