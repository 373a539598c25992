/* cache_parts.h - what is inside an irradiance cache. Inside simulate/ only. */
#ifndef PP_SIMULATE_CACHE_CACHE_PARTS_H
#define PP_SIMULATE_CACHE_CACHE_PARTS_H

#include "simulate/cache/cache_octree.h"
#include "simulate/cache/cache_record.h"

enum {
    PP_CACHE_DEPTHS = 2, /* records for what is seen; for what lights that */
    PP_CACHE_BATCH = 32  /* records worked out from the same state of the cache */
};

struct pp_cache_request {
    struct pp_cache_place place;
    float guess_m; /* how large a record there may be, once it was asked in vain */
};

/* All of one depth. */
struct pp_cache_layer {
    struct pp_cache_record_settings settings;
    struct pp_vec3 *corners;
    struct pp_cache_entry *entries;
    int entry_count, entry_space;
    struct pp_cache_octree tree;

    struct pp_cache_request *requests; /* those not looked at yet from `next` on */
    size_t request_count, request_space, next;
    int *open; /* of the chunk of requests at hand: which are not covered */
    int open_count;
    bool again; /* have records come in since the first request was looked at? */
};

struct pp_irradiance_cache {
    const struct pp_light_scene *scene;  /* not owned */
    const struct pp_window_store *store; /* not owned; may be NULL */
    struct pp_radiance_options light;
    struct pp_cache_options options;
    bool *left_out; /* by material */
    double size_m;  /* of the scene, or of its room */
    struct pp_sobol sobol;
    struct pp_cache_layer layers[PP_CACHE_DEPTHS];
    size_t spread; /* requests of depth 0 whose surroundings have been wished for */
    size_t spread_rays; /* that have been sent for it */
    struct pp_ambient ambient;
};

/* Fits an entry in: limits its radii and its neighbours' by each other's [KBPZ06], and
 * puts it in the tree. */
enum pp_status pp_cache_layer_add(struct pp_cache_layer *layer,
                                  const struct pp_cache_entry *entry,
                                  struct pp_error *err);

/* Puts it in as it is. */
enum pp_status pp_cache_layer_put(struct pp_cache_layer *layer,
                                  const struct pp_cache_entry *entry,
                                  struct pp_error *err);

/* The tree made anew from the radii as they are now, so that a cache that was read from
 * a file adds in the same order. */
enum pp_status pp_cache_layer_rebuild_tree(struct pp_cache_layer *layer,
                                           struct pp_error *err);

/* Lets all records agree with their neighbours, whatever they have agreed on before:
 * cache_smooth.c. */
enum pp_status pp_cache_smooth_layer(struct pp_cache_layer *layer,
                                     struct pp_error *err);

/* Weighted mean of the records that are good there. Where none is: false, and *guess_m
 * (may be NULL) is the smaller radius of the nearest by its own measure, or 0. */
bool pp_cache_layer_read(const struct pp_cache_layer *layer,
                         const struct pp_cache_place *place, struct pp_rgb *value,
                         double *guess_m);

/* The space on the side of a hit that `normal` is on. */
enum pp_space pp_cache_grow_hit_space(const struct pp_irradiance_cache *cache,
                                      const struct pp_light_hit *hit,
                                      struct pp_vec3 normal);

/* A number that hangs on the options that decide what a record says. */
uint64_t pp_irradiance_cache_hash_options(const struct pp_irradiance_cache *cache);

#endif
