/* method_run.c - calls the method for each opening, applies the corrections (with a
 * symbol for each in the steps) and adds up the results: at a point, for the room, or
 * as an average. */
#include "methods/method_run.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "methods/component_steps.h"
#include "methods/fast/beams.h"
#include "methods/average/plane_average.h"

/* Finds the first opening that the method does not cover for a receiver, and why; NULL
 * if it covers all. */
static const struct pp_opening *refused_opening(const struct pp_method_run *run,
                                                const struct pp_receiver *receiver,
                                                const char **why)
{
    const struct pp_world *world = run->world;
    *why = NULL;
    for (int i = 0; i < world->opening_count; i++) {
        *why = pp_method_refuses_opening(run->method, world, run->light,
                                         world->openings + i, receiver);
        if (*why)
            return world->openings + i;
    }
    return NULL;
}

/* Writes the reason why the method does not cover the room or one of its openings;
 * false if it covers them. */
static bool method_refuses(const struct pp_method_run *run,
                           const struct pp_receiver *receiver,
                           struct pp_method_answer *answer)
{
    const struct pp_method *method = run->method;
    answer->why = pp_method_refuses_room(method, run->world, run->light, receiver);
    if (answer->why)
        return true;
    answer->opening = run->refused;
    answer->why = run->why_refused;
    if (!run->refuses_alike)
        answer->opening = refused_opening(run, receiver, &answer->why);
    return answer->why != NULL;
}

enum pp_status pp_method_run_init(struct pp_method_run *run,
                                  const struct pp_method *method,
                                  const struct pp_variant *variant,
                                  const struct pp_report *report,
                                  struct pp_method_shared shared, struct pp_error *err)
{
    static const struct pp_method_options no_options;
    const struct pp_world *world = report->world;
    *run = (struct pp_method_run){.method = method,
                                  .name = variant ? variant->name : method->name,
                                  .varied = variant,
                                  .world = world,
                                  .light = &report->light,
                                  .shared = shared};
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
        run->factors[i] = pp_allowance_of(method, world, world->openings + i);
    bool refused = pp_method_refuses_room(method, world, run->light, NULL) != NULL;
    run->refuses_alike = method->refuses_alike || !method->refuses;
    if (run->refuses_alike && !refused) {
        run->refused = refused_opening(run, NULL, &run->why_refused);
        refused = run->refused;
    }
    run->plain = report->options && report->options->plain;
    run->stop = report->options ? report->options->stop : (struct pp_stop){0};
    if (method->prepare_fast && !refused && !run->plain)
        status = method->prepare_fast(&run->tools, world, run->light, err);
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

void pp_method_run_clear(struct pp_method_run *run)
{
    if (run->method->destroy_tools)
        run->method->destroy_tools(run->tools);
    pp_formulary_destroy(run->formulary);
    free(run->factors);
}

/* Adds the components of one opening times its corrections; returns the product. */
static struct pp_amounts add_part(struct pp_amounts *sum, const struct pp_part *part,
                                  double factor)
{
    const struct pp_amounts own = {.sky = factor * part->sky,
                                   .external = factor * part->external,
                                   .value = factor * part->value};
    sum->sky += own.sky;
    sum->external += own.external;
    sum->value += own.value;
    return own;
}

/* Adds the components of one opening; sets *used if a formula of the variant was
 * evaluated. If answer->why is set, the opening has no figures. */
static enum pp_status add_opening_components(const struct pp_method_run *run, int i,
                                             const struct pp_receiver *receiver,
                                             struct pp_method_answer *answer,
                                             bool *used, struct pp_error *err)
{
    const struct pp_method *method = run->method;
    const struct pp_world *world = run->world;
    bool roughly = run->roughly && method->evaluate_roughly;
    struct pp_part part;
    if (pp_stop_check(run->stop, err) != PP_OK)
        return PP_INTERRUPTED;
    memset(&part, 0, offsetof(struct pp_part, sheet.list)); /* leaves out the list,
                                                             * which is still empty */
    part.sheet.steps = answer->steps;
    part.sheet.formulary = run->formulary;
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
    *used |= part.sheet.varied;
    const struct pp_amounts own = add_part(&answer->amounts, &part, run->factors[i]);
    if (answer->steps)
        pp_component_steps_add(answer->steps, method, world, i, &part, &own, first);
    return PP_OK;
}

/* Adds up the method's components for all openings. */
static enum pp_status add_openings(const struct pp_method_run *run,
                                   const struct pp_receiver *receiver,
                                   struct pp_method_answer *answer,
                                   struct pp_error *err)
{
    const struct pp_world *world = run->world;
    bool used = false;
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->opening_count && status == PP_OK && !answer->why; i++)
        status = add_opening_components(run, i, receiver, answer, &used, err);
    /* A point may not see some openings, but a room has them all: if no opening used
     * the variant, there is no value. */
    if (status == PP_OK && !answer->why && run->varied && !used
        && run->method->speaks_for != PP_FOR_POINT && world->opening_count > 0)
        answer->why = "the formula does not apply to any of the room's openings";
    return status;
}

