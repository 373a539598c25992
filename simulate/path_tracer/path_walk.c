/* path_walk.c - the random numbers of a path at each vertex, its rays, and
 * scattering. */
#include "simulate/path_tracer/path_walk.h"

#include "simulate/sampling/lobe.h"
#include "simulate/sampling/sample_discrete.h"
#include "simulate/scene/light_scene_parts.h"

void pp_path_walk_draw(struct pp_path_walk *walk, int count, double *u)
{
    pp_sobol_sequence_draw(&walk->sequence, walk->index, walk->vertex++, count, u);
}

enum pp_meeting pp_path_walk_meet(struct pp_path_walk *walk,
                                  const struct pp_light_ray *ray,
                                  struct pp_light_hit *hit)
{
    enum pp_meeting meeting = pp_light_scene_trace(walk->scene, ray, hit);
    walk->rays++;
    walk->leaks += meeting == PP_MEETS_LEAK;
    if (meeting == PP_MEETS_PART || meeting == PP_MEETS_GROUND)
        hit->point = pp_rays_draw_back(hit->point, ray->to);
    return meeting;
}

enum pp_lobe pp_path_walk_scatter(struct pp_path_walk *walk,
                                  const struct pp_lobes *lobes,
                                  const struct pp_light_hit *hit,
                                  struct pp_light_ray *ray, struct pp_rgb *beta)
{
    double u[3], albedo[PP_LOBE_COUNT], total = 0.0;
    struct pp_rgb factor;
    pp_path_walk_draw(walk, 3, u);
    for (int i = 0; i < PP_LOBE_COUNT; i++)
        total += albedo[i] = pp_rgb_most(lobes->share[i]);
    int lobe = pp_sample_discrete(albedo, PP_LOBE_COUNT, u[2] * total);
    struct pp_vec3 wi;
    if (lobe < 0
        || !pp_scatter_sample(lobes, (enum pp_lobe)lobe, u[0], u[1], &wi, &factor))
        return PP_LOBE_COUNT;
    /* BSDF x cosine / pdf of the lobe is its albedo times the factor; the lobe itself
     * was drawn with the probability albedo / total. */
    *beta = pp_rgb_times(*beta, lobes->share[lobe]);
    *beta = pp_rgb_times(*beta, pp_rgb(factor.r * total / albedo[lobe],
                                       factor.g * total / albedo[lobe],
                                       factor.b * total / albedo[lobe]));

    bool through = pp_scatter_goes_through((enum pp_lobe)lobe);
    struct pp_vec3 n = lobes->frame.z;
    enum pp_space space = hit->space;
    if (hit->part >= 0)
        space = pp_light_scene_parts_space(walk->scene, hit, through);
    *ray = (struct pp_light_ray){.from = hit->point,
                                 .off = through ? pp_vec_scale(n, -1.0) : n,
                                 .to = wi,
                                 .space = space};
    return (enum pp_lobe)lobe;
}

struct pp_lobes pp_path_walk_lobes(const struct pp_path_walk *walk,
                                   const struct pp_light_hit *hit, struct pp_vec3 wo)
{
    struct pp_lobes lobes;
    if (hit->part >= 0) {
        pp_light_scene_parts_lobes(walk->scene, hit, pp_vec_scale(wo, -1.0), &lobes);
        return lobes;
    }
    lobes = (struct pp_lobes){.eye = wo, .frame = {.z = hit->normal}};
    lobes.share[PP_LOBE_DIFFUSE] =
        pp_rgb_grey(pp_outside_light_ground(&walk->environment->light));
    pp_lobe_frame(hit->normal, &lobes.frame.x, &lobes.frame.y);
    return lobes;
}
