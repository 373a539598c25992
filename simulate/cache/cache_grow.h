/* cache_grow.h - requests to an irradiance cache, and how it grows until they are met.
 *
 * The cache grows in a fixed order: in batches whose records are all calculated from
 * the cache before the batch, and entered in order. The same scene, options and
 * requests give the same records to the bit, for any number of threads and length of
 * the slices.
 */
#ifndef PP_SIMULATE_CACHE_CACHE_GROW_H
#define PP_SIMULATE_CACHE_CACHE_GROW_H

#include "simulate/cache/irradiance_cache.h"

/* The ray of that number of a list, from 0; false: there is none. Several threads may ask
 * at the same time. */
typedef bool pp_cache_ray(const void *list, size_t number, struct pp_light_ray *ray);

/* Requests the places that `count` rays of a picture need, through glass and by mirrors
 * too. Their order decides that of the records: a scattered one is best, and is made
 * here. May be called again, before or after growing. Once the cache is done, new
 * requests replace those already met. The new records may shrink earlier ones: a caller
 * that requests in parts must repeat until no new record is made. */
enum pp_status pp_cache_grow_request_rays(struct pp_irradiance_cache *cache,
                                          pp_cache_ray *ray_of, const void *list,
                                          size_t count, struct pp_error *err);

/* Requests the places that rays from a point's hemisphere need at depth 1 (a sensor
 * point, whose own irradiance is not interpolated). normal: unit. */
enum pp_status pp_cache_grow_request_hemisphere(struct pp_irradiance_cache *cache,
                                                struct pp_vec3 point,
                                                struct pp_vec3 normal,
                                                enum pp_space space,
                                                struct pp_error *err);

/* Requests the irradiance of a place itself, to be interpolated (depth 0). */
enum pp_status pp_cache_grow_request_point(struct pp_irradiance_cache *cache,
                                           struct pp_vec3 point, struct pp_vec3 normal,
                                           enum pp_space space, struct pp_error *err);

/* Works for about `seconds`, at least one batch. */
enum pp_status pp_cache_grow(struct pp_irradiance_cache *cache, double seconds,
                             struct pp_error *err);
bool pp_cache_grow_done(const struct pp_irradiance_cache *cache);

/* Progress, 0 to 1, by the requests examined so far. */
double pp_cache_grow_progress(const struct pp_irradiance_cache *cache);

#endif
