/* retained_sky.c - see retained_sky.h. */
#include "studies/sizing/retained_sky.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/text.h"
#include "model/room/world.h"
#include "studies/criteria/windows/vertical_sky.h"
#include "studies/lit_line.h"

static const double next_to_nothing = 1e-6; /* a value before building of at most this
                                             * is treated as 0: nothing need be
                                             * retained */

const char *const pp_retained_sky_words[] = {"vsc", "lit-area", NULL};

static enum pp_status add_retained_place(struct pp_retained_sky *retained,
                                         const struct pp_retained_sky_rule *rule,
                                         const struct pp_world *world, int place,
                                         const struct pp_opening *opening, double value,
                                         struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&retained->list, retained->count, sizeof *retained->list, err);
    if (status != PP_OK)
        return status;
    struct pp_retained_sky_place *due = &retained->list[retained->count++];
    *due = (struct pp_retained_sky_place){
        .place = place, .before = NAN, .now = value, .after = NAN};
    if (opening) {
        due->line = opening->line;
        snprintf(due->label, sizeof due->label, "%s", opening->label);
        due->middle = pp_placement_to_building(
            &world->placement, pp_vertical_sky_point(opening, rule->french_m));
        due->outward = pp_placement_turn(pp_vec_scale(opening->inner.normal, -1.0),
                                         world->placement.rotate_rad);
    }
    if (world->name)
        pp_text_excerpt(due->room, sizeof due->room, world->name);
    if (opening && opening->name)
        pp_text_excerpt(due->window, sizeof due->window, opening->name);
    return PP_OK;
}

static bool is_called(const char *own, const char *wanted)
{
    return !wanted || (own && strcmp(own, wanted) == 0);
}

/* Adds windows to the list. only: consider only the windows on the same line of the
 * file; NULL: all windows. */
static enum pp_status add_retained_windows(struct pp_retained_sky *retained,
                                           const struct pp_retained_sky_rule *rule,
                                           const struct pp_retained_sky_place *only,
                                           const struct pp_world *world, int place,
                                           struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        const struct pp_opening *opening = &world->openings[i];
        double share;
        if (!pp_vertical_sky_is_upright(opening)
            || !is_called(opening->name, rule->window)
            || (only && opening->line != only->line))
            continue;
        status = pp_vertical_sky_at_point(&share, world, opening, rule->french_m, err);
        if (status == PP_OK)
            status =
                add_retained_place(retained, rule, world, place, opening, share, err);
    }
    return status;
}

static enum pp_status add_lit_area(struct pp_retained_sky *retained,
                                   const struct pp_retained_sky_rule *rule,
                                   const struct pp_world *world, int place,
                                   struct pp_error *err)
{
    struct pp_lit_area area;
    enum pp_status status = pp_lit_line_find(&area, world, PP_LIT_NO_SKY, err);
    if (status == PP_OK)
        status =
            add_retained_place(retained, rule, world, place, NULL, area.lit_m2, err);
    pp_lit_area_clear(&area);
    return status;
}

/* Adds the windows of a room that the rule selects, or the room's lit area if the rule
 * selects the room. */
static enum pp_status add_room(struct pp_retained_sky *retained,
                               const struct pp_retained_sky_rule *rule,
                               const struct pp_retained_sky_place *only,
                               struct pp_building *building, int index,
                               struct pp_error *err)
{
    struct pp_mistakes mistakes;
    struct pp_world *world = NULL;
    pp_mistakes_init(&mistakes, "room");
    enum pp_status status =
        pp_world_create(&world, pp_building_room(building, index), &mistakes, err);
    if (status == PP_BAD_INPUT && mistakes.count > 0)
        pp_fail(err, status, "line %d: %s", mistakes.list[0].line,
                mistakes.list[0].text);
    pp_mistakes_clear(&mistakes);
    int place = pp_building_place(building, index);
    if (status == PP_OK && is_called(world->name, rule->room))
        status = rule->of == PP_RETAINED_SKY_VSC
                     ? add_retained_windows(retained, rule, only, world, place, err)
                     : add_lit_area(retained, rule, world, place, err);
    pp_world_destroy(world);
    return status;
}

