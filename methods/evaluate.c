/* evaluate.c - see evaluate.h. */
#include "methods/evaluate.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "methods/plane_average.h"
#include "methods/selection.h"

/* A method at work on one world. */
struct method_run {
    const struct pp_method *method;
    const struct pp_world *world;
    double *factors; /* what the method's figures still need, an opening each */
    void *tools;     /* what it prepared; NULL for a room that it refuses */
    bool roughly;    /* for an average */
};

/* What a method says in all, allowances settled, or why it says nothing. */
struct answer {
    struct pp_part part;
    const char *why;                  /* not owned; NULL: there is a part */
    const struct pp_opening *opening; /* that why speaks of; NULL: of the room */
    struct pp_steps *steps;           /* where the sum is set down; NULL: nowhere */
};

/* D, which bears on what is reflected inside. A method that gives the daylight factor as
 * a whole keeps no such part: it does without. */
static double decorations_of(const struct method_run *work)
{
    return work->method->gives == PP_GIVES_INTERNAL ? work->world->decorations : 1.0;
}

static enum pp_status work_create(struct method_run *work,
                                  const struct pp_method *method,
                                  const struct pp_report *report, struct pp_error *err)
{
    static const struct pp_method_options nothing_asked;
    const struct pp_world *world = report->world;
    *work = (struct method_run){.method = method, .world = world};
    work->factors = malloc(((size_t)world->opening_count + 1) * sizeof(double));
    if (!work->factors)
        return pp_fail_memory(err);
    for (int i = 0; i < world->opening_count; i++)
        work->factors[i] = pp_allowance_factor(method->allowances, world->openings + i)
                           * decorations_of(work);
    bool refused = method->refuses_room && method->refuses_room(world, NULL);
    enum pp_status status = PP_OK;
    if (method->prepare && !refused)
        status = method->prepare(&work->tools, world, err);
    if (method->prepare_by && !refused)
        status =
            method->prepare_by(&work->tools, world,
                               report->options ? report->options : &nothing_asked, err);
    if (status != PP_OK)
        free(work->factors);
    return status;
}

static void work_clear(struct method_run *work)
{
    if (work->method->put_away)
        work->method->put_away(work->tools);
    free(work->factors);
}

static const char *const component_names[PP_COMPONENT_COUNT] = {
    [PP_SC] = "sky component",
    [PP_ERC] = "externally reflected component",
    [PP_IRC] = "internally reflected component",
    [PP_DF] = "daylight factor",
};

/* In formulae: of one opening as the method has it, and with all allowances. */
static const char *const own_symbols[PP_COMPONENT_COUNT] = {"sc", "erc", "irc", "df"};
static const char *const symbols[PP_COMPONENT_COUNT] = {"SC", "ERC", "IRC", "DF"};

/* The component that a method's part.sky or part.value belongs to. */
static enum pp_component component_of(const struct pp_method *method)
{
    static const enum pp_component given_by[] = {
        [PP_GIVES_DIRECT] = PP_SC,
        [PP_GIVES_INTERNAL] = PP_IRC,
        [PP_GIVES_WHOLE] = PP_DF,
    };
    return given_by[method->gives];
}

/* The figure of a part that belongs to a component. */
static double figure(const struct pp_part *part, enum pp_component component)
{
    return component == PP_SC    ? part->sky
           : component == PP_ERC ? part->external
                                 : part->value;
}

/* The components that a method's sheet speaks of, at most two. Nothing reflected
 * outside needs no line, unless the method has one. */
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

/* Sets down one opening's corrections and what comes of them, behind the method's own
 * steps, which begin with step `first`. */
