/* evaluate.c - runs the methods of a selection for each receiver and for the average,
 * and adds the readings to the report. */
#include "methods/evaluate.h"

#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "methods/component_steps.h"
#include "methods/fast/beams.h"
#include "methods/method_run.h"
#include "methods/reflected/light_bound.h"
#include "methods/selection.h"
#include "methods/default_methods.h"

/* Up to this number of receivers, starting threads costs more than it saves. */
enum { SERIAL_MAX = 64 };

/* Converts one component of an answer to a reading; the report stores a copy of
 * `why`. */
static enum pp_status to_reading(struct pp_reading *reading, struct pp_report *report,
                                 const char *name,
                                 const struct pp_method_answer *answer,
                                 enum pp_component component, struct pp_error *err)
{
    if (!answer->why) {
        *reading =
            pp_reading_of(pp_component_steps_figure(&answer->amounts, component));
        /* Both direct components share one list of steps, kept with the first. */
        if (component != PP_ERC)
            reading->steps = answer->steps;
        return PP_OK;
    }
    const struct pp_opening *opening = answer->opening;
    const char *kind = opening ? pp_world_kind(report->world, opening->line) : NULL;
    const char *why =
        answer->column
            ? pp_report_say(report, "%s: the formula %s, in column %d, for %s %s", name,
                            answer->why, answer->column, kind, opening->label)
        : opening ? pp_report_say(report, "%s: %s %s %s", name, kind, opening->label,
                                  answer->why)
                  : pp_report_say(report, "%s: %s", name, answer->why);
    *reading = pp_reading_none(why);
    return why ? PP_OK : pp_fail_memory(err);
}

/* The answers for the receivers, which are divided among the pool's workers. */
struct answering {
    const struct pp_method_run *run;
    const struct pp_receiver *receivers;
    struct pp_method_answer *answers;
    atomic_bool failed;
};

static bool answer_one(void *data, int worker, int i)
{
    (void)worker;
    struct answering *to = data;
    if (pp_method_run_answer(to->run, to->receivers + i, to->answers + i, NULL)
        != PP_OK)
        atomic_store(&to->failed, true);
    return !atomic_load(&to->failed);
}

static enum pp_status answer_points(const struct pp_method_run *run,
                                    const struct pp_report *report,
                                    struct pp_method_answer *answers,
                                    struct pp_error *err)
{
    struct answering answering = {run, report->receivers, answers, false};
    int count = report->receiver_count;
    if (count > SERIAL_MAX)
        pp_thread_pool_run(run->shared.pool, 0, count, answer_one, &answering);
    /* Few receivers are evaluated in order. Many are evaluated again, in order, after a
     * failure, so that the message is that of the first receiver that fails. */
    bool ordered = count <= SERIAL_MAX || answering.failed;
    enum pp_status status = PP_OK;
    for (int i = 0; ordered && i < count && status == PP_OK; i++)
        status = pp_method_run_answer(run, report->receivers + i, answers + i, err);
    return status;
}

/* Finds the columns, SC and ERC, of another method, if that method has the same figures
 * in this world and has been evaluated. */
static bool find_same(const struct pp_column *column[2],
                      const struct pp_method_run *run, const struct pp_report *report)
{
    const struct pp_method *same = run->method->same_as && !run->varied && !run->plain
                                       ? run->method->same_as(run->world)
                                       : NULL;
    if (!same)
        return false;
    column[0] = pp_report_find(report, PP_SC, same->name);
    column[1] = pp_report_find(report, PP_ERC, same->name);
    return column[0] && column[1];
}

static bool found_average(const struct pp_method_run *run,
                          const struct pp_report *report,
                          struct pp_method_answer *average)
{
    const struct pp_column *column[2];
    if (!find_same(column, run, report) || !isfinite(column[0]->average.value))
        return false;
    average->amounts.sky = column[0]->average.value;
    average->amounts.external = column[1]->average.value;
    return true;
}

/* False if the other method has no value for one of the receivers: the reason would be
 * in its name. */
