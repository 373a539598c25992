/* photons.h - daylight factors of a room by photons followed from the light sources, as
 * in Genelux [MPF95].
 *
 * Photons enter through the openings, in proportion to the luminance outside and the
 * projected area of the opening, or leave a lamp. They are followed from surface to
 * surface. At each surface their scattered light is added to every receiver
 * (photon_receiver.h); all receivers use the same photons (photon_store.h).
 * Alternatively, photons are counted where they cross a sensor of finite size
 * (photon_counter.h), as always for the average over the working plane. Direct light of
 * openings is a separate estimator, and light not covered by connections a third one
 * (photon_gather.h).
 *
 * The estimators are unbiased, since there is no density estimation with a radius.
 * Transport, directions to openings and the choice of paths are independent of the path
 * tracer. The two engines share only ray intersection and the planning of errors.
 *
 * The caller runs the loop, as with the tracer: create, advance until done, with
 * readings at any time, then destroy. With a target error or a number of samples, the
 * result depends on the world, light, receivers and seed alone, and is bit-identical in
 * every run.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTONS_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTONS_H

#include <stdbool.h>
#include <stdint.h>

#include "model/base/error.h"
#include "model/results/reading.h"
#include "simulate/scene/environment.h"
#include "simulate/scene/light_scene_of_world.h"

struct pp_photons_options {
    double
        error; /* target standard error relative to the daylight factor, at every point;
                * at least 0.00002 of Eh. 0: by samples or the caller's clock alone */
    long
        samples; /* photons per point and randomisation, instead of error; 0: not set */
    uint64_t seed;
    int threads;  /* 0: one for each processor */
    bool average; /* also the average over the working plane */
    double
        sensor_m; /* radius of discs around the receivers on which photons are counted;
                   * 0: the receivers are points */
};

struct pp_photons;

/* Copies the receivers; the scene and its light must outlive the photons. PP_BAD_INPUT
 * if the radius is negative or not finite. */
enum pp_status pp_photons_create(
    struct pp_photons **photons, const struct pp_light_scene *scene,
    const struct pp_environment *environment, const struct pp_receiver *receivers,
    int receiver_count, const struct pp_photons_options *options, struct pp_error *err);

/* Calculates for about `seconds` (by the clock; at least one batch of work). */
enum pp_status pp_photons_advance(struct pp_photons *photons, double seconds,
                                  struct pp_error *err);
bool pp_photons_done(const struct pp_photons *photons);

/* Fraction of the present plan's work that is done, 0 to 1. */
double pp_photons_progress(const struct pp_photons *photons);

/* Largest relative standard error of a daylight factor, over all points so far; NAN
 * before the first value. */
double pp_photons_error(const struct pp_photons *photons);

/* The readings so far of receiver `index`, or of the average over the working plane for
 * index -1: readings[PP_SC] ... readings[PP_DF]. */
void pp_photons_read(const struct pp_photons *photons, int index,
                     struct pp_reading readings[PP_COMPONENT_COUNT]);

/* Correlated fraction of the variance of the receivers' daylight factors, 0 to 1
 * (common_variance.h), due to shared photons: among all receivers; and among
 * neighbours. */
double pp_photons_common(const struct pp_photons *photons);
double pp_photons_common_near(const struct pp_photons *photons);

/* Amount of work done so far. paths: photons, and rays from receivers. rays: all rays.
 * leaks: rays lost in gaps between the edges of two surfaces. */
struct pp_photons_work {
    long long paths, rays, leaks;
};
struct pp_photons_work pp_photons_work(const struct pp_photons *photons);

void pp_photons_destroy(struct pp_photons *photons); /* NULL is allowed */

#endif
