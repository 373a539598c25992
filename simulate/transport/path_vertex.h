/* path_vertex.h - the state of a path between two surfaces, and the point of a surface
 * at which its direct light is calculated. Inside simulate/ only; all points are
 * measured from the scene's centre.
 */
#ifndef PP_SIMULATE_TRANSPORT_PATH_VERTEX_H
#define PP_SIMULATE_TRANSPORT_PATH_VERTEX_H

#include "simulate/sampling/hash.h"
#include "simulate/sampling/scatter.h"
#include "simulate/scene/environment.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/transport/niche_light.h"
#include "simulate/transport/radiance_state.h"

/* The random numbers of a vertex come in groups: for the path itself, for sources, for
 * windows, for diffusing panes. */
enum {
    PP_DRAW_SOURCES = 1,
    PP_DRAW_WINDOWS = 2,
    PP_DRAW_PANES = 3,
    PP_DRAWS = 4,
};

/* Vertex number for a path that branches off a vertex: hashed, so that branches do not
 * share random numbers. */
static inline int pp_path_vertex_branch(int vertex, int kind)
{
    uint32_t mixed = pp_hash_mix32((uint32_t)vertex * PP_DRAWS + (uint32_t)kind + 1);
    return (int)(mixed >> 4) + 64;
}

/* Lobe by which a ray has left a surface at which next-event estimation also sampled
 * light of emitters and windows. After a diffuse lobe, only next-event estimation
 * counts that light. After a gloss, multiple importance sampling combines both
 * estimates [VG95]. */
enum pp_directly_sampled {
    PP_DIRECTLY_SAMPLED_NONE,  /* the ray comes from the eye, or from a mirror for which
                                * emitters are not sampled; all light counts */
    PP_DIRECTLY_SAMPLED_GLOSS, /* from a gloss: weighted */
    PP_DIRECTLY_SAMPLED_ALL,   /* from a diffuse surface: the ray counts no such
                                * light */
};

/* The power heuristic of [VG95]: weight of a sample of light that two estimators
 * sample. own, other: densities of the sample's direction (per steradian, times the
 * number of samples) in its own estimator and in the other one. */
static inline double pp_path_vertex_mis(double own, double other)
{
    return own > 0.0 ? 1.0 / (1.0 + other / own * (other / own)) : 0.0;
}

/* First surface met by a path. It determines the daylight component of the path's
 * light, if the path has come through an opening. */
enum pp_first_met { PP_MET_NOTHING, PP_MET_SKY, PP_MET_OUTSIDE, PP_MET_INSIDE };

/* Ray of a diffuse lobe that has reached a reflector directly: the reflector, the ray's
 * origin with its normal, its direction and density. */
struct pp_arrival {
    int reflector; /* -1: none */
    struct pp_vec3 from, off, to;
    double pdf;
};

/* Weight of an emitter's light that the ray found at this gloss, if the diffuse surface
 * has also sampled the light (reflectors.h). */
static inline double pp_path_vertex_arrival_weight(const struct pp_light_scene *scene,
                                                   const struct pp_arrival *arrival,
                                                   int emitter)
{
    int reflection = pp_reflectors_reflection(scene, arrival->reflector, emitter);
    if (reflection < 0)
        return 1.0;
    return pp_path_vertex_mis(
        arrival->pdf, pp_reflectors_pdf(scene, reflection, arrival->from, arrival->to));
}

/* True if openings are sampled by their images in reflectors. Not with a cache: a cache
 * that contains the light of openings also contains the light of their images. */
static inline bool pp_path_vertex_images(const struct pp_radiance_state *state)
{
    return state->options.windows && !state->ambient
           && state->scene->window_image_count > 0;
}

/* Weight of a window's light that the ray found at this reflector, if the diffuse
 * surface has also sampled the window's image in the reflector (window_images.h). */
static inline double pp_path_vertex_image_weight(const struct pp_radiance_state *state,
                                                 const struct pp_arrival *arrival,
                                                 int window)
{
    if (!pp_path_vertex_images(state) || arrival->reflector < 0)
        return 1.0;
    const struct pp_image_viewer viewer = {arrival->from, arrival->off,
                                           &state->environment->brightness};
    return pp_path_vertex_mis(arrival->pdf,
                              pp_window_images_pdf(state->scene, arrival->reflector,
                                                   window, &viewer, arrival->to));
}

