/* own_world.c - finds the world that each method assumes, and makes these worlds from
 * changed copies of the room. */
#include "studies/research/validation/own_world.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "methods/method.h"
#include "methods/variant.h"
#include "model/base/text.h"
#include "model/room/room.h"
#include "studies/study_report.h"
#include "studies/research/validation/own_skylines.h"

/* Properties by which an assumed world differs from the room's world. The ground of an
 * assumed world is lit by the whole sky. */
struct own_kind {
    double ground_reflectance;
    bool surroundings; /* with the room's own surroundings instead of skylines */
    bool real;         /* identical to the room's world */
};

struct own_world {
    struct own_kind kind;
    bool inside; /* the internally reflected component is simulated as well */
    struct pp_world *world;
    struct pp_report report;
};

struct pp_own_worlds {
    const struct pp_report *room;
    struct pp_own_skylines skylines;
    struct own_world *list;
    int count;
};

/* ---- which world ---- */

/* The method with this name, or the method that has a variant with this name. length:
 * length of the name. */
static const struct pp_method *method_of(const char *name, size_t length,
                                         const struct pp_method_options *options)
{
    for (int i = 0; pp_methods[i]; i++)
        if (pp_text_is_word(pp_methods[i]->name, name, length))
            return pp_methods[i];
    const struct pp_variant_list *variants = options ? options->variants : NULL;
    for (int i = 0; variants && i < variants->count; i++)
        if (pp_text_is_word(variants->list[i].name, name, length))
            return variants->list[i].method;
    return NULL;
}

/* The method that gives a column's component. NULL: no method does, and the component
 * is simulated. */
static const struct pp_method *method_for(const struct pp_own_worlds *worlds,
                                          const struct pp_column *column,
                                          enum pp_component component)
{
    const char *plus = strchr(column->name, '+'), *name = column->name;
    size_t length = plus ? (size_t)(plus - name) : strlen(name);
    if (plus && component == PP_IRC) {
        name = plus + 1;
        length = strlen(name);
    }
    return method_of(name, length, worlds->room->options);
}

static struct own_kind kind_of(const struct pp_own_worlds *worlds,
                               const struct pp_method *method)
{
    double ground = worlds->room->light.ground_reflectance;
    bool direct = method->gives == PP_GIVES_DIRECT;
    return (struct own_kind){.ground_reflectance =
                                 method->own_ground > 0.0 ? method->own_ground : ground,
                             .surroundings = direct || worlds->skylines.as_they_are,
                             .real = method->of_real_room};
}

/* Index of this world in the list; -1: the room's own world. If the world is not in the
 * list yet, the count. */
static int index_of(const struct pp_own_worlds *worlds, struct own_kind kind,
                    enum pp_component component)
{
    const struct pp_report *room = worlds->room;
    bool ground = room->world->ground_is_open
                  && kind.ground_reflectance == room->light.ground_reflectance;
    if (kind.real || (kind.surroundings && (ground || component == PP_SC)))
        return -1;
    for (int i = 0; i < worlds->count; i++)
        if (worlds->list[i].kind.surroundings == kind.surroundings
            && worlds->list[i].kind.ground_reflectance == kind.ground_reflectance)
            return i;
    return worlds->count;
}

const struct pp_report *pp_own_world_of(const struct pp_own_worlds *worlds,
                                        const struct pp_column *column,
                                        enum pp_component component)
{
    const struct pp_method *method = method_for(worlds, column, component);
    int index = method ? index_of(worlds, kind_of(worlds, method), component) : -1;
    return index < 0 || index == worlds->count ? worlds->room
                                               : &worlds->list[index].report;
}

/* ---- making the worlds ---- */

static enum pp_status make_world(struct pp_world **world, const struct pp_room *room,
                                 struct pp_error *err)
{
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "room");
    enum pp_status status = pp_world_create(world, room, &mistakes, err);
    if (status == PP_BAD_INPUT)
        status = pp_fail(err, PP_BAD_INPUT,
                         "the room that a method assumes is not valid: %s",
                         mistakes.count > 0 ? mistakes.list[0].text : "");
    pp_mistakes_clear(&mistakes);
    return status;
}

/* Finds the skylines that replace the obstructions. */
static enum pp_status find_skylines(struct pp_own_worlds *worlds,
                                    const struct pp_room *room, struct pp_error *err)
{
    const struct pp_world *world = worlds->room->world;
    struct pp_room *copy;
    struct pp_world *bare = NULL;
    enum pp_status status = pp_room_copy(&copy, room, err);
    if (status != PP_OK)
        return status;
    pp_room_clear_surroundings(copy, world);
    pp_room_clear_facades(copy);
    status = make_world(&bare, copy, err);
    if (status == PP_OK)
        status = pp_own_skylines_of(&worlds->skylines, world, bare,
                                    &worlds->room->light, err);
    pp_world_destroy(bare);
    pp_room_destroy(copy);
    return status;
}

