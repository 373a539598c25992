/* simulation.c - runs an engine in time slices, and adds its columns to the report. */
#include "studies/simulation.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/clock.h"
#include "model/base/text.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/fast/tracer.h"

/* Time (s) between checks of the clock and calls of the watch. */
static const double slice_s = 0.1;

struct pp_simulation {
    const struct pp_engine *engine; /* engine that determines the names of columns */
    const struct pp_engine
        *solver;                /* engine whose functions are called: the same engine,
                                 * or its plain implementation */
    struct pp_light_scene *own; /* scene made for this run; NULL: the scene belongs to
                                 * the caller */
    struct pp_environment *environment;
    void *run;
    double error; /* target error; 0: samples or time end the run */
};

/* The target counts as missed if the standard error exceeds it by this factor. Planned
 * standard errors are only estimates. */
static const double MISSED = 1.5;

enum pp_status pp_simulation_create_in(struct pp_simulation **simulation,
                                       const struct pp_engine *engine,
                                       const struct pp_light_scene *scene,
                                       const struct pp_report *report,
                                       const struct pp_engine_options *options,
                                       struct pp_error *err)
{
    struct pp_simulation *made = calloc(1, sizeof *made);
    *simulation = NULL;
    if (!made)
        return pp_fail_memory(err);
    made->engine = engine;
    /* The fast implementation supports only diffuse surfaces. */
    bool plain = options->plain || !pp_light_scene_is_matt(scene);
    made->solver = plain && engine->plain ? engine->plain : engine;
    made->error = options->error;
    enum pp_status status =
        pp_light_scene_under(&made->environment, scene, &report->light, err);
    if (status == PP_OK)
        status = made->solver->create(&made->run, scene, made->environment, report,
                                      options, err);
    if (status == PP_OK)
        *simulation = made;
    else
        pp_simulation_destroy(made);
    return status;
}

enum pp_status pp_simulation_create(struct pp_simulation **simulation,
                                    const struct pp_engine *engine,
                                    const struct pp_report *report,
                                    const struct pp_engine_options *options,
                                    struct pp_error *err)
{
    struct pp_light_scene *own;
    *simulation = NULL;
    enum pp_status status = pp_light_scene_of_world_grey(&own, report->world, err);
    if (status != PP_OK)
        return status;
    status = pp_simulation_create_in(simulation, engine, own, report, options, err);
    if (status == PP_OK)
        (*simulation)->own = own;
    else
        pp_light_scene_destroy(own);
    return status;
}

void pp_simulation_destroy(struct pp_simulation *simulation)
{
    if (!simulation)
        return;
    simulation->solver->destroy(simulation->run);
    pp_environment_destroy(simulation->environment);
    pp_light_scene_destroy(simulation->own);
    free(simulation);
}

enum pp_status pp_simulation_advance(struct pp_simulation *simulation, double seconds,
                                     struct pp_error *err)
{
    return simulation->solver->advance(simulation->run, seconds, err);
}

bool pp_simulation_done(const struct pp_simulation *simulation)
{
    return simulation->solver->done(simulation->run);
}

double pp_simulation_progress(const struct pp_simulation *simulation)
{
    return simulation->solver->progress(simulation->run);
}

double pp_simulation_error(const struct pp_simulation *simulation)
{
    return simulation->solver->error(simulation->run);
}

