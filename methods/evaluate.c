/* evaluate.c - calls the methods for each opening and receiver, applies the corrections
 * (symbol by symbol for the steps), adds up, and enters the readings in the report. */
#include "methods/evaluate.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "methods/component_steps.h"
#include "methods/opening_averages.h"
#include "methods/pair.h"
#include "methods/plane_average.h"
#include "methods/selection.h"
#include "methods/variant.h"
#include "methods/usual_pair.h"
#include "model/base/crew.h"

/* So many points take less time than waking the other members of a crew. */
enum { LONE_POINTS = 64 };

/* One method on one world, as published or with a variant of a formula. */
struct method_run {
    const struct pp_method *method;
    const char *name; /* of its columns */
    bool varied;      /* by a variant */
    const struct pp_world *world;
    const struct pp_outside_light *light;
    double *factors; /* product of the missing corrections, one for each opening */
    void *tools;     /* made by the method; NULL for a room that it refuses */
    struct pp_formulary *formulary;
    struct pp_crew *crew; /* not owned */
    bool roughly;         /* by evaluate_roughly, for an average */
};

/* The components by a method over all openings, corrected, or why there are none. */
struct answer {
    struct pp_part part;
    const char *why;                  /* not owned; NULL: part is valid */
    const struct pp_opening *opening; /* the subject of why; NULL: the room */
    int column;                       /* of why in a variant's text, from 1; 0: none */
    struct pp_steps *steps;           /* where the sum is recorded; may be NULL */
};

/* D applies to the internally reflected component. A method that gives the daylight
 * factor as a whole has no such part, and gets no D. */
static double decorations_of(const struct method_run *run)
{
    return run->method->gives == PP_GIVES_INTERNAL ? run->world->decorations : 1.0;
}

static enum pp_status run_init(struct method_run *run, const struct pp_method *method,
                               const struct pp_variant *variant,
                               const struct pp_report *report, struct pp_error *err)
{
    static const struct pp_method_options no_options;
    const struct pp_world *world = report->world;
    *run = (struct method_run){.method = method,
                               .name = variant ? variant->name : method->name,
                               .varied = variant,
                               .world = world,
                               .light = &report->light};
    enum pp_status status = pp_formulary_create(
        &run->formulary, method->formulae, variant ? &variant->formula : NULL, err);
    if (status != PP_OK)
        return status;
    run->factors = malloc(((size_t)world->opening_count + 1) * sizeof(double));
    if (!run->factors) {
        pp_formulary_destroy(run->formulary);
        return pp_fail_memory(err);
    }
    for (int i = 0; i < world->opening_count; i++)
        run->factors[i] = pp_allowance_factor(method->allowances, world->openings + i)
                          * decorations_of(run);
    bool refused =
        method->refuses_room && method->refuses_room(world, run->light, NULL);
    if (method->prepare && !refused)
        status = method->prepare(&run->tools, world, run->light, err);
    if (method->prepare_with_options && !refused)
        status = method->prepare_with_options(
            &run->tools, world, run->light,
            report->options ? report->options : &no_options, err);
    if (status != PP_OK) {
        pp_formulary_destroy(run->formulary);
        free(run->factors);
    }
    return status;
}

static void run_clear(struct method_run *run)
{
    if (run->method->destroy_tools)
        run->method->destroy_tools(run->tools);
    pp_formulary_destroy(run->formulary);
    free(run->factors);
}

/* Adds the components of one opening times its corrections, which it returns. */
static struct pp_part add_part(struct pp_part *sum, const struct pp_part *part,
                               double factor)
{
    const struct pp_part own = {.sky = factor * part->sky,
                                .external = factor * part->external,
                                .value = factor * part->value};
    sum->sky += own.sky;
    sum->external += own.external;
    sum->value += own.value;
    return own;
}

