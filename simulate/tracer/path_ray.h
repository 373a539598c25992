/* path_ray.h - the rays of the tracer's paths: traced, passed on by glass and frames,
 * followed outside.
 *
 * All light is over Eh. Inside simulate/ only, for the tracer and its benchmark.
 */
#ifndef PP_SIMULATE_TRACER_PATH_RAY_H
#define PP_SIMULATE_TRACER_PATH_RAY_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "model/results/reading.h"
#include "simulate/sampling/lobe.h"
#include "simulate/sampling/sobol.h"
#include "simulate/scene/ray_scene.h"

/* Light by what the point first sees: PP_SC, PP_ERC, PP_IRC of
 * model/results/reading.h. */
struct pp_light {
    double part[3];
};

/* Rays for measuring how fast they could be at best; see bench/. */
struct pp_ray_log {
    struct {
        struct pp_vec3 point, normal, direction;
    } * rays;
    long count, capacity; /* no more are logged when it is full */
};

struct pp_radiosity;

/* What a thread needs to follow paths. */
struct pp_path_state {
    const struct pp_ray_scene *scene; /* not owned */
    const struct pp_radiosity
        *radiosity;                    /* the control variate; not owned; NULL: none */
    struct pp_sobol_sequence sequence; /* the randomisation */
    uint32_t index;                    /* which path of it */
    bool every_ray;         /* trace also where the answer is known beforehand */
    struct pp_ray_log *log; /* not owned; NULL: none */
    struct pp_polygon_sampler sampler; /* the last one: often the next is from the same
                                        * point */
    long rays;                         /* traced so far */
    long leaks; /* rays that were lost between the edges of two surfaces */
};

/* The component of light that has met nothing yet: sky will be PP_SC, a surface
 * PP_ERC. */
enum { PP_PATH_RAY_UNSORTED = -1 };

/* Vertex numbers for the path outside of each vertex. */
enum { PP_PATH_RAY_OUTSIDE_STEP = 1024 };

/* A path ends here where nothing ever absorbs: in an enclosure that reflects all. With
 * a reflectance of 0.99 one path in 10^70 comes so far. */
enum { PP_PATH_RAY_MOST_BOUNCES = 1 << 14 };

/* Paths whose throughput has come down to this share of what they began with go on by
 * Russian roulette only. */
#define PP_PATH_RAY_LEAST_SHARE 0.3

/* The state of a path on its way to the next surface. */
struct pp_path_ray {
    struct pp_vec3 from, normal; /* normal: of the plane that it leaves, on its side */
    struct pp_vec3 to;           /* direction */
    double throughput;
    bool inside;   /* in the room? */
    int component; /* of its light: PP_SC .. PP_IRC, or PP_PATH_RAY_UNSORTED */
};

static inline struct pp_vec3 pp_path_ray_side_normal(const struct pp_facet *facet,
                                                     enum pp_facet_side side)
{
    return side == PP_FRONT ? facet->normal : pp_vec_scale(facet->normal, -1.0);
}

/* A cosine-weighted direction from that side of the facet. */
static inline struct pp_vec3 pp_path_ray_lobe(const struct pp_facet *facet,
                                              enum pp_facet_side side, double u,
                                              double v)
{
    return pp_lobe_sample_in_frame(facet->a, facet->b,
                                   pp_path_ray_side_normal(facet, side), u, v);
}

/* Russian roulette: does a path with this chance go on? If so, its throughput makes up
 * for the paths that don't. */
static inline bool pp_path_ray_survives(struct pp_path_ray *ray, double chance,
                                        double u)
{
    if (chance >= 1.0)
        return ray->throughput > 0.0;
    if (!(u < chance))
        return false;
    ray->throughput /= chance;
    return true;
}

/* The first meeting of the ray from p, a point of a plane with normal n; the ray is
 * counted and logged. */
static inline struct pp_contact pp_path_ray_first(struct pp_path_state *state,
                                                  struct pp_vec3 p, struct pp_vec3 n,
                                                  struct pp_vec3 u)
{
    state->rays++;
    if (state->log && state->log->count < state->log->capacity) {
        long i = state->log->count++;
        state->log->rays[i].point = p;
        state->log->rays[i].normal = n;
        state->log->rays[i].direction = u;
    }
    return pp_ray_scene_first(state->scene, p, n, u);
}

/* Has the ray met the wrong side of the room's envelope: has it leaked between the
 * edges of two surfaces? */
static inline bool pp_path_ray_is_leak(const struct pp_ray_scene *scene,
                                       const struct pp_path_ray *ray,
                                       const struct pp_contact *met)
{
    if (met->facet < 0)
        return ray->inside;
    const struct pp_facet *facet = &scene->facets[met->facet];
    return scene->has_room && (facet->envelope || facet->opening >= 0)
           && (met->side == PP_FRONT) != ray->inside;
}

/* The transmittance of an opening for the cosine of the angle of incidence, with its
 * frame, dirt and curtains. */
double pp_path_ray_transmittance(const struct pp_opening *opening,
                                 double cos_incidence);

enum pp_opening_event { PP_OPENING_MIRRORS, PP_OPENING_SCATTERS, PP_OPENING_TRANSMITS };

/* Turns the ray by one of the events at the opening that it has met, chosen at random;
 * false where the light ends. Light is transmitted only where that is counted. u:
 * direction (2), event. */
bool pp_path_ray_pass_opening(const struct pp_ray_scene *scene, struct pp_path_ray *ray,
                              const struct pp_contact *met, bool count_through,
                              const double u[3], enum pp_opening_event *event);

/* Adds a surface's own exitance, and multiplies the throughput by its reflectance; the
 * direction is for the caller. */
void pp_path_ray_leave_surface(const struct pp_facet *facet, struct pp_path_ray *ray,
                               const struct pp_contact *met, struct pp_light *light);

/* Adds the light of sky, ground or a far skyline, where the ray meets no surface. */
static inline void pp_path_ray_add_sky(const struct pp_ray_scene *scene,
                                       const struct pp_path_ray *ray,
                                       struct pp_light *light)
{
    bool is_sky;
    double value = pp_environment_light(&scene->environment, ray->to, &is_sky);
    int component = ray->component != PP_PATH_RAY_UNSORTED ? ray->component
                    : is_sky                               ? PP_SC
                                                           : PP_ERC;
    light->part[component] += ray->throughput * value;
}

/* Adds the light of a near skyline that stands before the surface that was met; false
 * if none does. */
static inline bool pp_path_ray_add_near_skyline(const struct pp_ray_scene *scene,
                                                const struct pp_path_ray *ray,
                                                const struct pp_contact *met,
                                                struct pp_light *light)
{
    double exitance = 0.0;
    double distance =
        pp_environment_near_skyline(&scene->environment, ray->from, ray->to, &exitance);
    if (isinf(distance) || (met->facet >= 0 && met->distance_m < distance))
        return false;
    light->part[ray->component == PP_PATH_RAY_UNSORTED ? PP_ERC : ray->component] +=
        ray->throughput * exitance;
    return true;
}

/* Follows a ray to its end without next-event estimation, in and out of the room. */
void pp_path_ray_follow(struct pp_path_state *state, struct pp_path_ray ray, int vertex,
                        struct pp_light *light);

#endif
