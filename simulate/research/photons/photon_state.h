/* photon_state.h - state of a thread that follows photons, and its rays. Inside
 * simulate/research/photons only; all points are measured from the scene's centre. */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_STATE_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_STATE_H

#include <stdint.h>

#include "simulate/sampling/hash.h"
#include "simulate/sampling/sobol.h"
#include "simulate/scene/environment.h"
#include "simulate/scene/light_scene_parts.h"

struct pp_photon_sources;

struct pp_photon_state {
    const struct pp_light_scene *scene;       /* not owned */
    const struct pp_environment *environment; /* not owned */
    const struct pp_photon_sources *sources;  /* not owned */
    struct pp_sobol_sequence sequence;        /* the randomisation */
    uint32_t index;                           /* index of the path */
    long rays, leaks;                         /* rays traced so far, and rays lost */
};

enum {
    /* Limit on the vertices of a path, for enclosures in which nothing absorbs. */
    PP_PHOTON_MOST_VERTICES = 1 << 14
};

/* The random numbers of a path's vertex, each in (0, 1); at most six. */
static inline void pp_photon_state_draw(const struct pp_photon_state *state, int vertex,
                                        int count, double u[])
{
    pp_sobol_sequence_draw(&state->sequence, state->index, vertex, count, u);
}

/* Vertex number for a path that branches off a vertex: hashed, so that branches do not
 * share random numbers. */
static inline int pp_photon_state_branch(int vertex, int kind)
{
    uint32_t mixed = pp_hash_mix32((uint32_t)vertex * 4 + (uint32_t)kind + 1);
    return (int)(mixed >> 4) + 64;
}

/* Calls pp_light_scene_meet, and counts the ray. */
static inline enum pp_meeting pp_photon_state_meet(struct pp_photon_state *state,
                                                   const struct pp_light_ray *ray,
                                                   struct pp_light_hit *hit)
{
    enum pp_meeting meeting = pp_light_scene_meet(state->scene, ray, hit);
    state->rays++;
    state->leaks += meeting == PP_MEETS_LEAK;
    return meeting;
}

/* Point of a hit, moved back along the ray by half of the distance by which rays are
 * lifted off surfaces (rays.h). Otherwise a point in a corner would also lie in the
 * other surface. */
static inline struct pp_vec3 pp_photon_state_drawn_back(const struct pp_light_hit *hit,
                                                        struct pp_vec3 to)
{
    struct pp_vec3 p = hit->point;
    double reach = fabs(p.x) + fabs(p.y) + fabs(p.z);
    return pp_vec_along(p, -0x1p-21 - 0x1p-21 * reach, to);
}

#endif