enum pp_status pp_simulation_run(struct pp_simulation *simulation, double seconds,
                                 const struct pp_watch *watch, const char *name,
                                 enum pp_simulation_end *end, struct pp_error *err)
{
    const double started_s = pp_clock_s();
    enum pp_status status = PP_OK;
    *end = PP_SIMULATION_DONE;
    double done = 0.0, error = NAN;
    bool shown = pp_watch_begin(watch, name);
    while (status == PP_OK && !pp_simulation_done(simulation)) {
        double spent = pp_clock_s() - started_s, slice = slice_s;
        if (watch->look && !watch->look(watch->data, done, error)) {
            *end = PP_SIMULATION_STOPPED;
            break;
        }
        if (seconds > 0.0 && spent >= seconds) {
            *end = PP_SIMULATION_BY_CLOCK;
            break;
        }
        if (seconds > 0.0)
            slice = fmin(slice, seconds - spent);
        status = pp_simulation_advance(simulation, slice, err);
        if (!shown)
            continue;
        done = pp_simulation_progress(simulation);
        if (seconds > 0.0)
            done = fmax(done, spent / seconds);
        error = pp_simulation_error(simulation);
    }
    if (watch->end)
        watch->end(watch->data);
    return status;
}

/* Standard error divided by its target. */
static double times_wanted(const struct pp_simulation *simulation,
                           const struct pp_reading *reading)
{
    double wanted =
        fmax(simulation->error * fabs(reading->value), PP_TRACER_LEAST_ERROR);
    return isfinite(reading->std_error) ? reading->std_error / wanted : 0.0;
}

/* Adds a note to the report if a standard error of the column is more than MISSED times
 * its target. */
static enum pp_status say_missed(struct pp_report *report,
                                 const struct pp_simulation *simulation,
                                 const struct pp_column *column, struct pp_error *err)
{
    double average = times_wanted(simulation, &column->average), worst = average;
    int points = 0;
    for (int i = 0; i < report->receiver_count; i++) {
        double times = times_wanted(simulation, &column->points[i]);
        points += times > MISSED;
        worst = fmax(worst, times);
    }
    if (worst <= MISSED)
        return PP_OK;
    char which[64] = "";
    if (points > 0)
        pp_text_append(which, sizeof which, "%d point%s", points,
                       points == 1 ? "" : "s");
    if (average > MISSED)
        pp_text_append(which, sizeof which, "%sthe average", points > 0 ? " and " : "");
    report->missed_error = pp_report_say(
        report,
        "The standard error is up to %.1f times the value of --error at %s, because "
        "few light paths find light there. Use more --samples or another --seed",
        worst, which);
    return report->missed_error ? PP_OK : pp_fail_memory(err);
}

enum pp_status pp_simulation_add_columns(const struct pp_simulation *simulation,
                                         struct pp_report *report, struct pp_error *err)
{
    const struct pp_engine *engine = simulation->engine, *solver = simulation->solver;
    double common = solver->common ? solver->common(simulation->run) : 0.0;
    double near = solver->common_near ? solver->common_near(simulation->run) : 0.0;
    struct pp_reading average[PP_COMPONENT_COUNT], readings[PP_COMPONENT_COUNT];
    solver->read(simulation->run, -1, average);
    for (int component = PP_SC; component < PP_COMPONENT_COUNT; component++)
        if (!pp_report_find(report, component, engine->column)
            && !pp_report_add(report, component, engine->column, true))
            return pp_fail_memory(err);
    struct pp_column *columns[PP_COMPONENT_COUNT];
    for (int component = PP_SC; component < PP_COMPONENT_COUNT; component++) {
        columns[component] =
            (struct pp_column *)pp_report_find(report, component, engine->column);
        columns[component]->average = average[component];
        columns[component]->common = common;
        columns[component]->common_near = near;
    }
    for (int i = 0; i < report->receiver_count; i++) {
        solver->read(simulation->run, i, readings);
        for (int component = PP_SC; component < PP_COMPONENT_COUNT; component++)
            columns[component]->points[i] = readings[component];
    }
    if (simulation->error > 0.0 && solver->is_sampled && pp_simulation_done(simulation))
        return say_missed(report, simulation, columns[PP_DF], err);
    return PP_OK;
}

enum pp_status pp_simulation_keep(const struct pp_simulation *simulation, char **bytes,
                                  size_t *length, struct pp_error *err)
{
    *bytes = NULL;
    *length = 0;
    return simulation->solver->keep
               ? simulation->solver->keep(simulation->run, bytes, length, err)
               : PP_OK;
}
