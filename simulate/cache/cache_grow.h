/* cache_grow.h - requests to an irradiance cache, and the calculation of new records
 * until all requests are met.
 *
 * The order of calculation is fixed: records are calculated in batches, all records of
 * a batch from the cache before the batch, and are entered in order. The same scene,
 * options and requests give bit-identical records for any number of threads and any
 * length of the slices.
 */
#ifndef PP_SIMULATE_CACHE_CACHE_GROW_H
#define PP_SIMULATE_CACHE_CACHE_GROW_H

#include "simulate/cache/irradiance_cache.h"

/* Sets *ray to ray `number` (from 0) of a list; false if there is no such ray. May be
 * called by several threads at once. */
typedef bool pp_cache_ray(const void *list, size_t number, struct pp_light_ray *ray);

/* Requests the places needed by `count` rays of a picture, including places seen
 * through glass and in mirrors. The order of the requests determines the order of the
 * records; a scattered order is best, and the function makes one. May be called again,
 * before or after growing; once the cache is done, new requests replace those already
 * met. New records may shrink earlier ones, so a caller that requests in parts must
 * repeat the requests until no new record is made. */
enum pp_status pp_cache_grow_request_rays(struct pp_irradiance_cache *cache,
                                          pp_cache_ray *ray_of, const void *list,
                                          size_t count, struct pp_error *err);

/* Requests the places at depth 1 that the rays of a point's hemisphere need. The point
 * is a sensor point whose own irradiance is not interpolated. normal: unit. */
enum pp_status pp_cache_grow_request_hemisphere(struct pp_irradiance_cache *cache,
                                                struct pp_vec3 point,
                                                struct pp_vec3 normal,
                                                enum pp_space space,
                                                struct pp_error *err);

/* Requests the irradiance of a place, to be interpolated (depth 0). */
enum pp_status pp_cache_grow_request_point(struct pp_irradiance_cache *cache,
                                           struct pp_vec3 point, struct pp_vec3 normal,
                                           enum pp_space space, struct pp_error *err);

/* Calculates for about `seconds`, at least one batch. */
enum pp_status pp_cache_grow(struct pp_irradiance_cache *cache, double seconds,
                             struct pp_error *err);
bool pp_cache_grow_done(const struct pp_irradiance_cache *cache);

/* Progress, 0 to 1: the share of the requests examined so far. */
double pp_cache_grow_progress(const struct pp_irradiance_cache *cache);

#endif
