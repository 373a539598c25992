/* cache_parts.h - the data of an irradiance cache. Inside simulate/ only. */
#ifndef PP_SIMULATE_CACHE_CACHE_PARTS_H
#define PP_SIMULATE_CACHE_CACHE_PARTS_H

#include "model/base/thread_pool.h"
#include "simulate/cache/cache_layer.h"

enum {
    PP_CACHE_DEPTHS = 2, /* 0: records of visible surfaces; 1: records of surfaces that
                          * light the visible ones */
    PP_CACHE_BATCH = 32  /* records calculated from the same state of the cache */
};

struct pp_irradiance_cache {
    const struct pp_light_scene *scene;       /* not owned */
    const struct pp_environment *environment; /* not owned; NULL: scene from a
                                               * description */
    const struct pp_opening_store *store;     /* not owned; may be NULL */
    struct pp_radiance_options light;
    struct pp_cache_options options;
    struct pp_thread_pool *pool;
    bool *left_out; /* by material */
    double size_m;  /* size of the scene, or of its room */
    struct pp_sobol sobol;
    struct pp_cache_layer layers[PP_CACHE_DEPTHS];
    int expanded; /* number of requests of depth 0 for which requests of depth 1 were
                   * made */
    int expanded_rays; /* rays traced so far for requests of depth 1 */
    struct pp_ambient ambient;
};

#endif