static bool found_points(const struct pp_method_run *run,
                         const struct pp_report *report,
                         struct pp_method_answer *answers)
{
    const struct pp_column *column[2];
    if (report->explain || !find_same(column, run, report))
        return false;
    for (int i = 0; i < report->receiver_count; i++) {
        if (column[0]->points[i].why || column[1]->points[i].why)
            return false;
        answers[i].amounts.sky = column[0]->points[i].value;
        answers[i].amounts.external = column[1]->points[i].value;
    }
    return true;
}

/* Evaluates the answers for each receiver, followed by the room's average. */
static enum pp_status answer_all(const struct pp_method_run *run,
                                 const struct pp_report *report,
                                 struct pp_method_answer *answers, struct pp_error *err)
{
    int count = report->receiver_count;
    bool by_point = run->method->speaks_for == PP_FOR_POINT;
    struct pp_method_answer *average = answers + count;
    enum pp_status status = PP_OK;
    if (!by_point || run->method->has_average)
        status = pp_method_run_answer(run, NULL, average, err);
    else if (report->options && report->options->points_only
             && run->method->gives == PP_GIVES_DIRECT)
        average->why = "an average over the working plane was not requested";
    else if (!found_average(run, report, average))
        status = pp_method_run_average(run, average, err);
    if (status != PP_OK)
        return status;

    for (int i = 0; i < count && !by_point; i++) {
        const char *why = pp_method_refuses_room(run->method, run->world, run->light,
                                                 report->receivers + i);
        answers[i] = why ? (struct pp_method_answer){.why = why} : *average;
    }
    if (run->method->speaks_for == PP_FOR_MINIMUM && !average->why)
        *average = (struct pp_method_answer){
            .why = "the method gives the minimum in the room, not an average"};
    return by_point && !found_points(run, report, answers)
               ? answer_points(run, report, answers, err)
               : PP_OK;
}

/* Withdraws a figure for the whole room, and gives the reason, if the figure needs more
 * light than enters the room. */
static enum pp_status check_light(struct pp_method_answer *answer,
                                  const struct pp_light_bound *bound,
                                  const struct pp_method *method,
                                  struct pp_report *report, struct pp_error *err)
{
    bool direct = method->gives == PP_GIVES_DIRECT;
    const struct pp_amounts *amounts = &answer->amounts;
    double most = direct ? bound->direct : bound->any;
    double figure = direct ? amounts->sky + amounts->external : amounts->value;
    if (answer->why || !(figure > most))
        return PP_OK;
    answer->opening = NULL;
    answer->column = 0;
    answer->why = pp_report_say(report,
                                "the result of %.4g %% exceeds the upper limit set by "
                                "the light that enters the room, %.4g %%",
                                100.0 * figure, 100.0 * most);
    return answer->why ? PP_OK : pp_fail_memory(err);
}

/* Calls check_light for all answers that describe the whole room. */
static enum pp_status check_room(struct pp_method_answer *answers,
                                 const struct pp_method *method,
                                 struct pp_report *report, struct pp_error *err)
{
    const struct pp_light_bound bound = pp_light_bound(report->world, &report->light);
    int count = report->receiver_count;
    enum pp_status status = PP_OK;
    for (int i = method->speaks_for == PP_FOR_POINT ? count : 0;
         i <= count && status == PP_OK; i++)
        status = check_light(&answers[i], &bound, method, report, err);
    return status;
}

/* Adds the column of one component from the answers of a method, unless the report
 * already has that column. */
static enum pp_status add_component_column(struct pp_report *report,
                                           const struct pp_method *method,
                                           const char *name,
                                           const struct pp_method_answer *answers,
                                           enum pp_component component,
                                           struct pp_error *err)
{
    if (pp_report_find(report, component, name))
        return PP_OK;
    int count = report->receiver_count;
    bool whole_room =
        method->gives == PP_GIVES_WHOLE && method->speaks_for == PP_FOR_ROOM;
    struct pp_column *column = pp_report_add(report, component, name, !whole_room);
    if (!column)
        return pp_fail_memory(err);
    column->of_all_surfaces = method->of_all_surfaces;
    enum pp_status status =
        to_reading(&column->average, report, name, answers + count, component, err);
    for (int i = 0; i < count && column->points && status == PP_OK; i++)
        status =
            to_reading(column->points + i, report, name, answers + i, component, err);
    return status;
}