static void set_down_opening(struct answer *answer, const struct method_run *work,
                             int index, const struct pp_part *part,
                             const struct pp_part *settled, int first)
{
    struct pp_steps *steps = answer->steps;
    const struct pp_opening *opening = &work->world->openings[index];
    enum pp_component components[2];
    int count = components_of(components, work->method, part, steps, first);
    for (int i = 0; i < count; i++)
        if (!pp_steps_find(steps, first, own_symbols[components[i]]))
            pp_steps_add_named(steps, PP_UNIT_SHARE, figure(part, components[i]),
                               own_symbols[components[i]], "%s, as read",
                               component_names[components[i]]);
    char product[64];
    pp_allowance_steps(steps, work->method->allowances, opening, product,
                       sizeof product);
    double D = decorations_of(work);
    if (D != 1.0) {
        pp_steps_add_named(steps, PP_UNIT_NUMBER, D, "D",
                           "decorations: what their deterioration leaves");
        strncat(product, " D", sizeof product - strlen(product) - 1);
    }
    for (int i = 0; i < count; i++) {
        char symbol[16], formula[96];
        bool alone = work->world->opening_count == 1;
        snprintf(symbol, sizeof symbol, alone ? "%s" : "%s_%d", symbols[components[i]],
                 index + 1);
        snprintf(formula, sizeof formula, "%s%s", own_symbols[components[i]], product);
        pp_steps_add_worked(steps, PP_UNIT_SHARE, figure(settled, components[i]),
                            symbol, formula, "%s", component_names[components[i]]);
    }
}

/* Sets down the sums over several openings, or none. */
static void set_down_sums(const struct answer *answer, const struct method_run *work)
{
    enum pp_component components[2];
    int count =
        components_of(components, work->method, &answer->part, answer->steps, 0);
    answer->steps->line = 0;
    for (int i = 0; i < count; i++)
        pp_steps_add_sum(answer->steps, 0, work->world->opening_count,
                         symbols[components[i]], component_names[components[i]]);
}

/* What one opening gives, times the factor that settles its glass, frame and dirt. */
static struct pp_part settle(const struct pp_part *part, double factor)
{
    return (struct pp_part){.sky = factor * part->sky,
                            .external = factor * part->external,
                            .value = factor * part->value};
}

/* Asks the method for each opening and adds up. */
static enum pp_status add_openings(const struct method_run *work,
                                   const struct pp_receiver *receiver,
                                   struct answer *answer, struct pp_error *err)
{
    const struct pp_method *method = work->method;
    const struct pp_world *world = work->world;
    bool roughly = work->roughly && method->evaluate_roughly;
    for (int i = 0; i < world->opening_count; i++) {
        struct pp_part part = {.steps = answer->steps};
        int first = 0;
        if (answer->steps) {
            first = answer->steps->count;
            answer->steps->line = world->openings[i].line;
        }
        enum pp_status status = (roughly ? method->evaluate_roughly : method->evaluate)(
            world, world->openings + i, receiver, work->tools, &part, err);
        if (status != PP_OK)
            return status;
        if (part.why) {
            answer->why = part.why;
            answer->opening = world->openings + i;
            return PP_OK;
        }
        const struct pp_part own = settle(&part, work->factors[i]);
        answer->part.sky += own.sky;
        answer->part.external += own.external;
        answer->part.value += own.value;
        if (answer->steps)
            set_down_opening(answer, work, i, &part, &own, first);
    }
    return PP_OK;
}

/* Sums the method over the openings for a receiver (NULL: for the room). The answer's
 * steps are the caller's. */
static enum pp_status sum_openings(const struct method_run *work,
                                   const struct pp_receiver *receiver,
                                   struct answer *answer, struct pp_error *err)
{
    const struct pp_method *method = work->method;
    const struct pp_world *world = work->world;
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
    enum pp_status status = add_openings(work, receiver, answer, err);
    if (status != PP_OK || answer->why || !answer->steps)
        return status;
    if (world->opening_count != 1)
        set_down_sums(answer, work);
    return answer->steps->failed ? pp_fail_memory(err) : PP_OK;
}

