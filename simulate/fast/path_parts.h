/* path_parts.h - functions shared by the estimators of path.h. Inside simulate/fast/
 * only. */
#ifndef PP_SIMULATE_FAST_PATH_PARTS_H
#define PP_SIMULATE_FAST_PATH_PARTS_H

#include "simulate/fast/path.h"
#include "simulate/transport/light_path.h"

/* Start point of a path. u: the first two random numbers of `vertex`, for a
 * direction. */
struct pp_vec3 pp_path_begin(const struct pp_path_state *state,
                             const struct pp_start *start, int vertex, double u[2]);

/* Length of the longest run of path indices that may begin at `index` and ends at `end`
 * or before; `most` is a power of two. */
static inline int pp_path_run_from(uint32_t index, uint32_t end, uint32_t most)
{
    uint32_t count = most;
    while (count > 1 && (index % count != 0 || count > end - index))
        count /= 2;
    return (int)count;
}

/* Value of the control variate G at the end of a ray. */
static inline double pp_path_guess(const struct pp_path_state *state,
                                   const struct pp_light_hit *met)
{
    return state->variate
               ? pp_control_variate_at(state->variate, state->light.scene, met)
               : 0.0;
}

/* A light path along a ray, from `vertex` on. Light of openings that are sampled
 * directly is excluded. */
static inline struct pp_light_path pp_path_of_ray(const struct pp_path_state *state,
                                                  const struct pp_light_ray *ray,
                                                  int vertex)
{
    return (struct pp_light_path){.ray = *ray,
                                  .throughput = pp_rgb_grey(1.0),
                                  .least = state->light.options.least,
                                  .sampled = PP_DIRECTLY_SAMPLED_ALL,
                                  .sampled_in = ray->space,
                                  .mirror_path = -1,
                                  .vertex = vertex};
}

#endif
