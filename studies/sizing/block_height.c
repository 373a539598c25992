/* block_height.c - see block_height.h. */
#include "studies/sizing/block_height.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "methods/exact/exterior.h"
#include "model/base/array.h"
#include "model/base/text.h"
#include "model/room/world.h"

enum { STEPS_MOST = 60 };
static const double share_tolerance = 1e-6, height_tolerance_m = 1e-5;
static const double lowest_m = 0.002; /* nothing, and yet a block */
static const double no_sky = 1e-6;    /* a window with less before keeps nothing */

static bool is_upright(const struct pp_opening *opening)
{
    return fabs(opening->slope_rad - PP_PI / 2.0) < 1.0 * PP_RAD;
}

static bool counts(const struct pp_opening *opening, const char *window)
{
    return is_upright(opening)
           && (!window || (opening->name && strcmp(opening->name, window) == 0));
}

/* Sky components of the windows of one room: to those that are there, in `field`; or,
 * with `add`, to new ones. *next: the place of the room's first. */
static enum pp_status look_at_room(struct pp_block_height *found, bool add,
                                   size_t field, int *next,
                                   const struct pp_block_height_task *task,
                                   const struct pp_room *room, struct pp_error *err)
{
    struct pp_mistakes mistakes;
    struct pp_world *world = NULL;
    pp_mistakes_init(&mistakes, "room");
    enum pp_status status = pp_world_create(&world, room, &mistakes, err);
    if (status == PP_BAD_INPUT && mistakes.count > 0)
        pp_fail(err, status, "line %d: %s", mistakes.list[0].line,
                mistakes.list[0].text);
    pp_mistakes_clear(&mistakes);
    const struct pp_sky overcast = pp_sky_overcast();
    for (int i = 0; status == PP_OK && i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        if (!counts(opening, task->window))
            continue;
        double share;
        status = pp_exterior_sky_on_plane(&share, world, opening,
                                          pp_vec_scale(opening->inner.normal, -1.0),
                                          &overcast, err);
        if (status == PP_OK && add)
            status = pp_array_append(&found->windows, found->window_count,
                                     sizeof *found->windows, err);
        if (status != PP_OK)
            break;
        struct pp_block_height_window *window = &found->windows[*next];
        if (add) {
            found->window_count++;
            *window =
                (struct pp_block_height_window){.line = opening->line, .before = NAN};
            if (world->name)
                pp_text_excerpt(window->room, sizeof window->room, world->name);
            if (opening->name)
                pp_text_excerpt(window->window, sizeof window->window, opening->name);
        }
        ++*next;
        *(double *)((char *)window + field) = share;
    }
    pp_world_destroy(world);
    return status;
}

#define FIELD(member) offsetof(struct pp_block_height_window, member)

/* All rooms of the proposed state, with the block so high. */
static enum pp_status look(struct pp_block_height *found, bool add, size_t field,
                           const struct pp_block_height_task *task, double height_m,
                           struct pp_error *err)
{
    struct pp_building *building = task->building;
    pp_building_set_block_height(building, task->block, height_m);
    int next = 0;
    enum pp_status status = pp_building_set_state(building, PP_STATE_PROPOSED, err);
    for (int i = 0; i < pp_building_room_count(building) && status == PP_OK; i++)
        status = look_at_room(found, add, field, &next, task,
                              pp_building_room(building, i), err);
    return status;
}

/* The windows as they are before, by line, which stays the same in both states. */
static enum pp_status look_before(struct pp_block_height *found,
                                  const struct pp_block_height_task *task,
                                  struct pp_error *err)
{
    if (!pp_building_has_states(task->building))
        return look(found, false, FIELD(before), task, lowest_m, err);
    struct pp_block_height then = {0};
    int next = 0;
    enum pp_status status =
        pp_building_set_state(task->building, PP_STATE_EXISTING, err);
    for (int i = 0; i < pp_building_room_count(task->building) && status == PP_OK; i++)
        status = look_at_room(&then, true, FIELD(now), &next, task,
                              pp_building_room(task->building, i), err);
    /* A window that is not there before has nothing to keep. Windows of one line follow
     * one another alike in both. */
    for (int i = 0, k = 0; i < found->window_count; i++) {
        while (k < then.window_count && then.windows[k].line < found->windows[i].line)
            k++;
        bool same =
            k < then.window_count && then.windows[k].line == found->windows[i].line;
        found->windows[i].before = same ? then.windows[k++].now : 0.0;
    }
    free(then.windows);
    return status;
}

