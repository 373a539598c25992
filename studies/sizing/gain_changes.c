/* gain_changes.c - changes finishes, glass, windows and surroundings. Each change is
 * made to a copy of the room.
 */
#include "studies/sizing/gain_changes.h"

#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "studies/sizing/window_number.h"
#include "studies/sizing/window_sizes.h"
#include "model/light/glazings.h"

/* Reflectances of light finishes: white ceiling paint, light walls, a light floor. The
 * values were chosen, not measured. */
static const double light_ceiling = 0.85, light_walls = 0.7, light_floor = 0.4;

#define DESCRIBE(gain, ...) snprintf((gain)->change, sizeof(gain)->change, __VA_ARGS__)

/* ---- Finishes ---- */

/* Changes the faces of one role whose reflectance is lower than `wanted` to that
 * reflectance. */
static enum pp_status lighten(struct pp_room **changed, struct pp_gain *gain,
                              const struct pp_room *room, const struct pp_world *world,
                              enum pp_role role, double wanted, const char *name,
                              struct pp_error *err)
{
    double darkest = 1.0, lightest = 0.0;
    for (int i = 0; i < world->face_count; i++)
        if (world->surfaces[i].role == role) {
            darkest = fmin(darkest, world->surfaces[i].front);
            lightest = fmax(lightest, world->surfaces[i].front);
        }
    if (darkest >= wanted)
        return PP_OK;
    DESCRIBE(gain, "%s with a reflectance of %g instead of %g%s", name, wanted, darkest,
             lightest > darkest ? " or more" : "");
    enum pp_status status = pp_room_copy(changed, room, err);
    if (status == PP_OK)
        pp_room_lighten(*changed, role, wanted);
    return status;
}

static enum pp_status lighter_ceiling(struct pp_room **changed, struct pp_gain *gain,
                                      const struct pp_room *room,
                                      const struct pp_world *world,
                                      struct pp_error *err)
{
    return lighten(changed, gain, room, world, PP_CEILING, light_ceiling, "a ceiling",
                   err);
}

static enum pp_status lighter_walls(struct pp_room **changed, struct pp_gain *gain,
                                    const struct pp_room *room,
                                    const struct pp_world *world, struct pp_error *err)
{
    return lighten(changed, gain, room, world, PP_WALL, light_walls, "walls", err);
}

static enum pp_status lighter_floor(struct pp_room **changed, struct pp_gain *gain,
                                    const struct pp_room *room,
                                    const struct pp_world *world, struct pp_error *err)
{
    return lighten(changed, gain, room, world, PP_FLOOR, light_floor, "a floor", err);
}

/* ---- Glass ---- */

/* Least value over all openings of a member of struct pp_opening (a fraction at
 * `offset`). */
static double least_of(const struct pp_world *world, size_t offset)
{
    double least = 1.0;
    for (int i = 0; i < world->opening_count; i++) {
        const char *opening = (const char *)&world->openings[i];
        least = fmin(least, *(const double *)(opening + offset));
    }
    return least;
}

static enum pp_status cleaner_glass(struct pp_room **changed, struct pp_gain *gain,
                                    const struct pp_room *room,
                                    const struct pp_world *world, struct pp_error *err)
{
    double least = least_of(world, offsetof(struct pp_opening, maintenance));
    if (least >= 1.0)
        return PP_OK;
    DESCRIBE(gain, "clean glass (maintenance 1 instead of %g)", least);
    enum pp_status status = pp_room_copy(changed, room, err);
    for (int i = 0; status == PP_OK && i < world->opening_count; i++)
        pp_room_set_maintenance(*changed, i, 1.0);
    return status;
}

