/* path_trace.c - next-event estimation of openings, and the path-tracing loop:
 * emission, direct light, a direction of a lobe, Russian roulette. */
#include "simulate/path_tracer/path_trace.h"

#include <stddef.h>

#include "simulate/sampling/lobe.h"
#include "simulate/scene/light_scene_parts.h"

/* Russian roulette begins where beta has fallen below LEAST. MOST_BOUNCES ends paths in
 * scenes without absorption. */
static const double LEAST = 0.3;
enum { MOST_BOUNCES = 1 << 14 };

/* Radiance emitted by the surface itself. */
static struct pp_rgb emitted(const struct pp_path_walk *walk,
                             const struct pp_light_hit *hit)
{
    const struct pp_material *material = &walk->scene->materials[hit->material];
    bool shines = material->emits != PP_EMITS_NOTHING
                  && (!hit->back || walk->scene->parts[hit->part].back_emits);
    return shines ? material->radiance : pp_rgb_grey(0.0);
}

/* theory: next event */
/* Draws an opening in proportion to an estimate of its light, and a direction to it.
 * The density of directions is uniform in solid angle, times the cosine and the
 * estimated brightness behind the opening. *per_pdf: reciprocal of the direction's
 * density (sr). False if no opening is visible or the point is outdoors. */
static bool aim_at_opening(struct pp_path_walk *walk, const struct pp_lit_point *at,
                           int *opening, struct pp_light_ray *ray, double *per_pdf)
{
    const struct pp_light_scene *scene = walk->scene;
    if (scene->pane_count == 0 || at->space == PP_OUTDOORS)
        return false;
    const struct pp_openings_viewer viewer = {&walk->environment->brightness, at->point,
                                              at->normal, false};
    double u[3], probability;
    pp_path_walk_draw(walk, 3, u);
    *opening = pp_openings_choose(scene, &viewer, &walk->shares, u[2], &probability);
    if (*opening < 0)
        return false;
    struct pp_polygon_sampler sampler;
    pp_sample_polygon_init(&sampler, &scene->panes[*opening].target, at->point,
                           at->normal, viewer.brightness);
    struct pp_direction_sample to = pp_sample_polygon_draw(&sampler, u[0], u[1]);
    *ray = (struct pp_light_ray){at->point, at->normal, to.direction, at->space};
    *per_pdf = to.per_density / probability;
    return true;
}

struct pp_rgb pp_path_trace_openings(struct pp_path_walk *walk,
                                     const struct pp_lit_point *at,
                                     enum pp_path_first *first)
{
    struct pp_rgb none = pp_rgb_grey(0.0), beta = pp_rgb_grey(1.0);
    struct pp_light_ray ray;
    struct pp_light_hit hit;
    double per_pdf;
    int opening;
    if (!aim_at_opening(walk, at, &opening, &ray, &per_pdf))
        return none;
    double cosine = pp_vec_dot(at->normal, ray.to);
    if (!(cosine > 0.0) || pp_path_walk_meet(walk, &ray, &hit) != PP_MEETS_PART
        || hit.part != walk->scene->panes[opening].part)
        return none;

    /* Out through the pane. Outside, the path continues without next-event
     * estimation. */
    struct pp_lobes lobes = pp_path_walk_lobes(walk, &hit, pp_vec_scale(ray.to, -1.0));
    for (int i = 0; i < PP_LOBE_COUNT; i++)
        if (!pp_scatter_goes_through((enum pp_lobe)i))
            lobes.share[i] = none;
    if (pp_path_walk_scatter(walk, &lobes, &hit, &ray, &beta) == PP_LOBE_COUNT)
        return none;
    struct pp_rgb L = pp_path_trace_radiance(walk, ray, false, false, first);
    return pp_rgb_scale(pp_rgb_times(beta, L), cosine * per_pdf);
}
/* theory: end */

/* Radiance towards the eye that the surface's diffuse lobes, on both sides, scatter
 * from light that comes directly through openings. */
static struct pp_rgb direct_light(struct pp_path_walk *walk,
                                  const struct pp_lobes *lobes,
                                  const struct pp_light_hit *hit)
{
    struct pp_rgb L = pp_rgb_grey(0.0);
    for (int side = 0; side < 2; side++) {
        struct pp_rgb albedo =
            lobes->share[side ? PP_LOBE_THROUGH_DIFFUSE : PP_LOBE_DIFFUSE];
        if (pp_rgb_is_black(albedo))
            continue;
        struct pp_lit_point at = {
            hit->point, side ? pp_vec_scale(lobes->frame.z, -1.0) : lobes->frame.z,
            hit->space};
        if (hit->part >= 0)
            at.space = pp_light_scene_parts_space(walk->scene, hit, side);
        struct pp_rgb E = pp_path_trace_openings(walk, &at, NULL);
        L = pp_rgb_add(L, pp_rgb_scale(pp_rgb_times(albedo, E), 1.0 / PP_PI));
    }
    return L;
}