static enum pp_status add_all(struct pp_retained_sky *retained,
                              const struct pp_retained_sky_rule *rule,
                              const struct pp_retained_sky_place *only,
                              struct pp_building *building, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < pp_building_room_count(building) && status == PP_OK; i++)
        if (!only || pp_building_place(building, i) == only->place)
            status = add_room(retained, rule, only, building, i, err);
    return status;
}

enum pp_status pp_retained_sky_list(struct pp_retained_sky *retained,
                                    const struct pp_retained_sky_rule *rule,
                                    struct pp_building *building, struct pp_error *err)
{
    *retained = (struct pp_retained_sky){0};
    enum pp_status status = add_all(retained, rule, NULL, building, err);
    if (status != PP_OK || retained->count > 0)
        return status;
    return rule->window
               ? pp_fail(err, PP_BAD_INPUT, "no vertical window%s is named \"%.60s\"",
                         rule->room ? " of that room" : "", rule->window)
               : pp_fail(err, PP_BAD_INPUT, "no room has a vertical window");
}

/* Stores the values for the present state of the building in the list, as `before` or
 * as `after`; 0 for a window that does not exist. Rooms and lines have the same order
 * in the list and in the building, and so have the windows on a line. */
static enum pp_status measure_retained_sky(struct pp_retained_sky *retained,
                                           bool before,
                                           const struct pp_retained_sky_rule *rule,
                                           struct pp_building *building,
                                           struct pp_error *err)
{
    struct pp_retained_sky then = {0};
    enum pp_status status = add_all(&then, rule, NULL, building, err);
    for (int i = 0, k = 0; i < retained->count && status == PP_OK; i++) {
        struct pp_retained_sky_place *due = &retained->list[i];
        while (
            k < then.count
            && (then.list[k].place < due->place
                || (then.list[k].place == due->place && then.list[k].line < due->line)))
            k++;
        bool same = k < then.count && then.list[k].place == due->place
                    && then.list[k].line == due->line;
        *(before ? &due->before : &due->after) = same ? then.list[k++].now : 0.0;
    }
    pp_retained_sky_clear(&then);
    return status;
}

enum pp_status pp_retained_sky_before(struct pp_retained_sky *retained,
                                      const struct pp_retained_sky_rule *rule,
                                      struct pp_building *building,
                                      struct pp_error *err)
{
    return measure_retained_sky(retained, true, rule, building, err);
}

enum pp_status pp_retained_sky_after(struct pp_retained_sky *retained,
                                     const struct pp_retained_sky_rule *rule,
                                     struct pp_building *building, struct pp_error *err)
{
    return measure_retained_sky(retained, false, rule, building, err);
}

enum pp_status pp_retained_sky_after_one(struct pp_retained_sky *retained, int number,
                                         const struct pp_retained_sky_rule *rule,
                                         struct pp_building *building,
                                         struct pp_error *err)
{
    struct pp_retained_sky_place *due = &retained->list[number];
    struct pp_retained_sky then = {0};
    int alike = 0; /* number of earlier windows on the same line */
    while (alike < number && due[-alike - 1].place == due->place
           && due[-alike - 1].line == due->line)
        alike++;
    enum pp_status status = add_all(&then, rule, due, building, err);
    due->after = alike < then.count ? then.list[alike].now : 0.0;
    pp_retained_sky_clear(&then);
    return status;
}

double pp_retained_sky_surplus_of(const struct pp_retained_sky_place *due,
                                  const struct pp_retained_sky_rule *rule)
{
    return due->before > next_to_nothing
               ? due->after / fmin(rule->keep * due->before, rule->enough) - 1.0
               : INFINITY;
}

double pp_retained_sky_surplus(const struct pp_retained_sky *retained,
                               const struct pp_retained_sky_rule *rule, int *deciding)
{
    double least = INFINITY;
    *deciding = -1;
    for (int i = 0; i < retained->count; i++) {
        double own = pp_retained_sky_surplus_of(&retained->list[i], rule);
        if (own < least) {
            least = own;
            *deciding = i;
        }
    }
    return least;
}

void pp_retained_sky_clear(struct pp_retained_sky *retained)
{
    free(retained->list);
    *retained = (struct pp_retained_sky){0};
}