static enum pp_status thinner_frames(struct pp_room **changed, struct pp_gain *gain,
                                     const struct pp_room *room,
                                     const struct pp_world *world, struct pp_error *err)
{
    double least = least_of(world, offsetof(struct pp_opening, frame_factor));
    if (least >= 1.0)
        return PP_OK;
    DESCRIBE(gain, "frames half as wide (frame factor %.3g instead of %g)",
             0.5 * (1.0 + least), least);
    enum pp_status status = pp_room_copy(changed, room, err);
    for (int i = 0; status == PP_OK && i < world->opening_count; i++)
        pp_room_set_frame_factor(*changed, i,
                                 0.5 * (1.0 + world->openings[i].frame_factor));
    return status;
}

/* Name of the clear glazing that replaces the glass: single if the glass is one pane
 * and not diffusing, else double. */
static const char *clear_of(const struct pp_glass *glass)
{
    return glass->panes == 1 && !glass->diffusing ? "clear-single" : "clear-double";
}

static enum pp_status clearer_glazing(struct pp_room **changed, struct pp_gain *gain,
                                      const struct pp_room *room,
                                      const struct pp_world *world,
                                      struct pp_error *err)
{
    enum pp_status status = pp_room_copy(changed, room, err);
    int count = 0;
    const char *last = "";
    for (int i = 0; status == PP_OK && i < world->opening_count; i++) {
        const struct pp_glass *glass = &world->openings[i].glass;
        const char *name = clear_of(glass);
        struct pp_glass clear = pp_glazings_glass(pp_glazings_find(name));
        if (glass->panes == 0 || glass->diffuse > 0.99 * clear.diffuse)
            continue;
        pp_room_set_glass(*changed, i, clear);
        if (count++ == 0)
            DESCRIBE(gain, "%s glazing (diffuse transmittance %.2f instead of %.2f)",
                     name, clear.diffuse, glass->diffuse);
        else if (strcmp(last, name) != 0)
            DESCRIBE(gain, "clear glazing in all openings");
        last = name;
    }
    if (count == 0) {
        pp_room_destroy(*changed);
        *changed = NULL;
    }
    return status;
}

/* ---- Windows ---- */

/* Lists the indices of all windows. The caller frees *windows. */
static enum pp_status windows_of(int **windows, int *count, const struct pp_room *room,
                                 struct pp_error *err)
{
    int all = pp_room_opening_count(room);
    *count = 0;
    *windows = malloc(((size_t)all + 1) * sizeof **windows);
    if (!*windows)
        return pp_fail_memory(err);
    for (int i = 0; i < all; i++)
        if (pp_room_opening_at(room, i).kind == PP_WINDOW)
            (*windows)[(*count)++] = i;
    return PP_OK;
}

/* Enlarges all windows by a number of steps of one kind of change, or as far as
 * possible. *changed remains NULL if no window can be enlarged. */
static enum pp_status enlarge(struct pp_room **changed, const struct pp_room *room,
                              enum pp_size_change change, int steps,
                              struct pp_error *err)
{
    struct pp_window_sizes *sizes = NULL;
    int *windows, count;
    enum pp_status status = windows_of(&windows, &count, room, err);
    if (status == PP_OK && count > 0)
        status = pp_window_sizes_create(&sizes, room, change, windows, count, err);
    if (status == PP_OK && sizes) {
        int now = pp_window_sizes_now(sizes), last = pp_window_sizes_count(sizes) - 1;
        int step = steps < last - now ? now + steps : last;
        if (step > now)
            status = pp_window_sizes_room(changed, sizes, step, err);
    }
    pp_window_sizes_destroy(sizes);
    free(windows);
    return status;
}

/* Greatest distance (m) by which a head has moved up, for a change of heads, or a sill
 * has moved down, for any other change. */
static double largest_move(const struct pp_room *room, const struct pp_room *changed,
                           enum pp_size_change change)
{
    double most = 0.0;
    for (int i = 0; i < pp_room_opening_count(room); i++) {
        struct pp_opening_place a = pp_room_opening_at(room, i).place;
        struct pp_opening_place b = pp_room_opening_at(changed, i).place;
        double by = change == PP_CHANGE_HEAD
                        ? b.sill_m + b.height_m - a.sill_m - a.height_m
                        : a.sill_m - b.sill_m;
        most = fmax(most, by);
    }
    return most;
}