/* theory: path loop */
struct pp_rgb pp_path_trace_radiance(struct pp_path_walk *walk, struct pp_light_ray ray,
                                     bool counted, bool aims, enum pp_path_first *first)
{
    struct pp_rgb L = pp_rgb_grey(0.0), beta = pp_rgb_grey(1.0);
    enum pp_path_first met = PP_FIRST_NONE;
    for (int bounce = 0; bounce < MOST_BOUNCES; bounce++) {
        /* 1. The first surface that the ray meets, if any. */
        struct pp_light_hit hit;
        enum pp_meeting meeting = pp_path_walk_meet(walk, &ray, &hit);
        if (meeting == PP_MEETS_LEAK)
            break;
        if (meeting == PP_MEETS_ENVIRONMENT) {
            bool is_sky;
            struct pp_rgb Le = pp_light_scene_environment(
                walk->scene, walk->environment, ray.to, &is_sky);
            L = pp_rgb_add(L, pp_rgb_times(beta, Le));
            if (met == PP_FIRST_NONE)
                met = is_sky ? PP_FIRST_SKY : PP_FIRST_OUTSIDE;
            break;
        }

        /* 2. Emission. */
        if (meeting == PP_MEETS_PART)
            L = pp_rgb_add(L, pp_rgb_times(beta, emitted(walk, &hit)));

        /* 3. The lobes of its BSDF. If next-event estimation at the ray's origin has
         * counted the light through openings, only the reflection of the pane is
         * left. */
        struct pp_vec3 wo = pp_vec_scale(ray.to, -1.0);
        struct pp_lobes lobes = pp_path_walk_lobes(walk, &hit, wo);
        bool opening =
            meeting == PP_MEETS_PART && walk->scene->parts[hit.part].window >= 0;
        if (opening && !hit.back && counted)
            lobes.share[PP_LOBE_STRAIGHT] = lobes.share[PP_LOBE_THROUGH_DIFFUSE] =
                lobes.share[PP_LOBE_THROUGH_GLOSS] = pp_rgb_grey(0.0);

        /* 4. Next-event estimation: samples directions to the openings. */
        if (aims)
            L = pp_rgb_add(L, pp_rgb_times(beta, direct_light(walk, &lobes, &hit)));

        /* 5. Sample a direction wi from one of the lobes. */
        enum pp_lobe lobe = pp_path_walk_scatter(walk, &lobes, &hit, &ray, &beta);
        if (lobe == PP_LOBE_COUNT)
            break;
        if (!pp_scatter_goes_through(lobe) && met == PP_FIRST_NONE)
            met = hit.space == PP_INDOORS ? PP_FIRST_INSIDE : PP_FIRST_OUTSIDE;
        if (lobe != PP_LOBE_STRAIGHT)
            counted = aims && ray.space != PP_OUTDOORS
                      && (lobe == PP_LOBE_DIFFUSE || lobe == PP_LOBE_THROUGH_DIFFUSE);

        /* 6. Russian roulette: a path of low throughput continues with probability
         * q. */
        double u, q = pp_rgb_most(beta) / LEAST;
        pp_path_walk_draw(walk, 1, &u);
        if (u >= q)
            break;
        if (q < 1.0)
            beta = pp_rgb_scale(beta, 1.0 / q);
    }
    if (first)
        *first = met;
    return L;
}
/* theory: end */

struct pp_rgb pp_path_trace_lobe(struct pp_path_walk *walk,
                                 const struct pp_lit_point *at, bool counted,
                                 enum pp_path_first *first)
{
    double u[2];
    struct pp_vec3 a, b;
    pp_path_walk_draw(walk, 2, u);
    pp_lobe_frame(at->normal, &a, &b);
    struct pp_light_ray ray = {at->point, at->normal,
                               pp_lobe_sample_in_frame(a, b, at->normal, u[0], u[1]),
                               at->space};
    struct pp_rgb L = pp_path_trace_radiance(walk, ray, counted, true, first);
    return pp_rgb_scale(L, PP_PI);
}
