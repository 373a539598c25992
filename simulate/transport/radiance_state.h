/* radiance_state.h - what a thread needs to trace paths, and the rays that it
 * traces. */
#ifndef PP_SIMULATE_TRANSPORT_RADIANCE_STATE_H
#define PP_SIMULATE_TRANSPORT_RADIANCE_STATE_H

#include <stdbool.h>
#include <stdint.h>

#include "model/light/rgb.h"
#include "simulate/sampling/sobol.h"
#include "simulate/scene/light_scene.h"
#include "simulate/transport/radiance_options.h"

/* Indirect irradiance of diffuse surfaces from elsewhere (a cache).
 *
 * `irradiance` is asked at a hit whose material is diffuse (on the side of its normal,
 * or, of a translucent material, on the far side: then `normal` is turned) for the
 * irradiance from all light that is not sampled directly: the light that
 * pp_radiance_indirect gives the hemispherical integral of. `depth` is how many diffuse
 * reflections the path has behind it, 0 at the first surface. It returns false where
 * the path is to sample that light itself. Called by many threads at a time. */
struct pp_ambient {
    bool (*irradiance)(void *store, const struct pp_light_hit *hit,
                       struct pp_vec3 normal, int depth, struct pp_rgb *value);
    void *store; /* not owned */
};

struct pp_window_store;

/* A thread's own. Fill the first part, then draw. */
struct pp_radiance_state {
    const struct pp_light_scene *scene; /* not owned */
    struct pp_radiance_options options;
    const struct pp_window_store *store; /* not owned; NULL: as if not `stored` */
    const struct pp_ambient *ambient;    /* not owned; NULL: none */
    struct pp_sobol_sequence sequence;   /* the randomisation */
    uint32_t index;                      /* which path of it */

    long rays;  /* traced so far */
    long leaks; /* of them, lost between the edges of two surfaces */
};

/* pp_light_scene_meet, with the ray counted. */
enum pp_meeting pp_radiance_state_meet(struct pp_radiance_state *state,
                                       const struct pp_light_ray *ray,
                                       struct pp_light_hit *hit);

/* A shadow ray: from ray.from straight, through clear surfaces, to a part at a distance
 * (-1: to the environment). False if a surface stands before it; else *through has been
 * multiplied by the transmittance of those that it passed. */
bool pp_radiance_state_unoccluded(struct pp_radiance_state *state,
                                  struct pp_light_ray ray, int part, double distance_m,
                                  struct pp_rgb *through);

/* The same to a plane mirror, and on as the mirror reflects the ray. *left_m, the
 * distance still to go, loses the way to the mirror. */
bool pp_radiance_state_reach_mirror(struct pp_radiance_state *state,
                                    struct pp_light_ray *ray, int mirror,
                                    double *left_m, struct pp_rgb *through);

#endif