static enum pp_status higher_heads(struct pp_room **changed, struct pp_gain *gain,
                                   const struct pp_room *room,
                                   const struct pp_world *world, struct pp_error *err)
{
    (void)world;
    enum pp_status status = enlarge(changed, room, PP_CHANGE_HEAD, INT_MAX, err);
    if (*changed) {
        double by = largest_move(room, *changed, PP_CHANGE_HEAD);
        DESCRIBE(gain, "window heads as high as possible, up to %.2g m higher", by);
    }
    return status;
}

/* Lowers sills, at most to the working plane, because glass below the working plane
 * adds little light there. */
static enum pp_status lower_sills(struct pp_room **changed, struct pp_gain *gain,
                                  const struct pp_room *room,
                                  const struct pp_world *world, struct pp_error *err)
{
    double least = INFINITY;
    for (int i = 0; i < pp_room_opening_count(room); i++) {
        struct pp_room_opening opening = pp_room_opening_at(room, i);
        if (opening.kind == PP_WINDOW)
            least = fmin(least, opening.place.sill_m - world->working_plane_m);
    }
    if (!(least > 0.02) || isinf(least))
        return PP_OK;
    enum pp_status status =
        enlarge(changed, room, PP_CHANGE_SILL, (int)round(least / PP_SIZE_GRID_M), err);
    if (*changed) {
        double by = largest_move(room, *changed, PP_CHANGE_SILL);
        DESCRIBE(gain, "sills nearer to the working plane, up to %.2g m lower", by);
    }
    return status;
}

/* Total width of all windows (m). */
static double width_of(const struct pp_room *room)
{
    double sum = 0.0;
    for (int i = 0; i < pp_room_opening_count(room); i++) {
        struct pp_room_opening opening = pp_room_opening_at(room, i);
        sum += opening.kind == PP_WINDOW ? opening.place.width_m : 0.0;
    }
    return sum;
}

static enum pp_status wider_windows(struct pp_room **changed, struct pp_gain *gain,
                                    const struct pp_room *room,
                                    const struct pp_world *world, struct pp_error *err)
{
    (void)world;
    double widest = 0.0;
    for (int i = 0; i < pp_room_opening_count(room); i++) {
        struct pp_room_opening opening = pp_room_opening_at(room, i);
        if (opening.kind == PP_WINDOW)
            widest = fmax(widest, opening.place.width_m);
    }
    /* Widens the widest window by a quarter of its width, and the others in
     * proportion. */
    enum pp_status status = enlarge(changed, room, PP_CHANGE_WIDTH,
                                    (int)round(widest / 4.0 / PP_SIZE_GRID_M), err);
    if (*changed)
        DESCRIBE(gain, "windows %.2g m wider in total (%.3g m instead of %.3g m)",
                 width_of(*changed) - width_of(room), width_of(*changed),
                 width_of(room));
    return status;
}

/* ---- an additional window ---- */

/* Index of the window with the largest area; -1: the room has no window. */
static int largest_window(const struct pp_room *room)
{
    int largest = -1;
    double most = 0.0;
    for (int i = 0; i < pp_room_opening_count(room); i++) {
        struct pp_room_opening opening = pp_room_opening_at(room, i);
        double area = opening.place.width_m * opening.place.height_m;
        if (opening.kind == PP_WINDOW && area > most) {
            most = area;
            largest = i;
        }
    }
    return largest;
}

/* Spacing of the positions along the wall that are tried for an additional window
 * (m). */
static const double search_m = 0.1;

/* Copies the room with an additional window like the largest, at the first free
 * position along its wall. *changed is NULL if there is no free position. */
