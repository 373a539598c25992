/* evaluate.c - calls the methods for each opening and receiver, applies the corrections
 * (symbol by symbol for the steps), adds up, and enters the readings in the report. */
#include "methods/evaluate.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "methods/plane_average.h"
#include "methods/selection.h"

/* One method on one world. */
struct method_run {
    const struct pp_method *method;
    const struct pp_world *world;
    double *factors; /* product of the missing corrections, one for each opening */
    void *tools;     /* made by the method; NULL for a room that it refuses */
    bool roughly;    /* by evaluate_roughly, for an average */
};

/* The components by a method over all openings, corrected, or why there are none. */
struct answer {
    struct pp_part part;
    const char *why;                  /* not owned; NULL: part is valid */
    const struct pp_opening *opening; /* the subject of why; NULL: the room */
    struct pp_steps *steps;           /* where the sum is recorded; may be NULL */
};

/* D applies to the internally reflected component. A method that gives the daylight
 * factor as a whole has no such part, and gets no D. */
static double decorations_of(const struct method_run *run)
{
    return run->method->gives == PP_GIVES_INTERNAL ? run->world->decorations : 1.0;
}

static enum pp_status run_init(struct method_run *run, const struct pp_method *method,
                               const struct pp_report *report, struct pp_error *err)
{
    static const struct pp_method_options no_options;
    const struct pp_world *world = report->world;
    *run = (struct method_run){.method = method, .world = world};
    run->factors = malloc(((size_t)world->opening_count + 1) * sizeof(double));
    if (!run->factors)
        return pp_fail_memory(err);
    for (int i = 0; i < world->opening_count; i++)
        run->factors[i] = pp_allowance_factor(method->allowances, world->openings + i)
                          * decorations_of(run);
    bool refused = method->refuses_room && method->refuses_room(world, NULL);
    enum pp_status status = PP_OK;
    if (method->prepare && !refused)
        status = method->prepare(&run->tools, world, err);
    if (method->prepare_with_options && !refused)
        status = method->prepare_with_options(
            &run->tools, world, report->options ? report->options : &no_options, err);
    if (status != PP_OK)
        free(run->factors);
    return status;
}

static void run_clear(struct method_run *run)
{
    if (run->method->destroy_tools)
        run->method->destroy_tools(run->tools);
    free(run->factors);
}

static const char *const component_names[PP_COMPONENT_COUNT] = {
    [PP_SC] = "sky component",
    [PP_ERC] = "externally reflected component",
    [PP_IRC] = "internally reflected component",
    [PP_DF] = "daylight factor",
};

/* Symbols in formulae: of one opening by the method itself, and with all
 * corrections. */
static const char *const own_symbols[PP_COMPONENT_COUNT] = {"sc", "erc", "irc", "df"};
static const char *const symbols[PP_COMPONENT_COUNT] = {"SC", "ERC", "IRC", "DF"};

/* The component in a method's part.sky or part.value. */
static enum pp_component component_of(const struct pp_method *method)
{
    static const enum pp_component given_by[] = {
        [PP_GIVES_DIRECT] = PP_SC,
        [PP_GIVES_INTERNAL] = PP_IRC,
        [PP_GIVES_WHOLE] = PP_DF,
    };
    return given_by[method->gives];
}

/* The value of a component in a part. */
static double figure(const struct pp_part *part, enum pp_component component)
{
    return component == PP_SC    ? part->sky
           : component == PP_ERC ? part->external
                                 : part->value;
}

/* The components that the steps list, at most two: the externally reflected component
 * is left out where it is 0 and the method has recorded none. */
static int components_of(enum pp_component list[2], const struct pp_method *method,
                         const struct pp_part *part, const struct pp_steps *steps,
                         int first)
{
    list[0] = component_of(method);
    list[1] = PP_ERC;
    bool reflects =
        part->external != 0.0 || pp_steps_find(steps, first, own_symbols[PP_ERC]);
    return list[0] == PP_SC && reflects ? 2 : 1;
}

/* Records the corrections of one opening and the corrected components, behind the
 * method's own steps, which begin with step `first`. */