/* Adds up the components of all openings by the method. */
static enum pp_status add_openings(const struct method_run *run,
                                   const struct pp_receiver *receiver,
                                   struct answer *answer, struct pp_error *err)
{
    const struct pp_method *method = run->method;
    const struct pp_world *world = run->world;
    bool roughly = run->roughly && method->evaluate_roughly, used = false;
    for (int i = 0; i < world->opening_count; i++) {
        struct pp_part part = {
            .sheet = {.steps = answer->steps, .formulary = run->formulary}};
        int first = 0;
        if (answer->steps) {
            first = answer->steps->count;
            answer->steps->line = world->openings[i].line;
        }
        enum pp_status status = (roughly ? method->evaluate_roughly : method->evaluate)(
            world, run->light, world->openings + i, receiver, run->tools, &part, err);
        if (status != PP_OK)
            return status;
        if (part.why) {
            answer->why = part.why;
            answer->opening = world->openings + i;
            return PP_OK;
        }
        if (part.sheet.fault.what) {
            answer->why = part.sheet.fault.what;
            answer->column = part.sheet.fault.column + 1;
            answer->opening = world->openings + i;
            return PP_OK;
        }
        used |= part.sheet.varied;
        const struct pp_part own = add_part(&answer->part, &part, run->factors[i]);
        if (answer->steps)
            pp_component_steps_add(answer->steps, method, world, i, &part, &own,
                                   decorations_of(run), first);
    }
    /* A point may see nothing of the openings; a room has all of them. */
    if (run->varied && !used && method->speaks_for != PP_FOR_POINT
        && world->opening_count > 0)
        answer->why = "the room has no opening that its formula is for";
    return PP_OK;
}

/* Sets down why the method does not cover the room or one of its openings; false: it
 * does. */
static bool refuse(const struct method_run *run, const struct pp_receiver *receiver,
                   struct answer *answer)
{
    const struct pp_method *method = run->method;
    const struct pp_world *world = run->world;
    if (method->refuses_room)
        answer->why = method->refuses_room(world, run->light, receiver);
    for (int i = 0; i < world->opening_count && method->refuses && !answer->why; i++) {
        answer->why = method->refuses(world, run->light, world->openings + i, receiver);
        answer->opening = answer->why ? world->openings + i : NULL;
    }
    return answer->why != NULL;
}

/* The method's sum over the openings for a receiver (NULL: for the room), or why there
 * is none. The caller owns answer->steps. */
static enum pp_status sum_openings(const struct method_run *run,
                                   const struct pp_receiver *receiver,
                                   struct answer *answer, struct pp_error *err)
{
    const struct pp_world *world = run->world;
    *answer = (struct answer){.steps = answer->steps};
    if (refuse(run, receiver, answer))
        return PP_OK;
    enum pp_status status = add_openings(run, receiver, answer, err);
    if (status != PP_OK || answer->why || !answer->steps)
        return status;
    if (world->opening_count != 1)
        pp_component_steps_add_sums(answer->steps, run->method, world, &answer->part);
    return answer->steps->failed ? pp_fail_memory(err) : PP_OK;
}

/* One component of an answer as a reading; the report keeps the text of its why. */
static enum pp_status to_reading(struct pp_reading *reading, struct pp_report *report,
                                 const char *name, const struct answer *answer,
                                 enum pp_component component, struct pp_error *err)
{
    if (!answer->why) {
        *reading = pp_reading_of(pp_component_steps_figure(&answer->part, component));
        /* Both direct components have one list of steps, which stands with the
         * first. */
        if (component != PP_ERC)
            reading->steps = answer->steps;
        return PP_OK;
    }
    const char *why =
        answer->column
            ? pp_report_say(report,
                            "%s: for the opening on line %d the formula %s, in column "
                            "%d",
                            name, answer->opening->line, answer->why, answer->column)
        : answer->opening ? pp_report_say(report, "%s: the opening on line %d %s", name,
                                          answer->opening->line, answer->why)
                          : pp_report_say(report, "%s: %s", name, answer->why);
    *reading = pp_reading_none(why);
    return why ? PP_OK : pp_fail_memory(err);
}

/* The context of the integrand over the working plane. */
struct plane_sum {
    const struct method_run *run;
    struct answer refusal; /* of the first opening, and column, that has one */
    bool failed;
};

/* Which of two reasons is said, whatever the order of the points. */
static bool comes_before(const struct answer *a, const struct answer *b)
{
    if (!b->why || a->opening != b->opening)
        return !b->why || a->opening < b->opening;
    return a->column < b->column;
}

static bool plane_sum_at(void *data, const struct pp_receiver *receiver,
                         double values[PP_PLANE_VALUES])
{
    struct plane_sum *sum = data;
    struct answer answer = {0};
    bool failed = sum_openings(sum->run, receiver, &answer, NULL) != PP_OK;
    if (failed || answer.why) {
        pp_crew_lock(sum->run->crew);
        sum->failed |= failed;
        if (!failed && comes_before(&answer, &sum->refusal))
            sum->refusal = answer;
        pp_crew_unlock(sum->run->crew);
        return false;
    }
    bool direct = sum->run->method->gives == PP_GIVES_DIRECT;
    values[0] = direct ? answer.part.sky : answer.part.value;
    values[1] = direct ? answer.part.external : 0.0;
    return true;
}

