/* cache_grow.h - requests to an irradiance cache, and the calculation of new records
 * until all requests are met.
 *
 * The order of calculation is fixed. Records are calculated in batches. All records of
 * a batch are calculated from the state of the cache before the batch, and are entered
 * in order. The same scene, options and requests give bit-identical records for any
 * number of threads and any duration of the calls.
 */
#ifndef PP_SIMULATE_CACHE_CACHE_GROW_H
#define PP_SIMULATE_CACHE_CACHE_GROW_H

#include "simulate/cache/irradiance_cache.h"

/* Sets *ray to ray `number` (from 0) of a list; false if there is no such ray. May be
 * called by several threads at once. */
typedef bool pp_cache_ray(const void *list, size_t number, struct pp_light_ray *ray);

/* Requests the places needed by `count` rays of a picture, including places seen
 * through glass and in mirrors. The order of the requests determines the order of the
 * records. The function shuffles the requests, since a scattered order is best. May be
 * called again, before or after growing; once the cache is done, new requests replace
 * those already met. New records may reduce the radii of earlier ones. A caller that
 * requests in parts must therefore repeat the requests until no new record is made. */
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

/* Calculates for about `seconds`, at least one step: a batch of records, or a search
 * for open requests. */
enum pp_status pp_cache_grow(struct pp_irradiance_cache *cache, double seconds,
                             struct pp_error *err);
bool pp_cache_grow_done(const struct pp_irradiance_cache *cache);

/* Progress, 0 to 1, estimated from the number of requests examined so far. */
double pp_cache_grow_progress(const struct pp_irradiance_cache *cache);

#endif