static void add_opening_steps(struct answer *answer, const struct method_run *run,
                              int index, const struct pp_part *part,
                              const struct pp_part *corrected, int first)
{
    struct pp_steps *steps = answer->steps;
    const struct pp_opening *opening = &run->world->openings[index];
    enum pp_component components[2];
    int count = components_of(components, run->method, part, steps, first);
    for (int i = 0; i < count; i++)
        if (!pp_steps_find(steps, first, own_symbols[components[i]]))
            pp_steps_add_named(steps, PP_UNIT_SHARE, figure(part, components[i]),
                               own_symbols[components[i]], "%s, as read",
                               component_names[components[i]]);
    char product[64];
    pp_allowance_steps(steps, run->method->allowances, opening, product,
                       sizeof product);
    double D = decorations_of(run);
    if (D != 1.0) {
        pp_steps_add_named(steps, PP_UNIT_NUMBER, D, "D",
                           "decorations: what their deterioration leaves");
        strncat(product, " D", sizeof product - strlen(product) - 1);
    }
    for (int i = 0; i < count; i++) {
        char symbol[16], formula[96];
        bool single = run->world->opening_count == 1;
        snprintf(symbol, sizeof symbol, single ? "%s" : "%s_%d", symbols[components[i]],
                 index + 1);
        snprintf(formula, sizeof formula, "%s%s", own_symbols[components[i]], product);
        pp_steps_add_worked(steps, PP_UNIT_SHARE, figure(corrected, components[i]),
                            symbol, formula, "%s", component_names[components[i]]);
    }
}

/* Records the sums over the openings, where there is not just one. */
static void add_sum_steps(const struct answer *answer, const struct method_run *run)
{
    enum pp_component components[2];
    int count = components_of(components, run->method, &answer->part, answer->steps, 0);
    answer->steps->line = 0;
    for (int i = 0; i < count; i++)
        pp_steps_add_sum(answer->steps, 0, run->world->opening_count,
                         symbols[components[i]], component_names[components[i]]);
}

/* The components of one opening times its corrections. */
static struct pp_part corrected_part(const struct pp_part *part, double factor)
{
    return (struct pp_part){.sky = factor * part->sky,
                            .external = factor * part->external,
                            .value = factor * part->value};
}

/* Adds up the components of all openings by the method. */
static enum pp_status add_openings(const struct method_run *run,
                                   const struct pp_receiver *receiver,
                                   struct answer *answer, struct pp_error *err)
{
    const struct pp_method *method = run->method;
    const struct pp_world *world = run->world;
    bool roughly = run->roughly && method->evaluate_roughly;
    for (int i = 0; i < world->opening_count; i++) {
        struct pp_part part = {.steps = answer->steps};
        int first = 0;
        if (answer->steps) {
            first = answer->steps->count;
            answer->steps->line = world->openings[i].line;
        }
        enum pp_status status = (roughly ? method->evaluate_roughly : method->evaluate)(
            world, world->openings + i, receiver, run->tools, &part, err);
        if (status != PP_OK)
            return status;
        if (part.why) {
            answer->why = part.why;
            answer->opening = world->openings + i;
            return PP_OK;
        }
        const struct pp_part own = corrected_part(&part, run->factors[i]);
        answer->part.sky += own.sky;
        answer->part.external += own.external;
        answer->part.value += own.value;
        if (answer->steps)
            add_opening_steps(answer, run, i, &part, &own, first);
    }
    return PP_OK;
}

/* The method's sum over the openings for a receiver (NULL: for the room), or why there
 * is none. The caller owns answer->steps. */
static enum pp_status sum_openings(const struct method_run *run,
                                   const struct pp_receiver *receiver,
                                   struct answer *answer, struct pp_error *err)
{
    const struct pp_method *method = run->method;
    const struct pp_world *world = run->world;
    *answer = (struct answer){.steps = answer->steps};
    if (method->refuses_room)
        answer->why = method->refuses_room(world, receiver);
    if (answer->why)
        return PP_OK;
    for (int i = 0; i < world->opening_count && method->refuses; i++) {
        answer->why = method->refuses(world, world->openings + i, receiver);
        answer->opening = world->openings + i;
        if (answer->why)
            return PP_OK;
    }
    answer->opening = NULL;
    enum pp_status status = add_openings(run, receiver, answer, err);
    if (status != PP_OK || answer->why || !answer->steps)
        return status;
    if (world->opening_count != 1)
        add_sum_steps(answer, run);
    return answer->steps->failed ? pp_fail_memory(err) : PP_OK;
}

