/* traced_windows.c - see traced_windows.h. */
#include "studies/criteria/windows/traced_windows.h"

#include <math.h>
#include <stdlib.h>

#include "methods/exact/exterior.h"
#include "model/base/clock.h"
#include "simulate/scene/environment.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/transport/sensors.h"
#include "studies/criteria/windows/vertical_sky.h"

/* Distance (m) of the simulated point from the outside of the window. */
static const double OFF_M = 1e-3;

/* Longest time (s) between two calls of the watch. */
static const double SLICE_S = 0.1;

/* Points on the outsides of the vertical openings. Returns their number. */
static int place_sensors(struct pp_sensor *list, const struct pp_world *world)
{
    int count = 0;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        if (!pp_vertical_sky_is_upright(opening))
            continue;
        struct pp_vec3 out = pp_vec_scale(opening->inner.normal, -1.0);
        list[count++] = (struct pp_sensor){
            pp_vec_along(pp_exterior_opening_centroid(opening), OFF_M, out), out,
            opening->line};
    }
    return count;
}

static enum pp_status advance_sensors(struct pp_sensors *sensors, const char *name,
                                      const struct pp_study_options *study,
                                      bool *finished, bool *by_clock,
                                      struct pp_error *err)
{
    const struct pp_watch *watch = &study->watch;
    double begun_s = pp_clock_s();
    enum pp_status status = PP_OK;
    if (watch->begin)
        watch->begin(watch->data, name ? name : "windows");
    while (status == PP_OK && !pp_sensors_done(sensors)) {
        status = pp_sensors_advance(sensors, SLICE_S, err);
        if (watch->look
            && !watch->look(watch->data, pp_sensors_progress(sensors), NAN)) {
            *finished = false;
            break;
        }
        if (study->seconds > 0.0 && pp_clock_s() - begun_s > study->seconds) {
            *by_clock = true;
            break;
        }
    }
    if (watch->end)
        watch->end(watch->data);
    return status;
}

static enum pp_status trace_sensors(struct pp_sensor_reading *found,
                                    const struct pp_sensor *list, int count,
                                    const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const struct pp_study_options *study,
                                    bool *finished, bool *by_clock,
                                    struct pp_error *err)
{
    struct pp_light_scene *scene = NULL;
    struct pp_environment *environment = NULL;
    struct pp_sensors *sensors = NULL;
    const struct pp_sensors_options options = {.error = study->error,
                                               .samples = study->samples,
                                               .seed = study->seed,
                                               .threads = study->threads};
    enum pp_status status = pp_light_scene_of_world_matt(&scene, world, err);
    if (status == PP_OK)
        status = pp_light_scene_under(&environment, scene, light, err);
    if (status == PP_OK)
        status =
            pp_sensors_create(&sensors, scene, environment, list, count, &options, err);
    if (status == PP_OK)
        status = advance_sensors(sensors, world->name, study, finished, by_clock, err);
    for (int i = 0; i < count && status == PP_OK; i++)
        found[i] = pp_sensors_read(sensors, i);
    pp_sensors_destroy(sensors);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    return status;
}

enum pp_status pp_traced_windows_light(struct pp_reading **readings,
                                       const struct pp_world *world,
                                       const struct pp_outside_light *light,
                                       const struct pp_study_options *study,
                                       bool *finished, bool *by_clock,
                                       struct pp_error *err)
{
    size_t space = (size_t)world->opening_count + 1;
    struct pp_sensor *list = calloc(space, sizeof *list);
    struct pp_sensor_reading *found = calloc(space, sizeof *found);
    *readings = calloc(space, sizeof **readings);
    enum pp_status status = list && found && *readings ? PP_OK : pp_fail_memory(err);
    int count = status == PP_OK ? place_sensors(list, world) : 0;
    if (count > 0)
        status = trace_sensors(found, list, count, world, light, study, finished,
                               by_clock, err);
    for (int i = 0, k = 0; i < world->opening_count && status == PP_OK; i++) {
        (*readings)[i] = pp_reading_none(NULL);
        if (!pp_vertical_sky_is_upright(&world->openings[i]))
            continue;
        (*readings)[i] = pp_reading_of(found[k].grey);
        (*readings)[i].std_error = found[k++].grey_error;
    }
    free(list);
    free(found);
    return status;
}
