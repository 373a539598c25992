/* tracer.h - daylight factors of a room by unbiased path tracing.
 *
 * The caller runs the loop: create, advance until done, with readings at any time, then
 * destroy.
 *
 *     while (!pp_tracer_done(tracer))
 *         if (pp_tracer_advance(tracer, 0.1, err) != PP_OK) ...
 *
 * With --error or --samples, the result depends on the world, light, receivers and seed
 * alone. It is bit-identical for any number of threads and any duration of the calls.
 */
#ifndef PP_SIMULATE_FAST_TRACER_H
#define PP_SIMULATE_FAST_TRACER_H

#include <stdbool.h>
#include <stdint.h>

#include "model/base/error.h"
#include "model/results/reading.h"
#include "simulate/scene/environment.h"
#include "simulate/scene/light_scene_of_world.h"

/* Smallest target standard error, over Eh: 0.002 % daylight factor. */
#define PP_TRACER_LEAST_ERROR 0.00002

struct pp_tracer_options {
    double
        error; /* target standard error relative to the daylight factor, at every point;
                * at least PP_TRACER_LEAST_ERROR of Eh. 0: by samples or the caller's
                * clock alone */
    long samples; /* paths per point in each randomisation instead of error; 0: not
                   * set */
    uint64_t seed;
    int threads;    /* 0: one for each processor */
    bool average;   /* also the average over the working plane */
    bool alone;     /* points share no light: faster for up to ten points at an error of
                     * 1 % */
    bool direct;    /* sky and externally reflected component only; the target error is
                     * for their sum, and no other reading is valid */
    bool every_ray; /* also trace rays whose result is known in advance (for checks) */
};

struct pp_tracer;

/* Copies the receivers; the scene and its light must outlive the tracer. */
enum pp_status pp_tracer_create(struct pp_tracer **tracer,
                                const struct pp_light_scene *scene,
                                const struct pp_environment *environment,
                                const struct pp_receiver *receivers, int receiver_count,
                                const struct pp_tracer_options *options,
                                struct pp_error *err);

/* Calculates for about `seconds` (by the clock; at least one batch of work). */
enum pp_status pp_tracer_advance(struct pp_tracer *tracer, double seconds,
                                 struct pp_error *err);
bool pp_tracer_done(const struct pp_tracer *tracer);

/* Fraction of the present plan's work that is done, 0 to 1. */
double pp_tracer_progress(const struct pp_tracer *tracer);

/* Largest relative standard error of a daylight factor at any point so far; NAN if no
 * value is known yet. */
double pp_tracer_error(const struct pp_tracer *tracer);

/* The readings so far of receiver `index`, or of the average over the working plane
 * for index -1: readings[PP_SC] ... readings[PP_DF]. */
void pp_tracer_read(const struct pp_tracer *tracer, int index,
                    struct pp_reading readings[PP_COMPONENT_COUNT]);

/* Amount of work done so far. A leak is a ray that left the room through a gap between
 * the edges of two surfaces and was abandoned. */
struct pp_tracer_work {
    long long paths, rays, leaks;
};
struct pp_tracer_work pp_tracer_work(const struct pp_tracer *tracer);

/* Correlated fraction of the variance of the receivers' daylight factors, 0 to 1
 * (common_variance.h): among all receivers, and among neighbours. Neighbours get the
 * same light from shared points. The fraction among neighbours is therefore much larger
 * if this light causes most of the variance. */
double pp_tracer_common(const struct pp_tracer *tracer);
double pp_tracer_common_near(const struct pp_tracer *tracer);

void pp_tracer_destroy(struct pp_tracer *tracer); /* NULL is allowed */

#endif
