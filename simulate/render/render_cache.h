/* render_cache.h - the records of the irradiance cache that was used for a picture. */
#ifndef PP_SIMULATE_RENDER_RENDER_CACHE_H
#define PP_SIMULATE_RENDER_RENDER_CACHE_H

#include "simulate/render/render.h"

/* A number that depends on all records of a cache, for ambient_hash. */
uint64_t pp_render_cache_hash(const struct pp_irradiance_cache *cache);

/* Positions in the picture (pixels) of those records of depth 0 that are directly
 * visible, not only through glass. The caller frees *xy. */
enum pp_status pp_render_cache_positions(const struct pp_render *render,
                                         const struct pp_irradiance_cache *cache,
                                         double (**xy)[2], int *count,
                                         struct pp_error *err);

#endif