/* If steps are requested, creates their lists: one for each receiver or one for the
 * room. Returns false if memory runs out. */
static bool create_steps(struct pp_method_answer *answers, struct pp_report *report,
                         const struct pp_method *method)
{
    if (!report->explain)
        return true;
    int count = report->receiver_count;
    bool by_point = method->speaks_for == PP_FOR_POINT;
    bool of_average = !by_point || method->has_average;
    for (int i = by_point ? 0 : count; i < (of_average ? count + 1 : count); i++)
        if (!(answers[i].steps = pp_report_steps(report)))
            return false;
    return true;
}

static enum pp_status add_method(struct pp_report *report,
                                 const struct pp_method *method,
                                 const struct pp_variant *variant,
                                 struct pp_method_shared shared, struct pp_error *err)
{
    enum pp_component component = pp_component_steps_given(method);
    if (pp_report_find(report, component, variant ? variant->name : method->name))
        return PP_OK;

    struct pp_method_run run;
    enum pp_status status =
        pp_method_run_init(&run, method, variant, report, shared, err);
    if (status != PP_OK)
        return status;
    struct pp_method_answer *answers =
        calloc((size_t)report->receiver_count + 1, sizeof *answers);
    status =
        answers && create_steps(answers, report, method) ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK)
        status = answer_all(&run, report, answers, err);
    if (status == PP_OK)
        status = check_room(answers, method, report, err);
    if (status == PP_OK)
        status =
            add_component_column(report, method, run.name, answers, component, err);
    if (status == PP_OK && method->gives == PP_GIVES_DIRECT)
        status = add_component_column(report, method, run.name, answers, PP_ERC, err);
    free(answers);
    pp_method_run_clear(&run);
    return status;
}

/* ---- pairs: direct component by one method, reflected by another ---- */

/* Sum sc + erc + irc, or the reason why there is no sum. The reason of the direct
 * component takes precedence. */
static struct pp_reading pair_of(struct pp_reading sc, struct pp_reading erc,
                                 struct pp_reading irc)
{
    if (sc.why)
        return sc;
    return irc.why ? irc : pp_reading_of(sc.value + erc.value + irc.value);
}

/* Records the reading of a column at a point. */
static void add_column_step(struct pp_steps *steps, const struct pp_column *column,
                            int point)
{
    pp_steps_add_named(steps, PP_UNIT_DAYLIGHT_FACTOR, column->points[point].value,
                       pp_component_steps_symbols[column->component], "%s by %s",
                       pp_component_steps_names[column->component], column->name);
}

/* Adds the column "direct+internal" from the columns of the two methods, which must
 * exist. Does nothing if the report already has that column. */
static enum pp_status add_pair(struct pp_report *report, const char *direct,
                               const char *internal, struct pp_error *err)
{
    char name[80];
    snprintf(name, sizeof name, "%s+%s", direct, internal);
    if (pp_report_find(report, PP_DF, name))
        return PP_OK;
    struct pp_column *df = pp_report_add(report, PP_DF, name, true);
    if (!df)
        return pp_fail_memory(err);
    const struct pp_column *sc = pp_report_find(report, PP_SC, direct);
    const struct pp_column *erc = pp_report_find(report, PP_ERC, direct);
    const struct pp_column *irc = pp_report_find(report, PP_IRC, internal);
    df->average = pair_of(sc->average, erc->average, irc->average);
    for (int i = 0; i < report->receiver_count; i++) {
        df->points[i] = pair_of(sc->points[i], erc->points[i], irc->points[i]);
        if (!report->explain || df->points[i].why)
            continue;
        struct pp_steps *steps = pp_report_steps(report);
        add_column_step(steps, sc, i);
        add_column_step(steps, erc, i);
        add_column_step(steps, irc, i);
        pp_steps_add_worked(steps, PP_UNIT_DAYLIGHT_FACTOR, df->points[i].value,
                            pp_component_steps_symbols[PP_DF], "SC + ERC + IRC", "%s",
                            pp_component_steps_names[PP_DF]);
        if (!steps || steps->failed)
            return pp_fail_memory(err);
        df->points[i].steps = steps;
    }
    return PP_OK;
}

