/* irradiance_cache.h - diffuse inter-reflection, worked out at few places and read
 * between them.
 *
 * After Ward, Rubinstein and Clear [WRC88]: the indirect irradiance of diffuse surfaces
 * changes slowly, so it is worked out where it is wanted and nothing near is known yet,
 * by a hemisphere of rays, and kept as a record. Each record has its change with
 * position and with the normal [WH92] and an ellipse within which it is good, from the
 * second derivatives [SWJ12]; elsewhere within such ellipses it is the weighted mean of
 * what the records there say. Light that is aimed at (sources, windows) is never kept.
 *
 * The caller says what it will look at, then lets the cache grow, then reads it:
 *
 *     pp_irradiance_cache_create(&cache, scene, store, &light, &options, err);
 *     pp_cache_grow_request_rays(cache, rays, ray_count, err);
 *     while (!pp_cache_grow_done(cache))
 *         pp_cache_grow(cache, 0.1, err);
 *     state.ambient = pp_irradiance_cache_ambient(cache);
 *
 * It grows in a fixed order: in batches whose points are all worked out from the cache
 * as it was before, and entered in their order. The same scene, options and requests give
 * the same records to the bit, for any number of threads and length of the slices.
 */
#ifndef PP_SIMULATE_CACHE_IRRADIANCE_CACHE_H
#define PP_SIMULATE_CACHE_IRRADIANCE_CACHE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "model/base/error.h"
#include "simulate/transport/radiance.h"

/* Named as the field knows them; in Radiance's letters -aa, -ar, -ad, -as, -ab, -av,
 * -ai and -ae. */
struct pp_cache_options {
    double accuracy;  /* -aa: the smaller, the nearer records stand; above 0 to 1 */
    int resolution;   /* -ar: records come no nearer to each other than the scene's
                       * size times accuracy over resolution; 0: no limit */
    int divisions;    /* -ad: rays of a hemisphere, one in each of its cells; 16 up,
                       * rounded up to a square */
    int supersamples; /* -as: more rays where neighbouring cells differ; 0 up */
    int bounces;      /* -ab: diffuse reflections on the way, at most; -1: no limit */
    struct pp_rgb constant; /* -av: radiance that stands for what is beyond the last
                             * bounce, and for all of materials left out */
    const char *const *materials; /* by name, as the scene names them; not owned, copied
                                   * by create */
    int material_count;
    bool only; /* -ai: only these take part; else (-ae) these do not */
    uint64_t seed;
    int threads; /* 0: as many as the machine has processors */
};

/* 0.1, 128, 1024, 256, -1, black, none left out, seed 0. */
struct pp_cache_options pp_irradiance_cache_defaults(void);

/* PP_BAD_INPUT with a sentence where they make no sense, also where a material is not
 * one of the scene's. */
enum pp_status pp_irradiance_cache_check_options(const struct pp_cache_options *options,
                                                 const struct pp_light_scene *scene,
                                                 struct pp_error *err);

struct pp_irradiance_cache;

/* scene and store (may be NULL) must live as long as the cache. Of `light`, `bounces`
 * is not looked at: options->bounces counts. Checks options. */
enum pp_status pp_irradiance_cache_create(struct pp_irradiance_cache **cache,
                                          const struct pp_light_scene *scene,
                                          const struct pp_window_store *store,
                                          const struct pp_radiance_options *light,
                                          const struct pp_cache_options *options,
                                          struct pp_error *err);
void pp_irradiance_cache_destroy(
    struct pp_irradiance_cache *cache); /* NULL is allowed */

/* Requests: what the rays of a picture will ask for, through glass and by mirrors too.
 * Their order decides that of the records: a scattered one is best, and is made here.
 * May be called again, before or after growing; once the cache is done, it forgets the
 * requests that it has met when new ones come. What is made for these may shrink earlier
 * records: whoever requests in parts does so until nothing new is made. */
enum pp_status pp_cache_grow_request_rays(struct pp_irradiance_cache *cache,
                                          const struct pp_light_ray *rays, size_t count,
                                          struct pp_error *err);

/* Requests: what rays from a point's hemisphere will ask for at depth 1 (a sensor point,
 * whose own irradiance is not interpolated). normal: unit. */
enum pp_status pp_cache_grow_request_hemisphere(struct pp_irradiance_cache *cache,
                                                struct pp_vec3 point,
                                                struct pp_vec3 normal,
                                                enum pp_space space,
                                                struct pp_error *err);

/* A request: the irradiance of a place itself, to be interpolated (depth 0). */
enum pp_status pp_cache_grow_request_point(struct pp_irradiance_cache *cache,
                                           struct pp_vec3 point, struct pp_vec3 normal,
                                           enum pp_space space, struct pp_error *err);

/* Works for about `seconds`, at least one batch. */
enum pp_status pp_cache_grow(struct pp_irradiance_cache *cache, double seconds,
                             struct pp_error *err);
bool pp_cache_grow_done(const struct pp_irradiance_cache *cache);

/* 0 to 1, by the requests looked at so far. */
double pp_cache_grow_progress(const struct pp_irradiance_cache *cache);

/* For struct pp_radiance_state, with `bounces` -1 there: the cache ends the paths. While
 * it is read it must not grow. Belongs to the cache. */
const struct pp_ambient *pp_irradiance_cache_ambient(struct pp_irradiance_cache *cache);

/* What is known of a place; false where no record is near enough. `depth` as in struct
 * pp_ambient. */
bool pp_irradiance_cache_value(const struct pp_irradiance_cache *cache,
                               struct pp_vec3 point, struct pp_vec3 normal,
                               enum pp_space space, int depth, struct pp_rgb *value);

/* One of the records, for markers and checks. */
struct pp_cache_record {
    struct pp_vec3 point, normal; /* normal: unit */
    enum pp_space space;
    int depth;                /* 0: made for what is seen; 1: for what lights that */
    struct pp_rgb value;      /* irradiance */
    struct pp_vec3 along[3];  /* of red, green, blue: its change per metre, in the
                               * surface */
    struct pp_vec3 turned[3]; /* and with the normal, per radian */
    struct pp_vec3 axes[2];   /* of the ellipse, unit, in the surface */
    double radii_m[2];        /* along them */
};
size_t pp_irradiance_cache_count(const struct pp_irradiance_cache *cache);
struct pp_cache_record pp_irradiance_cache_record(
    const struct pp_irradiance_cache *cache, size_t index);

/* ---- files: cache_file.c ---- */

/* The records as a file has them; *bytes is the caller's to free. */
enum pp_status pp_cache_file_pack(const struct pp_irradiance_cache *cache, char **bytes,
                                  size_t *length, struct pp_error *err);

/* Gives a cache that has no records those of a file; `title` is what messages call it.
 * PP_BAD_INPUT, and the cache is as before, if it is cut off, damaged, of another
 * version, or of another scene or other options. */
enum pp_status pp_cache_file_unpack(struct pp_irradiance_cache *cache,
                                    const char *bytes, size_t length, const char *title,
                                    struct pp_error *err);

#endif