/* The state of a path on its way to the next surface. */
struct pp_light_path {
    struct pp_light_ray ray;
    struct pp_rgb throughput;
    double least; /* Russian roulette begins below this throughput */
    enum pp_directly_sampled sampled;
    enum pp_space sampled_in; /* space of the surface at which light was sampled
                               * directly; outdoors, windows are not sampled */
    int mirror_path;          /* index of the path of the mirrors met since then; -1:
                               * none */
    struct pp_vec3 gloss_point, gloss_normal; /* for PP_DIRECTLY_SAMPLED_GLOSS: point
                                               * and normal of the surface */
    double gloss_pdf; /* density of the ray's direction in the lobe, times the number of
                       * such rays */
    bool gloss_split; /* several directions were sampled at that gloss */
    bool here_split;  /* several directions are sampled at the present surface */
    uint32_t gloss_rays, here_gloss_rays;
    bool
        from_diffuse; /* true if the ray has come straight from a diffuse lobe; from and
                       * off are then those of the lobe's surface */
    struct pp_arrival arrival, here_arrival; /* arrival at the gloss or mirror from
                                              * which the ray comes, and at the present
                                              * surface */
    int depth;                               /* diffuse reflections so far */
    int vertex;                              /* index of the random numbers */
    int bounces;                             /* surfaces met */
    bool split;       /* take several directions at the first surface of the path that
                       * scatters */
    bool from_window; /* the path begins at a window that was sampled directly. It then
                       * finds windows by its own rays only, since next-event estimation
                       * would begin further paths outside without end */
    enum pp_first_met first_met; /* first surface so far; panes that the path has passed
                                  * do not count */
};

/* A point on one side of a surface, at which direct light is calculated. */
struct pp_shading_point {
    struct pp_vec3 point, normal; /* normal: of this side */
    enum pp_space space;
    struct pp_rgb diffuse;        /* albedo of this side's diffuse lobe */
    const struct pp_lobes *lobes; /* for the gloss; NULL: there is none; not owned */
    int vertex, depth;            /* vertex and depth of the path that has arrived
                                   * here */
    bool split;
    bool whole_gloss;    /* rays of the gloss do not count light that is sampled here */
    uint32_t gloss_rays; /* number of rays of the gloss */
    const struct pp_arrival
        *arrival;        /* if a ray from a diffuse surface reached the gloss; else
                          * NULL */
    uint32_t directions; /* number of directions to windows, each chosen by importance;
                          * 0: by the rule of sample_openings.h */
    const struct pp_niche_light
        *niches; /* for a point in the room: directions are to mouths of niches. NULL:
                  * to panes; not owned */
};

/* The BRDF (or BTDF) between the eye and direction o, 1/sr, for a sample of next-event
 * estimation with density `density`: the diffuse part, plus the gloss times its weight
 * and `gloss_share`. */
static inline struct pp_rgb pp_path_vertex_brdf(const struct pp_shading_point *shading,
                                                struct pp_vec3 o, double density,
                                                double gloss_share)
{
    struct pp_rgb f = pp_rgb_scale(shading->diffuse, 1.0 / PP_PI);
    if (!shading->lobes || !pp_scatter_has_gloss(shading->lobes))
        return f;
    double weight =
        shading->whole_gloss
            ? 1.0
            : pp_path_vertex_mis(
                density, shading->gloss_rays * pp_scatter_gloss_pdf(shading->lobes, o));
    return pp_rgb_along(f, gloss_share * weight,
                        pp_scatter_gloss_brdf(shading->lobes, o));
}

static inline struct pp_light_ray pp_path_vertex_shadow_ray(
    const struct pp_shading_point *shading, struct pp_vec3 to)
{
    return (struct pp_light_ray){shading->point, shading->normal, to, shading->space};
}

/* Number of strata, with one direction each, in next-event estimation of a source or
 * window of this angular size. It is the smallest power of two for which a stratum's
 * angular size is not above options.source_size, but at most options.source_most; 1 if
 * the path is not split or source_size is 0. */
static inline uint32_t pp_path_vertex_direction_count(
    const struct pp_radiance_state *state, bool split, double angular_size)
{
    double size = state->options.source_size;
    uint32_t count = 1, most = (uint32_t)state->options.source_most;
    if (!split || !(size > 0.0))
        return count;
    double wanted = angular_size / size * (angular_size / size);
    while ((double)count < wanted && 2 * count <= most)
        count *= 2;
    return count;
}

#endif
