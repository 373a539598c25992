/* path_tracer.h - daylight factors of a room by plain path tracing.
 *
 * This tracer estimates the same quantities as the fast path tracer
 * (simulate/fast/tracer.h), with the same options and readings. It uses only the loop
 * of path_trace.c, and is therefore slower but easy to verify. Tests compare the two
 * tracers.
 *
 * At a point in a room the daylight factor is the sum of
 *
 *     direct     irradiance through the openings, by next-event estimation: sky
 *                component or externally reflected component, by the first object that
 *                the path meets outside
 *     reflected  pi times the mean radiance over the cosine lobe of the point, without
 *                the direct light: internally reflected component
 *
 * Without a room all light is sampled by the cosine lobe.
 */
#ifndef PP_SIMULATE_PATH_TRACER_PATH_TRACER_H
#define PP_SIMULATE_PATH_TRACER_PATH_TRACER_H

#include <stdbool.h>
#include <stdint.h>

#include "model/base/error.h"
#include "model/results/reading.h"
#include "model/room/world.h"
#include "simulate/scene/environment.h"
#include "simulate/scene/light_scene.h"

struct pp_path_tracer_options {
    double
        error; /* target standard error relative to the daylight factor, at every point;
                * 0: by samples or the caller's clock alone */
    long samples; /* paths per point in each randomisation instead of error; 0: not
                   * set */
    uint64_t seed;
    int threads;  /* 0: one for each processor */
    bool average; /* also the average over the working plane */
};

struct pp_path_tracer;

/* scene: of a world in which every finish is diffuse. Copies the receivers; scene and
 * environment must outlive the tracer. */
enum pp_status pp_path_tracer_create(struct pp_path_tracer **tracer,
                                     const struct pp_light_scene *scene,
                                     const struct pp_environment *environment,
                                     const struct pp_receiver *receivers,
                                     int receiver_count,
                                     const struct pp_path_tracer_options *options,
                                     struct pp_error *err);
void pp_path_tracer_destroy(struct pp_path_tracer *tracer); /* NULL is allowed */

/* Calculates for about `seconds` (by the clock; at least one batch of work). */
enum pp_status pp_path_tracer_advance(struct pp_path_tracer *tracer, double seconds,
                                      struct pp_error *err);
bool pp_path_tracer_done(const struct pp_path_tracer *tracer);

/* pp_path_tracer_progress: fraction of the work that is done, 0 to 1.
 * pp_path_tracer_error: largest relative standard error of a daylight factor at any
 * point so far; NAN if no value is known yet. */
double pp_path_tracer_progress(const struct pp_path_tracer *tracer);
double pp_path_tracer_error(const struct pp_path_tracer *tracer);

/* readings[PP_SC] ... readings[PP_DF] of receiver `index`, or of the average over the
 * working plane for index -1. */
void pp_path_tracer_read(const struct pp_path_tracer *tracer, int index,
                         struct pp_reading readings[PP_COMPONENT_COUNT]);

#endif
