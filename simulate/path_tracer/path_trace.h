/* path_trace.h - the light along a ray, by the textbook's path tracing.
 *
 * This is the plain calculation of simulated light: one loop (path_trace.c) and next-event
 * estimation (next_event.c), for any scene. docs/theory.md explains it line by line. The
 * tracer of simulate/tracer/ and the transport of simulate/transport/ calculate the same
 * faster, with control variates, shared points and weights of several samplers; tests hold
 * them against this.
 *
 * Words and letters are those of [PJH23]:
 *
 *     L       radiance along the ray, the result
 *     beta    throughput of the path so far: product of BSDF x cosine / pdf
 *     wo, wi  directions from the surface: back along the ray, and on
 *
 * The estimate is unbiased. Radiances of a world's scene are over Eh, per steradian; those
 * of a description have the description's unit.
 */
#ifndef PP_SIMULATE_PATH_TRACER_PATH_TRACE_H
#define PP_SIMULATE_PATH_TRACER_PATH_TRACE_H

#include <stdbool.h>
#include <stdint.h>

#include "model/light/rgb.h"
#include "simulate/sampling/scatter.h"
#include "simulate/sampling/sobol.h"
#include "simulate/scene/environment.h"
#include "simulate/scene/light_scene.h"
#include "simulate/scene/openings.h"

/* A thread's own. Fill the first five, then trace. */
struct pp_path_trace {
    const struct pp_light_scene *scene;       /* not owned */
    const struct pp_environment *environment; /* of a world; not owned; NULL: of a
                                               * description */
    struct pp_sobol_sequence sequence;        /* random numbers: a randomisation, */
    uint32_t index;                           /* which path of it, */
    int vertex;                               /* and how often the path has drawn: 0 */

    long rays, leaks;                 /* traced so far; lost between two surfaces */
    struct pp_openings_shares shares; /* importances of openings at the last point */
};

/* The first surface that a path meets, glass aside: it decides between sky component,
 * externally and internally reflected component. */
enum pp_path_first { PP_FIRST_NONE, PP_FIRST_SKY, PP_FIRST_OUTSIDE, PP_FIRST_INSIDE };

/* Light that next-event estimation has sampled at the surface that a ray leaves: the ray
 * must not count it again. */
struct pp_path_counted {
    bool openings; /* light through the room's openings */
    bool emitters; /* light of lamps and sun */
};

/* One sample of the radiance along the ray. aims: are openings sampled along the path? Not
 * on a path that has left the room by an opening: each of its vertices would begin another
 * such path. *first may be NULL. */
struct pp_rgb pp_path_trace_radiance(struct pp_path_trace *path,
                                     struct pp_light_ray ray,
                                     struct pp_path_counted counted, bool aims,
                                     enum pp_path_first *first);

/* ---- parts that path_trace.c and next_event.c share ---- */

/* The next `count` random numbers of the path, at most PP_SOBOL_DIMENSIONS, in (0, 1). */
void pp_path_trace_draw(struct pp_path_trace *path, int count, double *u);

/* The first meeting of the ray, counted. */
enum pp_meeting pp_path_trace_meet(struct pp_path_trace *path,
                                   const struct pp_light_ray *ray,
                                   struct pp_light_hit *hit);

/* Turns the ray from the surface it has met into a direction wi of one of its lobes, drawn
 * in proportion to their albedos, and multiplies beta by BSDF x cosine / pdf. Returns the
 * lobe; PP_LOBE_COUNT: nothing is scattered. */
enum pp_lobe pp_path_trace_scatter(struct pp_path_trace *path,
                                   const struct pp_lobes *lobes,
                                   const struct pp_light_hit *hit,
                                   struct pp_light_ray *ray, struct pp_rgb *beta);

#endif