static enum pp_status make_own_world(struct own_world *own,
                                     const struct pp_own_worlds *worlds,
                                     const struct pp_room *room, struct pp_error *err)
{
    const struct pp_report *report = worlds->room;
    struct pp_room *copy;
    enum pp_status status = pp_room_copy(&copy, room, err);
    if (status != PP_OK)
        return status;
    pp_room_set_ground(copy, own->kind.ground_reflectance, true);
    if (!own->kind.surroundings) {
        pp_room_clear_surroundings(copy, report->world);
        pp_room_clear_facades(copy);
        status = pp_own_skylines_put(&worlds->skylines, copy, err);
    }
    if (status == PP_OK)
        status = make_world(&own->world, copy, err);
    pp_room_destroy(copy);
    own->report = (struct pp_report){.world = own->world,
                                     .light = report->light,
                                     .receivers = report->receivers,
                                     .receiver_count = report->receiver_count,
                                     .finished = true};
    own->report.light.ground_reflectance = own->kind.ground_reflectance;
    return status;
}

/* True if any value in the column can be compared. */
static bool has_figures(const struct pp_column *column, int receiver_count)
{
    bool any = !column->of_all_surfaces && isfinite(column->average.value);
    for (int i = 0; column->points && i < receiver_count; i++)
        any |= isfinite(column->points[i].value);
    return any;
}

/* Adds the world of a column's component, unless it exists already. */
static enum pp_status add_own_world(struct pp_own_worlds *worlds,
                                    const struct pp_room *room,
                                    const struct pp_column *column,
                                    enum pp_component component, struct pp_error *err)
{
    const struct pp_method *method = method_for(worlds, column, component);
    if (!method)
        return PP_OK;
    struct own_kind kind = kind_of(worlds, method);
    int index = index_of(worlds, kind, component);
    if (index < 0)
        return PP_OK;
    struct own_world *own = &worlds->list[index];
    own->inside |= component == PP_IRC;
    if (index < worlds->count)
        return PP_OK;
    worlds->count++;
    own->kind = kind;
    return make_own_world(own, worlds, room, err);
}

enum pp_status pp_own_world_list(struct pp_own_worlds **result,
                                 const struct pp_room *room,
                                 const struct pp_report *report, struct pp_error *err)
{
    struct pp_own_worlds *worlds = calloc(1, sizeof *worlds);
    *result = NULL;
    if (!worlds)
        return pp_fail_memory(err);
    worlds->room = report;
    size_t most = 3 * (size_t)report->column_count + 1;
    worlds->list = calloc(most, sizeof *worlds->list);
    enum pp_status status =
        worlds->list ? find_skylines(worlds, room, err) : pp_fail_memory(err);
    for (int i = 0; status == PP_OK && i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        if (!has_figures(column, report->receiver_count))
            continue;
        for (int k = PP_SC; status == PP_OK && k <= PP_IRC; k++)
            if (column->component == PP_DF || (int)column->component == k)
                status = add_own_world(worlds, room, column, k, err);
    }
    if (status != PP_OK) {
        pp_own_world_destroy(worlds);
        return status;
    }
    *result = worlds;
    return PP_OK;
}

void pp_own_world_destroy(struct pp_own_worlds *worlds)
{
    if (!worlds)
        return;
    for (int i = 0; i < worlds->count; i++) {
        pp_report_clear(&worlds->list[i].report);
        pp_world_destroy(worlds->list[i].world);
    }
    free(worlds->list);
    pp_own_skylines_clear(&worlds->skylines);
    free(worlds);
}

int pp_own_world_count(const struct pp_own_worlds *worlds)
{
    return worlds->count;
}

struct pp_report *pp_own_world_report(struct pp_own_worlds *worlds, int index)
{
    return &worlds->list[index].report;
}

enum pp_status pp_own_world_trace_one(const struct pp_own_worlds *worlds, int index,
                                      struct pp_report *report,
                                      const struct pp_study_options *options,
                                      bool *by_clock, struct pp_error *err)
{
    return (worlds->list[index].inside
                ? pp_study_report_traced
                : pp_study_report_traced_direct)(report, options, by_clock, err);
}

enum pp_status pp_own_world_trace(struct pp_own_worlds *worlds,
                                  const struct pp_study_options *options,
                                  bool *finished, bool *by_clock, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < worlds->count && *finished && status == PP_OK; i++) {
        struct pp_report *report = &worlds->list[i].report;
        status = pp_own_world_trace_one(worlds, i, report, options, by_clock, err);
        *finished &= report->finished;
    }
    return status;
}