enum pp_status pp_method_run_answer(const struct pp_method_run *run,
                                    const struct pp_receiver *receiver,
                                    struct pp_method_answer *answer,
                                    struct pp_error *err)
{
    const struct pp_world *world = run->world;
    *answer = (struct pp_method_answer){.steps = answer->steps};
    if (method_refuses(run, receiver, answer))
        return PP_OK;
    enum pp_status status = add_openings(run, receiver, answer, err);
    if (status != PP_OK || answer->why || !answer->steps)
        return status;
    if (world->opening_count != 1)
        pp_component_steps_add_sums(answer->steps, run->method, world,
                                    &answer->amounts);
    return answer->steps->failed ? pp_fail_memory(err) : PP_OK;
}

/* The context of the integrand, for averages over the working plane. */
struct plane_sum {
    const struct pp_method_run *run;
    struct pp_method_answer
        refusal; /* reason of the first refused opening; of several reasons for that
                  * opening, the one in the lowest column */
    bool failed;
};

/* Orders two reasons, so that the result does not depend on the order of the points. */
static bool comes_before(const struct pp_method_answer *a,
                         const struct pp_method_answer *b)
{
    if (!b->why || a->opening != b->opening)
        return !b->why || a->opening < b->opening;
    return a->column < b->column;
}

static bool plane_sum_at(void *data, int opening, const struct pp_receiver *receiver,
                         double values[PP_PLANE_VALUES])
{
    struct plane_sum *sum = data;
    struct pp_method_answer answer = {0};
    bool used = false, failed = add_opening_components(sum->run, opening, receiver,
                                                       &answer, &used, NULL)
                                != PP_OK;
    if (failed || answer.why) {
        pp_thread_pool_lock(sum->run->shared.pool);
        sum->failed |= failed;
        if (!failed && comes_before(&answer, &sum->refusal))
            sum->refusal = answer;
        pp_thread_pool_unlock(sum->run->shared.pool);
        return false;
    }
    bool direct = sum->run->method->gives == PP_GIVES_DIRECT;
    values[0] = direct ? answer.amounts.sky : answer.amounts.value;
    values[1] = direct ? answer.amounts.external : 0.0;
    return true;
}

/* Averages of the openings, calculated by the method itself. The openings are divided
 * among the threads. */
struct opening_averages {
    struct pp_part *parts;
    const struct pp_method *method;
    struct pp_beams *beams;
    const struct pp_outside_light *light;
    const void *tools;
    struct pp_thread_pool *pool;

    /* The first opening without an average, and its status; written under the lock. */
    int first;
    enum pp_status status;
    struct pp_error err;
};

static bool average_one_opening(void *data, int worker, int i)
{
    (void)worker;
    struct opening_averages *averages = data;
    struct pp_error err = {0};
    bool known = false;
    enum pp_status status = averages->method->average(
        averages->beams, averages->light, pp_beams_world(averages->beams)->openings + i,
        averages->tools, averages->parts + i, &known, &err);
    if (status == PP_OK && known)
        return true;
    pp_thread_pool_lock(averages->pool);
    if (i < averages->first) {
        averages->first = i;
        averages->status = status;
        averages->err = err;
    }
    pp_thread_pool_unlock(averages->pool);
    return false;
}

/* The averages over the working plane that a method calculates itself
 * (pp_method.average). parts[i], which must be zero on entry, is set to the average for
 * opening i of the beams' world, before the corrections for glass, frame and dirt.
 * *known is false if the method has no average for one of the openings; the parts are
 * then not valid. The openings are divided among the pool's workers. */
