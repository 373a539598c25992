/* radiance_state.h - state of a thread that traces paths, and its rays. */
#ifndef PP_SIMULATE_TRANSPORT_RADIANCE_STATE_H
#define PP_SIMULATE_TRANSPORT_RADIANCE_STATE_H

#include <stdbool.h>
#include <stdint.h>

#include "model/light/rgb.h"
#include "simulate/sampling/sample_polygon.h"
#include "simulate/sampling/sobol.h"
#include "simulate/scene/light_scene.h"
#include "simulate/scene/openings.h"

/* Estimators of the light transport, and when paths end. */
struct pp_radiance_options {
    bool sources;       /* next-event estimation of concentrated emitters */
    bool windows;       /* next-event estimation of openings */
    bool stored;        /* read the radiance of surfaces outside from a store
                         * (opening_store.h) instead of tracing it along each path */
    double source_size; /* angular size (size divided by distance) to which a source or
                         * window is stratified at a path's first scattering surface; 0:
                         * one direction per source */
    int source_most;    /* limit on the directions to one source or window; for n paths
                         * per pixel about 64/n are enough */
    int bounces;        /* limit on the diffuse reflections of a path; -1: no limit
                         * except Russian roulette, which has no bias */
    bool ground_counts; /* reflections by the ground count as bounces */
    double least;       /* throughput below which Russian roulette begins, above 0;
                         * after gloss, mirror, clear glass and the ground, a tenth
                         * of this value */
};

/* All estimators on, no limit on bounces; unbiased except for `stored`. Source size
 * 0.2, at most 64 directions, Russian roulette below 0.3. */
struct pp_radiance_options pp_radiance_state_defaults(void);

/* Indirect irradiance of diffuse surfaces from an external store such as a cache.
 *
 * `irradiance` is called at a hit with a diffuse material, on the side of its normal,
 * or on the far side of a translucent material, with `normal` reversed. It gives the
 * irradiance from all light that is not sampled directly, which pp_radiance_indirect
 * samples over the hemisphere. `depth` is the number of diffuse reflections of the path
 * before this hit, 0 at the first surface. The function returns false if the path must
 * sample this light itself. Several threads may call it at once.
 */
struct pp_ambient {
    bool (*irradiance)(void *store, const struct pp_light_hit *hit,
                       struct pp_vec3 normal, int depth, struct pp_rgb *value);
    void *store; /* not owned */
};

struct pp_environment;
struct pp_opening_store;

/* A log of rays, for benchmarks of the ray kernels (bench/). */
struct pp_ray_log {
    struct pp_light_ray *rays;
    long count, capacity; /* when the log is full, further rays are not logged */
};

/* Number of stored samplers of openings. They are stored since successive shading
 * points are often the same. */
enum { PP_KEPT_SAMPLERS = 4 };

/* State of one thread. The caller sets the first part before sampling. */
struct pp_radiance_state {
    const struct pp_light_scene *scene;       /* not owned */
    const struct pp_environment *environment; /* environment of a world; not owned;
                                               * NULL: scene from a description */
    struct pp_radiance_options options;
    const struct pp_opening_store *store; /* not owned; NULL: nothing is read from a
                                           * store */
    const struct pp_ambient *ambient;     /* not owned; NULL: none */
    struct pp_sobol_sequence sequence;    /* the randomisation */
    uint32_t index;                       /* index of the path in the sequence */
    bool every_ray;         /* also trace rays whose result is known in advance */
    struct pp_ray_log *log; /* not owned; NULL: none */

    long rays;  /* traced so far */
    long leaks; /* rays lost in gaps between the edges of two surfaces */
    struct pp_polygon_sampler samplers[PP_KEPT_SAMPLERS];
    struct pp_openings_shares shares; /* shares of the last point that chose an
                                       * opening */
};

/* Calls pp_light_scene_meet and counts the ray. */
enum pp_meeting pp_radiance_state_meet(struct pp_radiance_state *state,
                                       const struct pp_light_ray *ray,
                                       struct pp_light_hit *hit);

/* Like pp_radiance_state_meet, if the ray's nearest plane (pp_light_scene_nearest) is
 * given; NULL: unknown. */
enum pp_meeting pp_radiance_state_meet_by(struct pp_radiance_state *state,
                                          const struct pp_light_ray *ray,
                                          const struct pp_convex_nearest *nearest,
                                          struct pp_light_hit *hit);

/* Traces a shadow ray from ray.from straight, through clear surfaces, to a part at the
 * distance distance_m (part -1: to the environment). False if a surface is in between.
 * Otherwise multiplies *through by the transmittance of the surfaces passed. */
bool pp_radiance_state_unoccluded(struct pp_radiance_state *state,
                                  struct pp_light_ray ray, int part, double distance_m,
                                  struct pp_rgb *through);

/* Traces a shadow ray to a plane mirror, like pp_radiance_state_unoccluded, and
 * reflects the ray there. Reduces *left_m, the remaining distance, by the distance to
 * the mirror. */
bool pp_radiance_state_reach_mirror(struct pp_radiance_state *state,
                                    struct pp_light_ray *ray, int mirror,
                                    double *left_m, struct pp_rgb *through);

#endif