/* The sum over the openings of their averages by the method itself; *known is false
 * where there is none for one of them. */
static enum pp_status sum_averages(const struct method_run *run, struct answer *answer,
                                   bool *known, struct pp_error *err)
{
    const struct pp_world *world = run->world;
    const struct pp_receiver receiver = {.position = {world->plane.rings[0].xy[0][0],
                                                      world->plane.rings[0].xy[0][1],
                                                      world->working_plane_m},
                                         .normal = {0.0, 0.0, 1.0}};
    *answer = (struct answer){0};
    *known = true;
    if (refuse(run, &receiver, answer))
        return PP_OK;
    struct pp_part *parts = calloc((size_t)world->opening_count + 1, sizeof *parts);
    if (!parts)
        return pp_fail_memory(err);
    enum pp_status status = pp_opening_averages(parts, known, run->method, world,
                                                run->light, run->tools, run->crew, err);
    for (int i = 0; i < world->opening_count; i++)
        add_part(&answer->part, parts + i, run->factors[i]);
    free(parts);
    return status;
}

/* The average over the working plane by a method that speaks for a point. */
static enum pp_status average_of_points(const struct method_run *run,
                                        struct answer *answer, struct pp_error *err)
{
    struct method_run rough_run = *run;
    rough_run.roughly = true;
    struct plane_sum sum = {.run = &rough_run};
    double mean[PP_PLANE_VALUES];
    bool stopped;
    *answer = (struct answer){0};
    if (pp_region_area(&run->world->plane) <= 0.0) {
        answer->why = "the room has no working plane at that height";
        return PP_OK;
    }
    if (run->method->average) {
        bool known;
        enum pp_status status = sum_averages(run, answer, &known, err);
        if (status != PP_OK || known)
            return status;
        *answer = (struct answer){0};
    }
    enum pp_status status =
        pp_plane_average(mean, &stopped, run->world, plane_sum_at, &sum,
                         PP_AVERAGE_ERROR, PP_AVERAGE_POINTS, run->crew, err);
    if (status != PP_OK)
        return status;
    if (sum.refusal.why) {
        *answer = sum.refusal;
        return PP_OK;
    }
    if (stopped)
        return pp_fail(err, PP_SYSTEM,
                       "%s could not be averaged over the working plane", run->name);
    answer->part =
        (struct pp_part){.sky = mean[0], .external = mean[1], .value = mean[0]};
    return PP_OK;
}

/* The answers for the receivers, which the crew's members share. */
struct answering {
    const struct method_run *run;
    const struct pp_receiver *receivers;
    struct answer *answers;
    atomic_bool failed;
};

static bool answer_one(void *data, int member, int i)
{
    (void)member;
    struct answering *to = data;
    if (sum_openings(to->run, to->receivers + i, to->answers + i, NULL) != PP_OK)
        atomic_store(&to->failed, true);
    return !atomic_load(&to->failed);
}

static enum pp_status answer_points(const struct method_run *run,
                                    const struct pp_report *report,
                                    struct answer *answers, struct pp_error *err)
{
    struct answering answering = {run, report->receivers, answers, false};
    int count = report->receiver_count;
    if (count > LONE_POINTS)
        pp_crew_run(run->crew, 0, count, answer_one, &answering);
    /* In order where they are few, or again, for the message of the first failure. */
    bool ordered = count <= LONE_POINTS || answering.failed;
    enum pp_status status = PP_OK;
    for (int i = 0; ordered && i < count && status == PP_OK; i++)
        status = sum_openings(run, report->receivers + i, answers + i, err);
    return status;
}

/* The answers for each receiver and, behind them, for the room's average. */
static enum pp_status answer_all(const struct method_run *run,
                                 const struct pp_report *report, struct answer *answers,
                                 struct pp_error *err)
{
    int count = report->receiver_count;
    bool by_point = run->method->speaks_for == PP_FOR_POINT;
    struct answer *average = answers + count;
    bool integrated = by_point && !run->method->has_average;
    enum pp_status status = integrated ? average_of_points(run, average, err)
                                       : sum_openings(run, NULL, average, err);
    if (status != PP_OK)
        return status;