static enum pp_status one_more_window(struct pp_room **changed, struct pp_gain *gain,
                                      const struct pp_room *room,
                                      const struct pp_world *world,
                                      struct pp_error *err)
{
    int like = largest_window(room);
    if (like < 0)
        return PP_OK;
    struct pp_opening_place place = pp_room_opening_at(room, like).place;
    double most = pp_window_number_wall_length(world, like) - place.width_m;
    enum pp_status status = PP_OK;
    bool sound = false;
    for (int i = 0; status == PP_OK && !sound && i * search_m <= most; i++) {
        pp_room_destroy(*changed);
        place.left_m = i * search_m;
        status = pp_room_copy(changed, room, err);
        if (status == PP_OK)
            status = pp_room_repeat_opening(*changed, like, place, err);
        if (status == PP_OK)
            status = pp_room_is_sound(&sound, *changed, err);
    }
    if (!sound) {
        pp_room_destroy(*changed);
        *changed = NULL;
    }
    DESCRIBE(gain, "another window like %.31s beside it, %.3g m by %.3g m",
             world->openings[like].label, place.width_m, place.height_m);
    return status;
}

/* Index of the outer wall without openings that is most nearly opposite to the given
 * face, by more than 120 degrees; -1: none. */
static int opposite_wall(const struct pp_world *world, int face)
{
    struct pp_vec3 n = world->surfaces[face].outline.normal;
    int found = -1;
    double least = -0.5;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_surface *wall = &world->surfaces[i];
        bool taken = false;
        for (int k = 0; k < world->opening_count; k++)
            taken = taken || world->openings[k].face == i;
        double against = pp_vec_dot(n, wall->outline.normal);
        if (wall->role == PP_WALL && wall->name && !wall->is_inner && !taken
            && against < least) {
            least = against;
            found = i;
        }
    }
    return found;
}

static enum pp_status opposite_window(struct pp_room **changed, struct pp_gain *gain,
                                      const struct pp_room *room,
                                      const struct pp_world *world,
                                      struct pp_error *err)
{
    int like = largest_window(room);
    int face = like < 0 ? -1 : opposite_wall(world, world->openings[like].face);
    if (face < 0)
        return PP_OK;
    const char *wall = world->surfaces[face].name;
    struct pp_opening_place place = pp_room_opening_at(room, like).place;
    DESCRIBE(gain,
             "a window of the same size in the opposite wall, %.40s, if that is an "
             "external wall",
             wall);
    enum pp_status status = pp_room_copy(changed, room, err);
    if (status == PP_OK)
        status = pp_room_repeat_opening(*changed, like, place, err);
    if (status == PP_OK)
        status =
            pp_room_set_wall(*changed, pp_room_opening_count(*changed) - 1, wall, err);
    return status;
}

/* ---- Surroundings ---- */

static enum pp_status nothing_outside(struct pp_room **changed, struct pp_gain *gain,
                                      const struct pp_room *room,
                                      const struct pp_world *world,
                                      struct pp_error *err)
{
    int outside = world->skyline_count + world->block_count;
    for (int i = 0; i < world->surface_count; i++)
        outside +=
            world->surfaces[i].role == PP_FREE_SURFACE && !world->surfaces[i].inside;
    if (outside == 0)
        return PP_OK;
    DESCRIBE(gain, "no external obstructions");
    enum pp_status status = pp_room_copy(changed, room, err);
    if (status == PP_OK)
        pp_room_clear_surroundings(*changed, world);
    return status;
}

const struct pp_gain_kind pp_gain_kinds[] = {
    {higher_heads, "low window heads", true},
    {wider_windows, "narrow windows", true},
    {one_more_window, "few windows", true},
    {opposite_window, NULL, true},
    {lower_sills, "high sills", true},
    {clearer_glazing, "glazing with a low transmittance", true},
    {cleaner_glass, "dirty glass", true},
    {thinner_frames, "wide frames", true},
    {lighter_ceiling, "a dark ceiling", true},
    {lighter_walls, "dark walls", true},
    {lighter_floor, "a dark floor", true},
    {nothing_outside, "external obstructions", false},
    {NULL, NULL, false},
};
