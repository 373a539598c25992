/* radiance.h - light along a ray and on a surface, by unbiased path tracing.
 *
 * A path is one sample: what is asked for is the mean over paths index = 0, 1, 2, ...
 * of one sequence (sobol.h), best over a power of two of them. Sequences with other
 * seeds are independent: their spread is the standard error.
 *
 * Light is hunted by its kind. At every surface that scatters,
 *
 *     sources   concentrated emitters and the sun are aimed at: the nearer and larger
 *               one is, the more directions (the power of two that makes each part
 *               look smaller than `source_size` times its distance)
 *     windows   so are the panes of a world's openings, as lamps whose light is what
 *               the sky, the ground and whatever stands outside send through them
 *     the rest  extended emitters, sky, ground and all that is lit are found by rays
 *               that go where the surface scatters
 *
 * Each of the first two can be switched off: then that light too is found by chance.
 * The mean is the same; noise and time are not.
 *
 * Diffuse inter-reflection, the dearest part, may be had from elsewhere: see
 * struct pp_ambient.
 */
#ifndef PP_SIMULATE_TRANSPORT_RADIANCE_H
#define PP_SIMULATE_TRANSPORT_RADIANCE_H

#include <stdbool.h>
#include <stdint.h>

#include "model/light/rgb.h"
#include "simulate/scene/light_scene.h"
#include "simulate/sampling/sobol.h"

/* Indirect irradiance of diffuse surfaces from elsewhere (a cache).
 *
 * `irradiance` is asked at a hit whose material is diffuse (on the side of its normal,
 * or, of a translucent one, on the far side: then `normal` is turned) for the
 * irradiance from all that is not aimed at: what pp_radiance_indirect gives the
 * hemispherical integral of. `depth` is how many diffuse reflections the path has
 * behind it, 0 at the first surface. It returns false where the path is to find out by
 * itself. Called by many threads at a time. */
struct pp_ambient {
    bool (*irradiance)(void *store, const struct pp_light_hit *hit,
                       struct pp_vec3 normal, int depth, struct pp_rgb *value);
    void *store; /* not owned */
};

struct pp_radiance_options {
    bool sources; /* concentrated emitters are aimed at */
    bool windows; /* openings are aimed at */
    bool stored;  /* what surfaces outside send through an opening is worked out once
                   * (window_store.h), not followed along each path */
    double source_size; /* of a part over its distance; 0: one direction a source */
    int source_most;    /* directions to one source or window, at most; for n paths a
                         * pixel about 64/n is enough */
    int bounces;        /* diffuse reflections on the way, at most; -1: no limit but
                         * Russian roulette, without bias */
    double least;       /* Russian roulette below this share of a path's first weight,
                         * of a gloss and the like below a tenth of it; greater than 0 */
};

/* Everything on, unbiased but for `stored`: 0.2 of the distance, at most 64 directions,
 * no limit of bounces, 0.3. */
struct pp_radiance_options pp_radiance_defaults(void);

struct pp_window_store;

/* What a thread needs to follow light. Fill the first part, then draw. */
struct pp_radiance_state {
    const struct pp_light_scene *scene; /* not owned */
    struct pp_radiance_options options;
    const struct pp_window_store *store; /* not owned; NULL: as if not `stored` */
    const struct pp_ambient *ambient;    /* not owned; NULL: none */
    struct pp_sobol_sequence sequence;   /* the randomisation */
    uint32_t index;                      /* which path of it */

    long rays;  /* traced so far */
    long leaks; /* of them, lost through cracks */
};

/* Radiance that comes along the ray, by one path. *hit (may be NULL) is what the ray
 * meets first, glass included. */
struct pp_rgb pp_radiance_along(struct pp_radiance_state *state,
                                const struct pp_light_ray *ray,
                                struct pp_light_hit *hit);

/* The same without what is aimed at from where the ray starts: sources and windows seen
 * straight or through clear glass. */
struct pp_rgb pp_radiance_indirect(struct pp_radiance_state *state,
                                   const struct pp_light_ray *ray,
                                   struct pp_light_hit *hit);

/* Irradiance at a point, one sample of each part. */
struct pp_irradiance {
    struct pp_rgb sources; /* concentrated emitters */
    struct pp_rgb sky; /* through windows that are aimed at, straight from the sky */
    struct pp_rgb outside; /* the same, from ground, skylines and surfaces outside */
    struct pp_rgb rest;    /* all else: pi times pp_radiance_indirect over the lobe */
};

/* normal: unit; space: pp_light_scene_space of the point. `direct` gives the first
 * three only. With `ambient`, `rest` is still sampled at the point itself and the store
 * asked from the next surface on: at depth 1. */
struct pp_irradiance pp_radiance_direct(struct pp_radiance_state *state,
                                        struct pp_vec3 point, struct pp_vec3 normal,
                                        enum pp_space space);
struct pp_irradiance pp_radiance_irradiance(struct pp_radiance_state *state,
                                            struct pp_vec3 point, struct pp_vec3 normal,
                                            enum pp_space space);

/* What surfaces outside send through each opening, worked out once: by patches of the
 * opening, the smaller the nearer something stands, and by direction (window_store.h).
 * What stands nearer than patches can tell apart is not in it. NULL where there is
 * nothing to work out. The same for any number of threads (0: all there are). */
enum pp_status pp_window_store_create(struct pp_window_store **store,
                                      const struct pp_light_scene *scene, uint64_t seed,
                                      int threads, struct pp_error *err);
void pp_window_store_destroy(struct pp_window_store *store); /* NULL is allowed */

#endif
