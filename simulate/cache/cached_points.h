/* cached_points.h - daylight factors at a room's points, with the interreflected light
 * taken from an irradiance cache.
 *
 * Light from the sky and from surfaces outside is sampled at the point itself, by
 * next-event estimation of the windows, and never interpolated. Internally reflected
 * light is sampled by a hemisphere of rays at the point; the irradiance of the surfaces
 * that the rays meet is read from the cache (depth 1).
 *
 * The point's own irradiance is read from the cache (depth 0) only on request. Without
 * bounces a cache has no reflected light except its ambient constant. The standard
 * error applies to the sampling at the point, from 32 independent randomisations. It
 * does not include errors of the cache. Interpolated values (PP_IRC and PP_DF of such a
 * point) have no standard error.
 */
#ifndef PP_SIMULATE_CACHE_CACHED_POINTS_H
#define PP_SIMULATE_CACHE_CACHED_POINTS_H

#include "model/results/reading.h"
#include "model/room/world.h"
#include "simulate/cache/irradiance_cache.h"

struct pp_cached_options {
    double error; /* target standard error relative to the daylight factor, at least
                   * 0.00002 of Eh; 0: samples are given */
    long samples; /* paths in each randomisation instead; 0: not set */
    bool average; /* the average over the working plane as well */
    bool interpolate;
    uint64_t seed;
    int threads; /* 0: one for each processor */
};

struct pp_cached_points;

/* Copies the needed data of the receivers, and requests the places that they need from
 * the cache. The points are lit by the environment of the cache. scene (of a world),
 * store (may be NULL) and cache must outlive the points. PP_BAD_INPUT if the number of
 * samples is out of range. */
enum pp_status pp_cached_points_create(
    struct pp_cached_points **points, const struct pp_light_scene *scene,
    const struct pp_opening_store *store, struct pp_irradiance_cache *cache,
    const struct pp_receiver *receivers, int receiver_count,
    const struct pp_cached_options *options, struct pp_error *err);
void pp_cached_points_destroy(struct pp_cached_points *points); /* NULL is allowed */

/* Calculates for about `seconds`: first the cache grows, then the points are
 * sampled. */
enum pp_status pp_cached_points_advance(struct pp_cached_points *points, double seconds,
                                        struct pp_error *err);
bool pp_cached_points_done(const struct pp_cached_points *points);
double pp_cached_points_progress(const struct pp_cached_points *points); /* 0 to 1 */

/* Largest standard error of the sampled values relative to the daylight factor, over
 * all points; NAN before the first value. */
double pp_cached_points_error(const struct pp_cached_points *points);

/* readings[PP_SC] ... readings[PP_DF] of receiver `index`, or of the average for -1. */
void pp_cached_points_read(const struct pp_cached_points *points, int index,
                           struct pp_reading readings[PP_COMPONENT_COUNT]);

/* The options of transport for the points, and for the cache that they read. */
struct pp_radiance_options pp_cached_points_light(void);

#endif