/* The least, over the windows, of what a window has over its due, less 1; by `after`. */
static double surplus(struct pp_block_height *found, double keep)
{
    double least = INFINITY;
    found->deciding = -1;
    for (int i = 0; i < found->window_count; i++) {
        const struct pp_block_height_window *window = &found->windows[i];
        if (!(window->before > no_sky))
            continue;
        double own = window->after / (keep * window->before) - 1.0;
        if (own < least) {
            least = own;
            found->deciding = i;
        }
    }
    return least;
}

static enum pp_status surplus_at(double *value, struct pp_block_height *found,
                                 const struct pp_block_height_task *task,
                                 double height_m, struct pp_error *err)
{
    enum pp_status status = look(found, false, FIELD(after), task, height_m, err);
    *value = surplus(found, task->keep);
    return status;
}

/* Between `low_m`, where every window has its due, and `high_m`, where one has not. */
static enum pp_status narrow(struct pp_block_height *found,
                             const struct pp_block_height_task *task, double low_m,
                             double at_low, double high_m, double at_high,
                             struct pp_error *err)
{
    enum pp_status status = PP_OK;
    int side = 0;
    for (int step = 0; step < STEPS_MOST && status == PP_OK; step++) {
        double middle = low_m + (high_m - low_m) * at_low / (at_low - at_high), value;
        status = surplus_at(&value, found, task, middle, err);
        found->height_m = middle;
        if (fabs(value) < share_tolerance || high_m - low_m < height_tolerance_m)
            break;
        if (value > 0.0) {
            low_m = middle;
            at_low = value;
            at_high *= side > 0 ? 0.5 : 1.0;
            side = 1;
        } else {
            high_m = middle;
            at_high = value;
            at_low *= side < 0 ? 0.5 : 1.0;
            side = -1;
        }
    }
    return status;
}

enum pp_status pp_block_height_find(struct pp_block_height *found,
                                    const struct pp_block_height_task *task,
                                    struct pp_error *err)
{
    *found = (struct pp_block_height){
        .now_m = pp_building_block_height(task->building, task->block),
        .height_m = NAN,
        .deciding = -1};
    double at_low = 0.0, at_high = 0.0;
    enum pp_status status = look(found, true, FIELD(now), task, found->now_m, err);
    if (status == PP_OK && found->window_count == 0)
        status =
            task->window
                ? pp_fail(err, PP_BAD_INPUT, "no upright window is named \"%.60s\"",
                          task->window)
                : pp_fail(err, PP_BAD_INPUT, "no room of it has an upright window");
    if (status == PP_OK)
        status = look_before(found, task, err);
    if (status == PP_OK)
        status = surplus_at(&at_high, found, task, task->most_m, err);
    if (status == PP_OK && !(at_high < 0.0)) {
        found->verdict = PP_BLOCK_HEIGHT_ANY;
        found->height_m = task->most_m;
        return PP_OK;
    }
    if (status == PP_OK)
        status = surplus_at(&at_low, found, task, lowest_m, err);
    if (status == PP_OK && at_low < 0.0) {
        found->verdict = PP_BLOCK_HEIGHT_NONE;
        return PP_OK;
    }
    if (status == PP_OK)
        status = narrow(found, task, lowest_m, at_low, task->most_m, at_high, err);
    return status;
}

void pp_block_height_clear(struct pp_block_height *found)
{
    free(found->windows);
    *found = (struct pp_block_height){0};
}
