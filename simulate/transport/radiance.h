/* radiance.h - light along a ray and on a surface, by unbiased path tracing.
 *
 * A path is one sample. The light is the mean over paths index = 0, 1, 2, ... of one
 * sequence (sobol.h). The number of paths is best a power of two. Sequences with
 * different seeds are independent, and their spread gives the standard error.
 *
 * Each kind of light has its own estimator. At every surface that scatters,
 *
 *     sources   concentrated emitters and the sun, by next-event estimation, with more
 *               strata of directions for nearer and larger ones (the power of two that
 *               makes the angular size of a stratum at most `source_size`)
 *     windows   the panes of a world's openings, likewise, as lamps that emit the light
 *               of sky, ground and obstructions that passes through them
 *     the rest  extended emitters, sky, ground and all surfaces, by rays in directions
 *               drawn from the surface's lobes
 *
 * The first two estimators can each be switched off; rays then find their light too.
 * The mean is the same; noise and time differ.
 *
 * Diffuse inter-reflection, the most expensive part, may come from a cache: see struct
 * pp_ambient.
 */
#ifndef PP_SIMULATE_TRANSPORT_RADIANCE_H
#define PP_SIMULATE_TRANSPORT_RADIANCE_H

#include "simulate/transport/irradiance.h"
#include "simulate/transport/radiance_state.h"

/* Radiance along the ray, by one path. *hit (may be NULL) is the first hit, glass
 * included. */
struct pp_rgb pp_radiance_along(struct pp_radiance_state *state,
                                const struct pp_light_ray *ray,
                                struct pp_light_hit *hit);

/* Radiance along a ray, without the light of sources and windows seen directly or
 * through clear glass, which next-event estimation samples at the start of the ray. */
struct pp_rgb pp_radiance_indirect(struct pp_radiance_state *state,
                                   const struct pp_light_ray *ray,
                                   struct pp_light_hit *hit);

/* Irradiance at a point, one sample of each part. normal: unit; space:
 * pp_light_scene_space of the point. pp_radiance_direct gives only the light that
 * next-event estimation samples. With `ambient`, `rest` is still sampled at the point
 * itself; the ambient store is read from the next surface onwards (depth 1). */
struct pp_irradiance pp_radiance_direct(struct pp_radiance_state *state,
                                        struct pp_vec3 point, struct pp_vec3 normal,
                                        enum pp_space space);
struct pp_irradiance pp_radiance_irradiance(struct pp_radiance_state *state,
                                            struct pp_vec3 point, struct pp_vec3 normal,
                                            enum pp_space space);

#endif