    for (int i = 0; i < count && !by_point; i++) {
        const char *why = NULL;
        if (run->method->refuses_room)
            why = run->method->refuses_room(run->world, run->light,
                                            report->receivers + i);
        answers[i] = why ? (struct answer){.why = why} : *average;
    }
    if (run->method->speaks_for == PP_FOR_MINIMUM && !average->why)
        *average = (struct answer){.why = "it gives the least in the room, no average"};
    return by_point ? answer_points(run, report, answers, err) : PP_OK;
}

/* Adds the column of one component from the answers of a method. */
static enum pp_status add_column(struct pp_report *report,
                                 const struct pp_method *method, const char *name,
                                 const struct answer *answers,
                                 enum pp_component component, struct pp_error *err)
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

/* Where steps are asked for, makes their lists: one for each receiver or one for the
 * room. */
static bool create_steps(struct answer *answers, struct pp_report *report,
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
                                 const struct pp_variant *variant, struct pp_crew *crew,
                                 struct pp_error *err)
{
    enum pp_component component = pp_component_steps_given(method);
    if (pp_report_find(report, component, variant ? variant->name : method->name))
        return PP_OK;

    struct method_run run;
    enum pp_status status = run_init(&run, method, variant, report, err);
    if (status != PP_OK)
        return status;
    run.crew = crew;
    struct answer *answers =
        calloc((size_t)report->receiver_count + 1, sizeof *answers);
    status =
        answers && create_steps(answers, report, method) ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK)
        status = answer_all(&run, report, answers, err);
    if (status == PP_OK)
        status = add_column(report, method, run.name, answers, component, err);
    if (status == PP_OK && method->gives == PP_GIVES_DIRECT)
        status = add_column(report, method, run.name, answers, PP_ERC, err);
    free(answers);
    run_clear(&run);
    return status;
}

/* The columns of a method or pair, with a variant (NULL: as published) of one of them. */
static enum pp_status add_choice(struct pp_report *report,
                                 const struct pp_choice *choice,
                                 const struct pp_variant *variant, struct pp_crew *crew,
                                 struct pp_error *err)
{
    const struct pp_method *method = choice->method, *internal = choice->internal;
    bool of_internal = variant && variant->method == internal;
    enum pp_status status =
        add_method(report, method, of_internal ? NULL : variant, crew, err);
    if (status != PP_OK || !internal)
        return status;
    status = add_method(report, internal, of_internal ? variant : NULL, crew, err);
    return status == PP_OK
               ? pp_pair_add(report,
                             variant && !of_internal ? variant->name : method->name,
                             of_internal ? variant->name : internal->name, err)
               : status;
}

/* The pair in place of the usual one, where that does not cover the room. */
static enum pp_status stand_in(struct pp_report *report, struct pp_error *err)
{
    const struct pp_usual_pair pair = pp_usual_pair(
        report->world, &report->light, report->receivers, report->receiver_count);
    if (!pair.instead)
        return PP_OK;
    report->stand_in =
        pp_report_say(report, "%s stands in for %s, which does not cover this room",
                      pair.name, pair.instead);
    return report->stand_in ? pp_methods_evaluate(report, pair.name, err)
                            : pp_fail_memory(err);
}

enum pp_status pp_methods_evaluate(struct pp_report *report, const char *selection,
                                   struct pp_error *err)
{
    static const struct pp_variant_list none;
    const struct pp_variant_list *variants =
        report->options && report->options->variants ? report->options->variants
                                                     : &none;
    struct pp_selection parsed;
    struct pp_crew *crew = NULL;
    enum pp_status status = pp_selection_parse(&parsed, selection, err);
    if (status == PP_OK)
        status = pp_crew_create(&crew, report->threads, err);
    for (int i = 0; i < variants->count && status == PP_OK; i++)
        status = pp_selection_include(&parsed, variants->list[i].method, err);
    for (int i = 0; i < parsed.count && status == PP_OK; i++) {
        const struct pp_choice *choice = &parsed.choices[i];
        status = add_choice(report, choice, NULL, crew, err);
        for (int k = 0; k < variants->count && status == PP_OK; k++)
            if (variants->list[k].method == choice->method
                || variants->list[k].method == choice->internal)
                status = add_choice(report, choice, &variants->list[k], crew, err);
    }
    if (status == PP_OK && parsed.usual)
        status = stand_in(report, err);
    pp_crew_destroy(crew);
    pp_selection_clear(&parsed);
    return status;
}