/* One component of an answer as a reading; the report keeps the text of its why. */
static enum pp_status to_reading(struct pp_reading *reading, struct pp_report *report,
                                 const struct pp_method *method,
                                 const struct answer *answer,
                                 enum pp_component component, struct pp_error *err)
{
    if (!answer->why) {
        *reading = pp_reading_of(figure(&answer->part, component));
        /* Both direct components have one list of steps, which stands with the
         * first. */
        if (component != PP_ERC)
            reading->steps = answer->steps;
        return PP_OK;
    }
    const char *why =
        answer->opening
            ? pp_report_say(report, "%s: the opening on line %d %s", method->name,
                            answer->opening->line, answer->why)
            : pp_report_say(report, "%s: %s", method->name, answer->why);
    *reading = pp_reading_none(why);
    return why ? PP_OK : pp_fail_memory(err);
}

/* The context of the integrand over the working plane. */
struct plane_sum {
    const struct method_run *run;
    struct answer refusal; /* of any point: the reason is the same at all points */
    bool failed;
};

static bool plane_sum_at(void *data, const struct pp_receiver *receiver,
                         double values[PP_PLANE_VALUES])
{
    struct plane_sum *sum = data;
    struct answer answer = {0};
    bool failed = sum_openings(sum->run, receiver, &answer, NULL) != PP_OK;
    if (failed || answer.why) {
#pragma omp critical(pp_plane_sum)
        {
            sum->failed |= failed;
            if (!failed)
                sum->refusal = answer;
        }
        return false;
    }
    bool direct = sum->run->method->gives == PP_GIVES_DIRECT;
    values[0] = direct ? answer.part.sky : answer.part.value;
    values[1] = direct ? answer.part.external : 0.0;
    return true;
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
    enum pp_status status = pp_plane_average(
        mean, &stopped, run->world, plane_sum_at, &sum,
        run->method->counts ? PP_AVERAGE_ERROR_COUNTS : PP_AVERAGE_ERROR,
        PP_AVERAGE_POINTS, err);
    if (status != PP_OK)
        return status;
    if (sum.refusal.why) {
        *answer = sum.refusal;
        return PP_OK;
    }
    if (stopped)
        return pp_fail(err, PP_SYSTEM,
                       "%s could not be averaged over the working plane",
                       run->method->name);
    answer->part =
        (struct pp_part){.sky = mean[0], .external = mean[1], .value = mean[0]};
    return PP_OK;
}

/* The answers for each receiver and, behind them, for the room's average. */
static enum pp_status answer_all(const struct method_run *run,
                                 const struct pp_report *report, struct answer *answers,
                                 struct pp_error *err)
{
    int count = report->receiver_count, failed = count;
    bool by_point = run->method->speaks_for == PP_FOR_POINT;
    bool minimum = run->method->speaks_for == PP_FOR_MINIMUM;
    struct answer *average = answers + count;
    bool integrated = by_point && !run->method->has_average;
    enum pp_status status = integrated ? average_of_points(run, average, err)
                                       : sum_openings(run, NULL, average, err);
    if (status != PP_OK)
        return status;

    for (int i = 0; i < count && !by_point; i++) {
        const char *why = NULL;
        if (run->method->refuses_room)
            why = run->method->refuses_room(run->world, report->receivers + i);
        answers[i] = why ? (struct answer){.why = why} : *average;
    }
    if (minimum && !average->why)
        *average = (struct answer){.why = "it gives the least in the room, no average"};
    if (!by_point)
        return PP_OK;
#pragma omp parallel for schedule(dynamic, 1) if (count > 64)
    for (int i = 0; i < count; i++)
        if (sum_openings(run, report->receivers + i, answers + i, NULL) != PP_OK) {
#pragma omp critical(pp_answer_all)
            failed = i < failed ? i : failed;
        }
    /* Again in order from the first failure on, for its message. */
    for (int i = failed; i < count && status == PP_OK; i++)
        status = sum_openings(run, report->receivers + i, answers + i, err);
    return status;
}