/* An answer as a reading of one component; its why goes to the report's keeping. */
static enum pp_status to_reading(struct pp_reading *reading, struct pp_report *report,
                                 const struct pp_method *method,
                                 const struct answer *answer,
                                 enum pp_component component, struct pp_error *err)
{
    if (!answer->why) {
        *reading = pp_reading_of(figure(&answer->part, component));
        /* Both direct components come of one sum, which stands with the first. */
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

/* What the integral over the working plane needs at each point. */
struct plane_sum {
    const struct method_run *work;
    struct answer refusal; /* the last one; all points refuse for one reason */
    bool failed;
};

static bool plane_sum_at(void *data, const struct pp_receiver *receiver,
                         double values[PP_PLANE_VALUES])
{
    struct plane_sum *sum = data;
    struct answer answer = {0};
    bool failed = sum_openings(sum->work, receiver, &answer, NULL) != PP_OK;
    if (failed || answer.why) {
#pragma omp critical(pp_plane_sum)
        {
            sum->failed |= failed;
            if (!failed)
                sum->refusal = answer;
        }
        return false;
    }
    bool direct = sum->work->method->gives == PP_GIVES_DIRECT;
    values[0] = direct ? answer.part.sky : answer.part.value;
    values[1] = direct ? answer.part.external : 0.0;
    return true;
}

/* The average over the working plane, of a method that speaks for a point. */
static enum pp_status average_of_points(const struct method_run *work,
                                        struct answer *answer, struct pp_error *err)
{
    struct method_run rough_work = *work;
    rough_work.roughly = true;
    struct plane_sum sum = {.work = &rough_work};
    double mean[PP_PLANE_VALUES];
    bool stopped;
    *answer = (struct answer){0};
    if (pp_region_area(&work->world->plane) <= 0.0) {
        answer->why = "the room has no working plane at that height";
        return PP_OK;
    }
    enum pp_status status = pp_plane_average(
        mean, &stopped, work->world, plane_sum_at, &sum,
        work->method->counts ? PP_AVERAGE_ERROR_COUNTS : PP_AVERAGE_ERROR,
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
                       work->method->name);
    answer->part =
        (struct pp_part){.sky = mean[0], .external = mean[1], .value = mean[0]};
    return PP_OK;
}

/* The answers at each receiver, and of the room's average behind them. */
static enum pp_status answer_all(const struct method_run *work,
                                 const struct pp_report *report, struct answer *answers,
                                 struct pp_error *err)
{
    int count = report->receiver_count, failed = count;
    bool by_point = work->method->speaks_for == PP_FOR_POINT;
    bool minimum = work->method->speaks_for == PP_FOR_MINIMUM;
    struct answer *average = answers + count;
    bool integrated = by_point && !work->method->has_average;
    enum pp_status status = integrated ? average_of_points(work, average, err)
                                       : sum_openings(work, NULL, average, err);
    if (status != PP_OK)
        return status;

    for (int i = 0; i < count && !by_point; i++) {
        const char *why = NULL;
        if (work->method->refuses_room)
            why = work->method->refuses_room(work->world, report->receivers + i);
        answers[i] = why ? (struct answer){.why = why} : *average;
    }
    if (minimum && !average->why)
        *average = (struct answer){.why = "it gives the least in the room, no average"};
    if (!by_point)
        return PP_OK;
#pragma omp parallel for schedule(dynamic, 1) if (count > 64)
    for (int i = 0; i < count; i++)
        if (sum_openings(work, report->receivers + i, answers + i, NULL) != PP_OK) {
#pragma omp critical(pp_answer_all)
            failed = i < failed ? i : failed;
        }
    /* Once more in order, for what the first that failed has to say. */
    for (int i = failed; i < count && status == PP_OK; i++)
        status = sum_openings(work, report->receivers + i, answers + i, err);
    return status;
}

/* Adds one component's column from a method's answers. */
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

/* Lists for the sums where they are asked for: one a receiver, or one of the room. */
static bool give_steps(struct answer *answers, struct pp_report *report,
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

    struct method_run work;
    enum pp_status status = work_create(&work, method, report, err);
    if (status != PP_OK)
        return status;
    struct answer *answers =
        calloc((size_t)report->receiver_count + 1, sizeof *answers);
    status =
        answers && give_steps(answers, report, method) ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK)
        status = answer_all(&work, report, answers, err);
    if (status == PP_OK)
        status = add_column(report, method, answers, component, err);
    if (status == PP_OK && method->gives == PP_GIVES_DIRECT)
        status = add_column(report, method, answers, PP_ERC, err);
    free(answers);
    work_clear(&work);
    return status;
}

/* sc + erc + irc, or why there is none: the direct part's reason first. */
static struct pp_reading pair_of(struct pp_reading sc, struct pp_reading erc,
                                 struct pp_reading irc)
{
    if (sc.why)
        return sc;
    return irc.why ? irc : pp_reading_of(sc.value + erc.value + irc.value);
}

/* One of a pair's parts at a point. */
static void set_down_column(struct pp_steps *steps, const struct pp_column *column,
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
        set_down_column(steps, sc, i);
        set_down_column(steps, erc, i);
        set_down_column(steps, irc, i);
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
