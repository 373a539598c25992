/* irradiance_cache.h - diffuse inter-reflection from irradiance records, calculated at
 * few places and interpolated between them.
 *
 * After Ward, Rubinstein and Clear [WRC88]: the indirect irradiance of diffuse surfaces
 * changes slowly. It is calculated by a hemisphere of rays at requested places that no
 * record covers yet, and stored as a record. Each record has a translational and a
 * rotational gradient [WH92], and an ellipse of validity from the Hessian [SWJ12]. At a
 * place within one or more ellipses, the irradiance is the weighted mean of their
 * records.
 *
 * Direct light (sources, windows) is never stored. The caller requests places, lets the
 * cache grow (cache_grow.h), then reads values:
 *
 *     pp_irradiance_cache_create(&cache, scene, environment, store, &light, &options, err);
 *     pp_cache_grow_request_rays(cache, ray_of, list, ray_count, err);
 *     while (!pp_cache_grow_done(cache))
 *         pp_cache_grow(cache, 0.1, err);
 *     state.ambient = pp_irradiance_cache_ambient(cache);
 */
#ifndef PP_SIMULATE_CACHE_IRRADIANCE_CACHE_H
#define PP_SIMULATE_CACHE_IRRADIANCE_CACHE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "model/base/error.h"
#include "simulate/transport/radiance.h"

/* Options by their usual names; in Radiance -aa, -ar, -ad, -as, -ab, -av, -ai and
 * -ae. */
struct pp_cache_options {
    double accuracy;  /* -aa: above 0 to 1; a smaller value makes records closer */
    int resolution;   /* -ar: least distance of records is the scene's size times
                       * accuracy divided by resolution; 0: no limit */
    int divisions;    /* -ad: rays of a hemisphere, one in each of its cells; 16 or
                       * more, rounded up to a square */
    int supersamples; /* -as: more rays where neighbouring cells differ; 0 or more */
    int bounces;      /* -ab: most diffuse reflections of a path; -1: no limit */
    struct pp_rgb constant; /* -av: radiance that replaces the light of further bounces,
                             * and all light of materials left out */
    const char *const *materials; /* names of materials of the scene; not owned, needed
                                   * only while the cache is created */
    int material_count;
    bool only; /* -ai: only these materials use the cache; false (-ae): all others do */
    uint64_t seed;
    int threads; /* 0: one for each processor */
};

/* accuracy 0.1, resolution 128, divisions 1024, supersamples 256, no limit on bounces,
 * black constant, no material left out, seed 0. */
struct pp_cache_options pp_irradiance_cache_defaults(void);

/* PP_BAD_INPUT with the reason if an option is out of range or a material is not in the
 * scene. */
enum pp_status pp_irradiance_cache_check_options(const struct pp_cache_options *options,
                                                 const struct pp_light_scene *scene,
                                                 struct pp_error *err);

struct pp_irradiance_cache;

/* Creates a cache. scene, environment (of a world; NULL: of a description) and store
 * (may be NULL) must outlive the cache. options->bounces replaces light->bounces.
 * PP_BAD_INPUT if an option is out of range. */
enum pp_status pp_irradiance_cache_create(struct pp_irradiance_cache **cache,
                                          const struct pp_light_scene *scene,
                                          const struct pp_environment *environment,
                                          const struct pp_opening_store *store,
                                          const struct pp_radiance_options *light,
                                          const struct pp_cache_options *options,
                                          struct pp_error *err);
void pp_irradiance_cache_destroy(
    struct pp_irradiance_cache *cache); /* NULL is allowed */

/* Ambient light for struct pp_radiance_state, whose `bounces` must be -1, since the
 * cache ends the paths. The cache owns the result, and must not grow while the result
 * is in use. */
const struct pp_ambient *pp_irradiance_cache_ambient(struct pp_irradiance_cache *cache);

/* The irradiance at a place; false if no record covers it. `depth` as in struct
 * pp_ambient. */
bool pp_irradiance_cache_value(const struct pp_irradiance_cache *cache,
                               struct pp_vec3 point, struct pp_vec3 normal,
                               enum pp_space space, int depth, struct pp_rgb *value);

/* One record, for markers and checks. */
struct pp_cache_record {
    struct pp_vec3 point, normal; /* normal: unit */
    enum pp_space space;
    int depth;                /* 0: for visible surfaces; 1: for surfaces that light the
                               * visible ones */
    struct pp_rgb value;      /* irradiance */
    struct pp_vec3 along[3];  /* red, green, blue: translational gradient, per metre,
                               * in the surface */
    struct pp_vec3 turned[3]; /* the rotational gradient, per radian */
    struct pp_vec3 axes[2];   /* axes of the ellipse, unit, in the surface */
    double radii_m[2];        /* radii along the axes */
};
size_t pp_irradiance_cache_count(const struct pp_irradiance_cache *cache);
struct pp_cache_record pp_irradiance_cache_record(
    const struct pp_irradiance_cache *cache, size_t index);

/* ---- for the other files of simulate/ ---- */

/* Space on the side of the hit surface to which `normal` points. */
enum pp_space pp_irradiance_cache_hit_space(const struct pp_irradiance_cache *cache,
                                            const struct pp_light_hit *hit,
                                            struct pp_vec3 normal);

/* Hash of the options that affect the values of records. */
uint64_t pp_irradiance_cache_hash_options(const struct pp_irradiance_cache *cache);

#endif
