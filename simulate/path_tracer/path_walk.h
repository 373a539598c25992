/* path_walk.h - state of one path: random numbers, rays, and a direction of a surface's
 * BSDF. For path_trace.c.
 *
 * Points are measured from the scene's centre.
 */
#ifndef PP_SIMULATE_PATH_TRACER_PATH_WALK_H
#define PP_SIMULATE_PATH_TRACER_PATH_WALK_H

#include <stdbool.h>
#include <stdint.h>

#include "model/light/rgb.h"
#include "simulate/sampling/scatter.h"
#include "simulate/sampling/sobol.h"
#include "simulate/scene/environment.h"
#include "simulate/scene/light_scene.h"
#include "simulate/scene/openings.h"

/* State of one thread. The caller sets the first five members before tracing. */
struct pp_path_walk {
    const struct pp_light_scene *scene;       /* scene of a world; not owned */
    const struct pp_environment *environment; /* not owned */
    struct pp_sobol_sequence sequence;        /* randomisation of the random numbers */
    uint32_t index;                           /* index of the path in the sequence */
    int vertex;                               /* number of draws so far; begins at 0 */

    long rays, leaks;                 /* rays traced so far; rays lost in gaps between
                                       * two surfaces */
    struct pp_openings_shares shares; /* importances of openings at the last point */
};

/* The next `count` random numbers of the path, each in (0, 1). count: at most
 * PP_SOBOL_DIMENSIONS. */
void pp_path_walk_draw(struct pp_path_walk *walk, int count, double *u);

/* Finds the first surface that the ray meets, and counts the ray. hit->point is moved
 * back from the surface (rays.h), so that the next ray can start there. */
enum pp_meeting pp_path_walk_meet(struct pp_path_walk *walk,
                                  const struct pp_light_ray *ray,
                                  struct pp_light_hit *hit);

/* The lobes of the surface's BSDF towards wo; the ground outside, which is not part of
 * the scene, is diffuse. */
struct pp_lobes pp_path_walk_lobes(const struct pp_path_walk *walk,
                                   const struct pp_light_hit *hit, struct pp_vec3 wo);

/* Replaces the ray by a ray from the surface met in a direction wi of one of the
 * surface's lobes, drawn in proportion to their albedos. Multiplies beta by BSDF x
 * cosine / pdf. Returns the lobe; PP_LOBE_COUNT: nothing is scattered. */
enum pp_lobe pp_path_walk_scatter(struct pp_path_walk *walk,
                                  const struct pp_lobes *lobes,
                                  const struct pp_light_hit *hit,
                                  struct pp_light_ray *ray, struct pp_rgb *beta);

#endif