/* ---- a selection ---- */

/* Adds the columns of a method or pair, with a variant (NULL: as published) of one of
 * them. */
static enum pp_status add_choice(struct pp_report *report,
                                 const struct pp_choice *choice,
                                 const struct pp_variant *variant,
                                 struct pp_method_shared shared, struct pp_error *err)
{
    const struct pp_method *method = choice->method, *internal = choice->internal;
    bool of_internal = variant && variant->method == internal;
    enum pp_status status =
        add_method(report, method, of_internal ? NULL : variant, shared, err);
    if (status != PP_OK || !internal)
        return status;
    status = add_method(report, internal, of_internal ? variant : NULL, shared, err);
    return status == PP_OK
               ? add_pair(report,
                          variant && !of_internal ? variant->name : method->name,
                          of_internal ? variant->name : internal->name, err)
               : status;
}

/* Adds the default pair for this room if the first choice does not cover the room. */
static enum pp_status stand_in(struct pp_report *report, struct pp_error *err)
{
    const struct pp_default_methods pair = pp_default_methods(
        report->world, &report->light, report->receivers, report->receiver_count);
    if (!pair.instead)
        return PP_OK;
    report->stand_in =
        pp_report_say(report, "%s replaces %s, which does not apply to this room",
                      pair.name, pair.instead);
    return report->stand_in ? pp_methods_evaluate(report, pair.name, err)
                            : pp_fail_memory(err);
}

/* Calculates the illuminances of the open sky on the planes of all openings, which most
 * methods and the light bound need. */
static enum pp_status find_planes(struct pp_outside_planes *planes,
                                  const struct pp_report *report, struct pp_error *err)
{
    const struct pp_world *world = report->world;
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->opening_count && status == PP_OK; i++)
        status = pp_outside_light_add_plane(
            planes, &report->light.sky,
            pp_vec_scale(world->openings[i].inner.normal, -1.0), err);
    return status;
}

enum pp_status pp_methods_evaluate(struct pp_report *report, const char *selection,
                                   struct pp_error *err)
{
    static const struct pp_variant_list none;
    const struct pp_variant_list *variants =
        report->options && report->options->variants ? report->options->variants
                                                     : &none;
    struct pp_selection parsed;
    struct pp_method_shared shared = {0};
    struct pp_outside_planes planes = {0};
    enum pp_status status = pp_selection_parse(&parsed, selection, err);
    if (status == PP_OK)
        status = pp_thread_pool_create(&shared.pool, report->threads, err);
    if (status == PP_OK)
        status = pp_beams_create(&shared.beams, report->world,
                                 report->options && report->options->plain, err);
    if (status == PP_OK && report->options)
        pp_beams_stop_when(shared.beams, report->options->stop);
    if (status == PP_OK)
        status = find_planes(&planes, report, err);
    report->light.planes = &planes;
    for (int i = 0; i < variants->count && status == PP_OK; i++)
        status = pp_selection_include(&parsed, variants->list[i].method, err);
    for (int i = 0; i < parsed.count && status == PP_OK; i++) {
        const struct pp_choice *choice = &parsed.choices[i];
        status = add_choice(report, choice, NULL, shared, err);
        for (int k = 0; k < variants->count && status == PP_OK; k++)
            if (variants->list[k].method == choice->method
                || variants->list[k].method == choice->internal)
                status = add_choice(report, choice, &variants->list[k], shared, err);
    }
    if (status == PP_OK && parsed.usual)
        status = stand_in(report, err);
    report->light.planes = NULL;
    pp_outside_light_clear_planes(&planes);
    pp_beams_destroy(shared.beams);
    pp_thread_pool_destroy(shared.pool);
    pp_selection_clear(&parsed);
    return status;
}
