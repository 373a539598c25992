/* path_vertex.h - the state of a path between two surfaces, and a surface that it
 * shades. Inside simulate/ only; all points are measured from the scene's centre.
 */
#ifndef PP_SIMULATE_TRANSPORT_PATH_VERTEX_H
#define PP_SIMULATE_TRANSPORT_PATH_VERTEX_H

#include "simulate/sampling/hash.h"
#include "simulate/sampling/scatter.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/transport/radiance_state.h"

/* The random numbers of a vertex come in groups: for the path itself, for sources, for
 * windows, for diffusing panes. */
enum {
    PP_DRAW_SOURCES = 1,
    PP_DRAW_WINDOWS = 2,
    PP_DRAW_PANES = 3,
    PP_DRAWS = 4,
};

/* Vertex numbers for a path that branches off a vertex: hashed, so that they meet those
 * of no other branch. */
static inline int pp_path_vertex_branch(int vertex, int kind)
{
    uint32_t mixed = pp_hash_mix32((uint32_t)vertex * PP_DRAWS + (uint32_t)kind + 1);
    return (int)(mixed >> 4) + 64;
}

/* Which emitters and windows have been sampled directly from where a ray starts. If the
 * ray itself comes to one of these, it counts nothing. */
enum pp_directly_sampled {
    PP_DIRECTLY_SAMPLED_NONE,  /* the ray comes from the eye, or from a mirror by which
                                * emitters are not sampled */
    PP_DIRECTLY_SAMPLED_SMALL, /* from a gloss: those that look small to it */
    PP_DIRECTLY_SAMPLED_ALL,   /* from a diffuse surface */
};

/* A gloss samples directly what looks smaller than this many of its roughnesses a: then
 * no direct sample is worth more than a ray of the lobe that finds the source, which is
 * (3 a)^2 / (4 pi a^2) of the source at most where it is seen straight. */
#define PP_DIRECTLY_SAMPLED_WIDTHS 3.0

/* The state of a path on its way to the next surface. */
struct pp_light_path {
    struct pp_light_ray ray;
    struct pp_rgb throughput;
    double least; /* Russian roulette where the throughput is below */
    enum pp_directly_sampled sampled;
    enum pp_space sampled_in;   /* where the surface is that sampled directly: outdoors
                                 * windows are not */
    int mirror_path;            /* of mirrors met since then; -1: none */
    struct pp_vec3 gloss_point; /* of PP_DIRECTLY_SAMPLED_SMALL: the surface's point, */
    double gloss_size;          /* and the angular size that is small to it */
    int depth;                  /* diffuse reflections so far */
    int vertex;                 /* of the random numbers */
    int bounces;                /* surfaces met */
    bool split;       /* take many directions at the next surface that scatters: the
                       * first of the path */
    bool from_window; /* begun at a window that was sampled directly: the path finds
                       * windows by its own rays from then on. Would it sample them
                       * directly, each sample might begin another path outside, without
                       * end */
};

/* A path that goes on outside from a window that was sampled directly. */
static inline struct pp_light_path pp_path_vertex_outside(
    const struct pp_radiance_state *state, const struct pp_light_ray *ray, int vertex,
    int depth)
{
    return (struct pp_light_path){.ray = *ray,
                                  .throughput = pp_rgb_grey(1.0),
                                  .least = state->options.least,
                                  .sampled = PP_DIRECTLY_SAMPLED_ALL,
                                  .sampled_in = PP_OUTDOORS,
                                  .mirror_path = -1,
                                  .depth = depth,
                                  .vertex = vertex,
                                  .from_window = true};
}

/* One side of a surface whose direct light is wanted.
 *
 * Next-event estimation at a window needs the light outside it, which is that of a
 * path. light_windows.c gets the function that follows the path (light_path.c's) by
 * this pointer, so that neither file calls the other. */
struct pp_shading_point {
    struct pp_vec3 point, normal; /* normal: of that side */
    enum pp_space space;
    const struct pp_lobes *lobes;
    int vertex, depth; /* as the path's that has come here */
    bool split;
    struct pp_rgb (*follow_outside)(struct pp_radiance_state *state,
                                    struct pp_light_path *path, enum pp_meeting meeting,
                                    const struct pp_light_hit *hit);
};

/* The BRDF (or BTDF) between the eye and direction o, 1/sr: the diffuse part, and the
 * gloss where a source of that angular size looks small to it. */
struct pp_rgb pp_path_vertex_brdf(const struct pp_shading_point *shading,
                                  struct pp_vec3 o, double angular_size);

static inline struct pp_light_ray pp_path_vertex_shadow_ray(
    const struct pp_shading_point *shading, struct pp_vec3 to)
{
    return (struct pp_light_ray){shading->point, shading->normal, to, shading->space};
}

/* Into how many strata, with a direction each, next-event estimation divides a source
 * or window of that angular size: the power of two, at most options.source_most, that
 * makes a stratum look smaller than options.source_size; 1 where the path is not
 * split. */
uint32_t pp_path_vertex_direction_count(const struct pp_radiance_state *state,
                                        const struct pp_shading_point *shading,
                                        double angular_size);

#endif
