/* gains.c - makes each change of gain_changes.h, evaluates the changed room, and ranks
 * the gains.
 */
#include "studies/sizing/gains.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "studies/sizing/gain_changes.h"
#include "studies/criteria/grid/plane_grid.h"
#include "methods/evaluate.h"
#include "methods/default_methods.h"
#include "model/base/text.h"
#include "studies/study_report.h"

/* Changes that increase the average by a smaller fraction are omitted. The value was
 * chosen, not measured. */
static const double least_share = 0.002;

/* Calculates daylight factors of a world by the method: the average, and the value at
 * the darkest grid point. NAN if the method has no value. */
static enum pp_status evaluate_gain(struct pp_gain_values *values,
                                    const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const char *method, struct pp_error *err)
{
    *values = (struct pp_gain_values){NAN, NAN};
    struct pp_report report = {.world = world, .light = *light, .finished = true};
    struct pp_receiver *grid = NULL;
    enum pp_status status =
        pp_plane_grid_largest(&grid, &report.receiver_count, world, err);
    report.receivers = grid;
    if (status == PP_OK)
        status = pp_methods_evaluate(&report, method, err);
    const struct pp_column *df =
        status == PP_OK ? pp_report_find(&report, PP_DF, method) : NULL;
    if (df)
        values->average = df->average.value;
    for (int i = 0; df && i < report.receiver_count; i++)
        values->darkest = fmin(values->darkest, df->points[i].value);
    pp_report_clear(&report);
    free(grid);
    return status;
}

/* Least target for the relative standard error of a simulation. */
static const double gain_error = 0.02;

/* Simulates the same daylight factors; NAN if the simulation is interrupted. */
static enum pp_status simulate_gain(struct pp_gain_values *values,
                                    const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const struct pp_study_options *options,
                                    struct pp_error *err)
{
    *values = (struct pp_gain_values){NAN, NAN};
    struct pp_report report = {.world = world, .light = *light, .finished = true};
    struct pp_receiver *grid = NULL;
    bool by_clock = false;
    enum pp_status status =
        pp_plane_grid_largest(&grid, &report.receiver_count, world, err);
    report.receivers = grid;
    if (status == PP_OK)
        status = pp_study_report_traced(&report, options, &by_clock, err);
    const struct pp_column *df =
        status == PP_OK ? pp_report_find(&report, PP_DF, "traced") : NULL;
    if (df && report.finished) {
        values->average = df->average.value;
        for (int i = 0; i < report.receiver_count; i++)
            values->darkest = fmin(values->darkest, df->points[i].value);
    }
    pp_report_clear(&report);
    free(grid);
    return status;
}

/* Calculates the same daylight factors of a room: by simulation, or, if `options` is
 * NULL, by the method. */
static enum pp_status evaluate_room(struct pp_gain_values *values,
                                    const struct pp_room *room,
                                    const struct pp_outside_light *light,
                                    const char *method,
                                    const struct pp_study_options *options,
                                    struct pp_error *err)
{
    struct pp_world *world = NULL;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "the changed room");
    enum pp_status status = pp_world_create(&world, room, &mistakes, err);
    *values = (struct pp_gain_values){NAN, NAN};
    /* A change that makes the room invalid has no values, and therefore no gain. */
    if (status == PP_BAD_INPUT)
        status = PP_OK;
    else if (status == PP_OK)
        status = options ? simulate_gain(values, world, light, options, err)
                         : evaluate_gain(values, world, light, method, err);
    pp_world_destroy(world);
    pp_mistakes_clear(&mistakes);
    return status;
}

/* Inserts a gain into the list, which is in descending order of averages. */
static void insert(struct pp_gains *gains, const struct pp_gain *gain)
{
    int at = gains->count++;
    for (; at > 0 && gains->list[at - 1].values.average < gain->values.average; at--)
        gains->list[at] = gains->list[at - 1];
    gains->list[at] = *gain;
}

static enum pp_status try_change(struct pp_gains *gains, int kind_index,
                                 const struct pp_room *room,
                                 const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const struct pp_study_options *options,
                                 struct pp_error *err)
{
    const struct pp_gain_kind *kind = &pp_gain_kinds[kind_index];
    struct pp_gain gain = {
        .lacks = kind->lacks, .of_design = kind->of_design, .kind = kind_index};
    struct pp_room *changed = NULL;
    enum pp_status status = kind->make(&changed, &gain, room, world, err);
    if (status == PP_OK && changed) {
        status =
            evaluate_room(&gain.values, changed, light, gains->method, options, err);
        if (gain.values.average > (1.0 + least_share) * gains->now.average)
            insert(gains, &gain);
    }
    pp_room_destroy(changed);
    return status;
}

enum pp_status pp_gains_find(struct pp_gains *gains, const struct pp_room *room,
                             const struct pp_world *world,
                             const struct pp_outside_light *light,
                             const struct pp_watch *watch, struct pp_error *err)
{
    *gains = (struct pp_gains){.now = {NAN, NAN}};
    bool shown = pp_watch_begin(watch, world->name);
    const char *pair = pp_default_methods(world, light, NULL, 0).name;
    enum pp_status status = evaluate_gain(&gains->now, world, light, pair, err);
    if (isfinite(gains->now.average))
        gains->method = pair;
    for (int i = 0; pp_gain_kinds[i].make && gains->method && status == PP_OK; i++) {
        pp_watch_show(watch, shown, (i + 1.0) / (PP_GAINS_MOST + 1.0));
        status = try_change(gains, i, room, world, light, NULL, err);
    }
    pp_watch_end(watch, shown);
    return status;
}

enum pp_status pp_gains_simulate(struct pp_gains *gains, const struct pp_room *room,
                                 const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const struct pp_study_options *options,
                                 struct pp_error *err)
{
    struct pp_gains by_hand = *gains;
    struct pp_study_options own = *options;
    if (!gains->method)
        return PP_OK;
    int count = by_hand.count < PP_GAINS_SIMULATED ? by_hand.count : PP_GAINS_SIMULATED;
    if (own.samples == 0)
        own.error = fmax(own.error, gain_error);
    own.seconds /= count + 1;
    *gains = (struct pp_gains){.method = "traced"};
    enum pp_status status = simulate_gain(&gains->now, world, light, &own, err);
    for (int i = 0; i < count && status == PP_OK && isfinite(gains->now.average); i++)
        status = try_change(gains, by_hand.list[i].kind, room, world, light, &own, err);
    return status;
}

void pp_gains_relate(struct pp_gains *gains, double average)
{
    const double scale = average / gains->now.average;
    if (!isfinite(scale))
        return;
    gains->now.average = average;
    for (int i = 0; i < gains->count; i++)
        gains->list[i].values.average *= scale;
}

void pp_gains_sentence(const struct pp_gains *gains, char *text, size_t size)
{
    enum { NAMED = 3 };
    const char *named[NAMED];
    int count = 0;
    for (int i = 0; i < gains->count && count < NAMED; i++)
        if (gains->list[i].lacks)
            named[count++] = gains->list[i].lacks;
    snprintf(text, size, "%s", count ? "Main causes: " : "");
    pp_text_append_list(text, size, named, count, " and ");
    pp_text_append(text, size, "%s", count ? "." : "");
}
