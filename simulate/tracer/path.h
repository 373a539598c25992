/* path.h - the light along random paths.
 *
 * The daylight factor at a point is split into three expectations, each sampled on its
 * own:
 *
 *     direct      light that comes in by an opening straight to the point: directions
 *                 to the openings, then on outside
 *     gather      the mean over the cosine lobe of a guess G of what the surfaces give
 *                 off (radiosity.h)
 *     correction  what is wrong with that guess: with B = M + rho (E + K B) the true
 *                 exitance (M its own, E from the openings, K one bounce),
 *
 *                     B - G = (M - G) + rho (E + K G) + rho K (B - G)
 *
 *                 followed along a path: at each surface met, what the guess leaves
 *                 out; then on by Russian roulette
 *
 * Their sum is right whatever the guess; a good one leaves little to the correction.
 * Without one, the correction is plain path tracing. Indoors the openings are sampled
 * directly at every diffuse surface, and a ray that reaches one by the cosine lobe
 * counts nothing for what comes in by it; it is reflected by glass and frame. After a
 * reflection in glass it does count. Outside, and where light comes back in by another
 * opening, paths are followed without any such shortcut.
 *
 * All light is over Eh.
 */
#ifndef PP_SIMULATE_TRACER_PATH_H
#define PP_SIMULATE_TRACER_PATH_H

#include <stdbool.h>
#include <stdint.h>

#include "simulate/tracer/radiosity.h"
#include "simulate/scene/ray_scene.h"
#include "simulate/sampling/sobol.h"

/* Light by what the point first sees: PP_SC, PP_ERC, PP_IRC of model/results/reading.h. */
struct pp_light {
    double part[3];
};

/* Rays for measuring how fast they could be at best; see bench/. */
struct pp_ray_log {
    struct {
        struct pp_vec3 point, normal, direction;
    } * rays;
    long count, capacity; /* it stops when full */
};

/* What a thread needs to follow paths. */
struct pp_path_state {
    const struct pp_ray_scene *scene;  /* not owned */
    const struct pp_radiosity *guess;  /* not owned; NULL: none */
    struct pp_sobol_sequence sequence; /* the randomisation */
    uint32_t index;                    /* which path of it */
    bool every_ray;         /* trace also where the answer is known beforehand */
    struct pp_ray_log *log; /* not owned; NULL: none */
    struct pp_polygon_sampler
        aim;    /* the last one: often the next is from the same point */
    long rays;  /* traced so far */
    long leaks; /* rays that left the room through a crack: lost */
};

/* Where paths start: at a point, or anywhere on the working plane. */
struct pp_start {
    bool anywhere;
    struct pp_vec3 position; /* in the scene's coordinates */
    struct pp_vec3 normal;
};

/* One sample each of path `state->index`. Direct light is added to `light`; the others
 * are internally reflected all of them, and 0 where there is no room. */
void pp_path_direct(struct pp_path_state *state, const struct pp_start *start,
                    struct pp_light *light);
double pp_path_gather(struct pp_path_state *state, const struct pp_start *start);
double pp_path_correction(struct pp_path_state *state, const struct pp_start *start);

/* One sample of what comes in by the openings to a surface in the room: E above.
 * u: position in the opening (2) and the choice of it. */
void pp_path_openings(struct pp_path_state *state, struct pp_vec3 p, struct pp_vec3 n,
                      const double u[3], int vertex, double weight, int kind,
                      struct pp_light *light);

/* The first thing that a lobe's ray meets, and its count. */
struct pp_contact pp_path_first(struct pp_path_state *state, struct pp_vec3 p,
                                struct pp_vec3 n, struct pp_vec3 u);

#endif
