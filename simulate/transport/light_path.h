/* light_path.h - the end of a path of light, and what is aimed at from where it comes
 * to. Inside simulate/ only; all points are measured from the scene's centre.
 */
#ifndef PP_SIMULATE_TRANSPORT_LIGHT_PATH_H
#define PP_SIMULATE_TRANSPORT_LIGHT_PATH_H

#include "simulate/sampling/hash.h"
#include "simulate/scene/light_parts.h"
#include "simulate/transport/radiance.h"
#include "simulate/sampling/scatter.h"

/* Draws of a vertex: its own, for sources, for windows, for diffusing panes. */
enum {
    PP_DRAW_SOURCES = 1,
    PP_DRAW_WINDOWS = 2,
    PP_DRAW_PANES = 3,
    PP_DRAWS = 4,
};

/* What has been aimed at from where a ray was sent off: if it comes to it all the same,
 * it counts nothing. */
enum pp_directly_sampled {
    PP_DIRECTLY_SAMPLED_NONE,  /* from the eye, or a mirror that is not aimed at */
    PP_DIRECTLY_SAMPLED_SMALL, /* from a gloss: at what looks small to it */
    PP_DIRECTLY_SAMPLED_ALL,   /* from a diffuse surface */
};

/* A gloss aims at what looks smaller than so many of its roughnesses: then no aimed
 * sample is worth more than one that finds it, (3 a)^2 / (4 pi a^2) of it at most where
 * it is seen straight. */
#define PP_DIRECTLY_SAMPLED_WIDTHS 3.0

/* The end of a path so far. */
struct pp_light_path {
    struct pp_light_ray ray;
    struct pp_rgb weight;
    double least; /* Russian roulette below this weight; of a gloss a tenth of it */
    enum pp_directly_sampled aimed;
    enum pp_space aimed_in; /* where that was: windows aren't aimed at from outdoors */
    int mirror_path; /* of mirrors since then, by which it was aimed as well; -1: none */
    struct pp_vec3
        from; /* of PP_DIRECTLY_SAMPLED_SMALL: where, and how large is small */
    double width;
    int depth;      /* diffuse reflections behind it */
    int vertex;     /* of the random numbers */
    int bounces;    /* surfaces met */
    bool many;      /* aim in many directions at the next surface: it is the first */
    bool by_window; /* sent out by a window that was aimed at: it finds windows by
                     * chance from then on, or aims would breed aims without end */
};

/* Vertex numbers for a path that branches off a vertex: anywhere else. */
static inline int pp_light_path_branch_vertex(int vertex, int kind)
{
    uint32_t mixed = pp_hash_mix32((uint32_t)vertex * PP_DRAWS + (uint32_t)kind + 1);
    return (int)(mixed >> 4) + 64;
}

/* ---- paths: light_path.c ---- */

/* pp_light_scene_meet, counted. */
enum pp_meeting pp_light_path_meet(struct pp_radiance_state *state,
                                   const struct pp_light_ray *ray,
                                   struct pp_light_hit *hit);

/* Takes what a path finds where it has come to, and turns it on to where it goes from
 * there; false where it ends. */
bool pp_light_path_arrive(struct pp_radiance_state *state, struct pp_light_path *path,
                          enum pp_meeting meeting, const struct pp_light_hit *hit,
                          struct pp_rgb *total);

/* Follows a path to its end; what it meets first goes to *first (may be NULL). */
struct pp_rgb pp_light_path_follow(struct pp_radiance_state *state,
                                   struct pp_light_path *path,
                                   struct pp_light_hit *first);

/* ---- aiming ---- */

/* A surface that is shading, on one of its sides. */
struct pp_shading_point {
    struct pp_vec3 point, normal; /* of that side */
    enum pp_space space;
    const struct pp_lobes *lobes;
    int vertex, depth;
    bool many;
};

static inline struct pp_light_ray pp_light_path_shadow_ray(
    const struct pp_shading_point *shading, struct pp_vec3 to)
{
    return (struct pp_light_ray){shading->point, shading->normal, to, shading->space};
}

static inline enum pp_space pp_light_path_part_space(const struct pp_light_scene *scene,
                                                     int part, bool back)
{
    return (enum pp_space)scene->parts[part].space[back];
}

static inline struct pp_rgb pp_light_path_irradiance_sum(const struct pp_irradiance *e)
{
    return pp_rgb_add(pp_rgb_add(e->sources, e->rest), pp_rgb_add(e->sky, e->outside));
}

/* What goes to the eye of light from direction o: f, with the gloss where what is aimed
 * at looks small to it. */
struct pp_rgb pp_light_sources_brdf(const struct pp_shading_point *shading,
                                    struct pp_vec3 o, double spread);

/* Goes straight, through what is clear, to a part at a distance (-1: to what is
 * beyond); false if something stands before it. */
bool pp_light_sources_unoccluded(struct pp_radiance_state *state,
                                 struct pp_light_ray ray, int part, double distance_m,
                                 struct pp_rgb *through);

/* light_sources.c: from all concentrated emitters, one sample. */
struct pp_rgb pp_light_sources_next_event(struct pp_radiance_state *state,
                                          const struct pp_shading_point *shading);

/* Has the emitter been aimed at from where the path's ray was sent off? */
bool pp_light_sources_directly_sampled(const struct pp_radiance_state *state,
                                       const struct pp_light_path *path, int emitter);

/* light_windows.c: from all windows, one sample, added to sky and outside of *sum. */
void pp_light_windows_next_event(struct pp_radiance_state *state,
                                 const struct pp_shading_point *shading,
                                 struct pp_irradiance *sum);
bool pp_light_windows_directly_sampled(const struct pp_radiance_state *state,
                                       const struct pp_light_path *path, int window);

#endif
