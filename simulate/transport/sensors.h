/* sensors.h - irradiance at sensor points of any light scene, by unbiased path tracing.
 *
 * The caller runs the loop, as with the tracer: create, advance until done, with
 * readings at any time, then destroy. The result depends on the scene, points, options
 * and seed alone. It is bit-identical for any number of threads and any duration of the
 * calls.
 *
 * The planner of simulate/estimate plans each point for a target standard error of the
 * luminance-weighted irradiance. The target is the largest of
 *
 *     error x value,  error x 0.001 of the largest value,  0.00002 of the open sky
 *
 * Seeds depend on a point's position in space, not on its index in the list. The stated
 * error includes a bound on the light that all paths may have missed because only rays
 * can find it (a small glow, a lamp in a curved mirror: unsampled.h).
 */
#ifndef PP_SIMULATE_TRANSPORT_SENSORS_H
#define PP_SIMULATE_TRANSPORT_SENSORS_H

#include <stdbool.h>
#include <stdint.h>

#include "model/light/rgb.h"
#include "simulate/scene/light_scene.h"

struct pp_sensor {
    struct pp_vec3 position, normal; /* normal: unit */
    int line;                        /* line number of the point in its file */
};

struct pp_sensors_options {
    double error; /* target standard error relative to the value. 0: by samples or the
                   * caller's clock alone */
    long samples; /* paths per point in each randomisation; 0: not set */
    uint64_t seed;
    int threads;        /* 0: one for each processor */
    double horizontal;  /* irradiance of open horizontal ground; 0: unknown */
    bool limited;       /* at most `bounces` (0 or more) diffuse reflections of a path,
                         * including those outside */
    bool ground_counts; /* reflections by the ground also count */
    int bounces;
    bool by_chance; /* no next-event estimation: only rays find concentrated sources */
};

struct pp_sensor_reading {
    struct pp_rgb irradiance, std_error; /* NAN if not known yet */
    double grey, grey_error;             /* luminance-weighted */
};

struct pp_sensors;

/* scene and environment (of a world; NULL: of a description) must outlive the
 * sensors. */
enum pp_status pp_sensors_create(struct pp_sensors **sensors,
                                 const struct pp_light_scene *scene,
                                 const struct pp_environment *environment,
                                 const struct pp_sensor *list, int count,
                                 const struct pp_sensors_options *options,
                                 struct pp_error *err);
void pp_sensors_destroy(struct pp_sensors *sensors); /* NULL is allowed */

/* Calculates for about `seconds` (by the clock; at least one batch of work). */
enum pp_status pp_sensors_advance(struct pp_sensors *sensors, double seconds,
                                  struct pp_error *err);
bool pp_sensors_done(const struct pp_sensors *sensors);

/* pp_sensors_progress: fraction of the present plan's work that is done, 0 to 1.
 * pp_sensors_error: largest relative standard error so far; NAN if no value is known
 * yet. */
double pp_sensors_progress(const struct pp_sensors *sensors);
double pp_sensors_error(const struct pp_sensors *sensors);

struct pp_sensor_reading pp_sensors_read(const struct pp_sensors *sensors, int index);

#endif
