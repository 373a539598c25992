/* path_trace.h - the light along a ray, by textbook path tracing.
 *
 * This is the plain calculation of simulated light in the scene of a room: one loop and
 * next-event estimation of the openings. docs/theory.md explains it step by step. The
 * tracer of simulate/fast/ and the transport of simulate/transport/ calculate the same
 * light faster, with control variates, shared points and multiple importance sampling.
 * Tests compare both with this calculation.
 *
 * Terms and symbols are those of [PJH23]:
 *
 *     L       radiance along the ray, the result
 *     beta    throughput of the path so far: product of BSDF x cosine / pdf
 *     wo, wi  directions from the surface: back along the ray, and onwards
 *
 * The estimate is unbiased. Radiances are over Eh, per steradian.
 */
#ifndef PP_SIMULATE_PATH_TRACER_PATH_TRACE_H
#define PP_SIMULATE_PATH_TRACER_PATH_TRACE_H

#include "simulate/path_tracer/path_walk.h"

/* The first surface that a path meets, other than glass. It determines the component
 * (sky, externally or internally reflected). */
enum pp_path_first { PP_FIRST_NONE, PP_FIRST_SKY, PP_FIRST_OUTSIDE, PP_FIRST_INSIDE };

/* A point on one side of a surface. normal: unit, on this side. */
struct pp_lit_point {
    struct pp_vec3 point, normal;
    enum pp_space space;
};

/* One sample of the radiance along the ray. counted: light straight through the
 * openings was already sampled at the ray's origin. aims: next-event estimation of
 * openings along the path. It must be false outside the room, where each surface would
 * begin another such path. *first may be NULL. */
struct pp_rgb pp_path_trace_radiance(struct pp_path_walk *walk, struct pp_light_ray ray,
                                     bool counted, bool aims,
                                     enum pp_path_first *first);

/* One sample of the irradiance through the room's openings. *first (may be NULL): the
 * first surface outside that the light met, or PP_FIRST_SKY. */
struct pp_rgb pp_path_trace_openings(struct pp_path_walk *walk,
                                     const struct pp_lit_point *at,
                                     enum pp_path_first *first);

/* One sample of the irradiance from the surfaces that rays meet: pi times the radiance
 * in a direction of the point's cosine lobe. counted, first: as above. */
struct pp_rgb pp_path_trace_lobe(struct pp_path_walk *walk,
                                 const struct pp_lit_point *at, bool counted,
                                 enum pp_path_first *first);

#endif