static enum pp_status average_openings(struct pp_part *parts, bool *known,
                                       const struct pp_method *method,
                                       struct pp_beams *beams,
                                       const struct pp_outside_light *light,
                                       const void *tools, struct pp_thread_pool *pool,
                                       struct pp_error *err)
{
    int count = pp_beams_world(beams)->opening_count;
    struct opening_averages averages = {parts, method, beams,         light,
                                        tools, pool,   .first = count};
    pp_thread_pool_run(pool, 0, count, average_one_opening, &averages);
    *known = averages.first == count;
    return averages.status == PP_OK
               ? PP_OK
               : pp_fail(err, averages.status, "%s", averages.err.message);
}

/* Sum over the openings of the averages that the method calculates itself. *known is
 * false if the method has no average for one of the openings. */
static enum pp_status sum_averages(const struct pp_method_run *run,
                                   struct pp_method_answer *answer, bool *known,
                                   struct pp_error *err)
{
    const struct pp_world *world = run->world;
    *answer = (struct pp_method_answer){0};
    *known = true;
    struct pp_part *parts = calloc((size_t)world->opening_count + 1, sizeof *parts);
    if (!parts)
        return pp_fail_memory(err);
    enum pp_status status =
        average_openings(parts, known, run->method, run->shared.beams, run->light,
                         run->tools, run->shared.pool, err);
    for (int i = 0; i < world->opening_count; i++)
        add_part(&answer->amounts, parts + i, run->factors[i]);
    free(parts);
    return status;
}

/* A method's refusal of an average depends only on the plane's height and normal, so
 * any of its points can be tested. */
static bool refuse_plane(const struct pp_method_run *run,
                         struct pp_method_answer *answer)
{
    const struct pp_world *world = run->world;
    const double *corner = world->plane.rings[0].xy[0];
    const struct pp_receiver receiver = {
        .position = {corner[0], corner[1], world->working_plane_m},
        .normal = {0.0, 0.0, 1.0}};
    return method_refuses(run, &receiver, answer);
}

enum pp_status pp_method_run_average(const struct pp_method_run *run,
                                     struct pp_method_answer *answer,
                                     struct pp_error *err)
{
    struct pp_method_run rough_run = *run;
    rough_run.roughly = !run->plain;
    struct plane_sum sum = {.run = &rough_run};
    double mean[PP_PLANE_VALUES];
    bool stopped;
    *answer = (struct pp_method_answer){0};
    if (pp_region_area(&run->world->plane) <= 0.0) {
        answer->why = "the room has no working plane at this height";
        return PP_OK;
    }
    if (refuse_plane(run, answer))
        return PP_OK;
    if (run->method->average) {
        bool known;
        enum pp_status status = sum_averages(run, answer, &known, err);
        if (status == PP_OK && pp_beams_gave_up(run->shared.beams)) {
            *answer = (struct pp_method_answer){
                .why = "the obstructions have too many parts; the average would take "
                       "too long to calculate"};
            return PP_OK;
        }
        if (status != PP_OK || known)
            return status;
        *answer = (struct pp_method_answer){0};
    }
    int count = run->world->opening_count;
    struct pp_plane_centre *centres = malloc(((size_t)count + 1) * sizeof *centres);
    if (!centres)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        centres[i] = pp_plane_centre_of(&run->world->openings[i]);
    enum pp_status status =
        pp_plane_average(mean, &stopped, run->world, centres, count, plane_sum_at, &sum,
                         PP_AVERAGE_ERROR, PP_AVERAGE_POINTS, run->shared.pool, err);
    free(centres);
    if (status != PP_OK)
        return status;
    if (sum.refusal.why) {
        *answer = sum.refusal;
        return PP_OK;
    }
    if (stopped && pp_stop_check(run->stop, err) != PP_OK)
        return PP_INTERRUPTED;
    if (stopped)
        return pp_fail(err, PP_SYSTEM,
                       "the calculation of the average of %s over the working plane "
                       "did not converge",
                       run->name);
    answer->amounts =
        (struct pp_amounts){.sky = mean[0], .external = mean[1], .value = mean[0]};
    return PP_OK;
}