/* Adds the column of one component from the answers of a method. */
static enum pp_status add_column(struct pp_report *report,
                                 const struct pp_method *method,
                                 const struct answer *answers,
                                 enum pp_component component, struct pp_error *err)
{
    if (pp_report_find(report, component, method->name))
        return PP_OK;
    int count = report->receiver_count;
    bool whole_room =
        method->gives == PP_GIVES_WHOLE && method->speaks_for == PP_FOR_ROOM;
    struct pp_column *column =
        pp_report_add(report, component, method->name, !whole_room);
    if (!column)
        return pp_fail_memory(err);
    column->of_all_surfaces = method->of_all_surfaces;
    enum pp_status status =
        to_reading(&column->average, report, method, answers + count, component, err);
    for (int i = 0; i < count && column->points && status == PP_OK; i++)
        status =
            to_reading(column->points + i, report, method, answers + i, component, err);
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
                                 const struct pp_method *method, struct pp_error *err)
{
    enum pp_component component = component_of(method);
    if (pp_report_find(report, component, method->name))
        return PP_OK;

    struct method_run run;
    enum pp_status status = run_init(&run, method, report, err);
    if (status != PP_OK)
        return status;
    struct answer *answers =
        calloc((size_t)report->receiver_count + 1, sizeof *answers);
    status =
        answers && create_steps(answers, report, method) ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK)
        status = answer_all(&run, report, answers, err);
    if (status == PP_OK)
        status = add_column(report, method, answers, component, err);
    if (status == PP_OK && method->gives == PP_GIVES_DIRECT)
        status = add_column(report, method, answers, PP_ERC, err);
    free(answers);
    run_clear(&run);
    return status;
}

/* sc + erc + irc, or why there is no sum: the reason of the direct part comes first. */
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
    pp_steps_add_named(steps, PP_UNIT_SHARE, column->points[point].value,
                       symbols[column->component], "%s by %s",
                       component_names[column->component], column->name);
}

static enum pp_status add_pair(struct pp_report *report, const struct pp_method *direct,
                               const struct pp_method *internal, struct pp_error *err)
{
    char name[sizeof report->columns->name];
    snprintf(name, sizeof name, "%s+%s", direct->name, internal->name);
    if (pp_report_find(report, PP_DF, name))
        return PP_OK;
    struct pp_column *df = pp_report_add(report, PP_DF, name, true);
    if (!df)
        return pp_fail_memory(err);
    const struct pp_column *sc = pp_report_find(report, PP_SC, direct->name);
    const struct pp_column *erc = pp_report_find(report, PP_ERC, direct->name);
    const struct pp_column *irc = pp_report_find(report, PP_IRC, internal->name);
    df->average = pair_of(sc->average, erc->average, irc->average);
    for (int i = 0; i < report->receiver_count; i++) {
        df->points[i] = pair_of(sc->points[i], erc->points[i], irc->points[i]);
        if (!report->explain || df->points[i].why)
            continue;
        struct pp_steps *steps = pp_report_steps(report);
        add_column_step(steps, sc, i);
        add_column_step(steps, erc, i);
        add_column_step(steps, irc, i);
        pp_steps_add_worked(steps, PP_UNIT_SHARE, df->points[i].value, symbols[PP_DF],
                            "SC + ERC + IRC", "%s", component_names[PP_DF]);
        if (!steps || steps->failed)
            return pp_fail_memory(err);
        df->points[i].steps = steps;
    }
    return PP_OK;
}

enum pp_status pp_methods_evaluate(struct pp_report *report, const char *selection,
                                   struct pp_error *err)
{
    struct pp_selection parsed;
    enum pp_status status = pp_selection_parse(&parsed, selection, err);
    for (int i = 0; i < parsed.count && status == PP_OK; i++) {
        struct pp_choice choice = parsed.choices[i];
        status = add_method(report, choice.method, err);
        if (status == PP_OK && choice.internal)
            status = add_method(report, choice.internal, err);
        if (status == PP_OK && choice.internal)
            status = add_pair(report, choice.method, choice.internal, err);
    }
    pp_selection_clear(&parsed);
    return status;
}
