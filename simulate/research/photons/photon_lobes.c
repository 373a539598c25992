/* photon_lobes.c - see photon_lobes.h. */
#include "simulate/research/photons/photon_lobes.h"

#include "simulate/sampling/lobe.h"
#include "simulate/sampling/sample_discrete.h"

struct pp_lobes pp_photon_lobes_at(const struct pp_photon_state *state,
                                   const struct pp_light_hit *hit, struct pp_vec3 to)
{
    struct pp_lobes lobes;
    if (hit->part >= 0) {
        pp_light_scene_parts_lobes(state->scene, hit, to, &lobes);
        return lobes;
    }
    lobes =
        (struct pp_lobes){.frame = {.z = hit->normal}, .eye = pp_vec_scale(to, -1.0)};
    double ground = pp_outside_light_ground(&state->environment->light);
    lobes.share[PP_LOBE_DIFFUSE] = pp_rgb_grey(ground);
    pp_lobe_frame(hit->normal, &lobes.frame.x, &lobes.frame.y);
    return lobes;
}

enum pp_lobe pp_photon_lobes_choose(const struct pp_lobes *lobes, const double *weights,
                                    double least, double u, struct pp_rgb *throughput)
{
    double left[PP_LOBE_COUNT], total = 0.0;
    for (int i = 0; i < PP_LOBE_COUNT; i++) {
        left[i] = pp_rgb_most(pp_rgb_times(*throughput, lobes->share[i]));
        left[i] *= weights ? weights[i] : 1.0;
        total += left[i];
    }
    double survival = total < least ? total / least : 1.0;
    if (!(total > 0.0) || !(u < survival))
        return PP_LOBE_COUNT;
    int chosen = pp_sample_discrete(left, PP_LOBE_COUNT, u / survival * total);
    *throughput = pp_rgb_scale(pp_rgb_times(*throughput, lobes->share[chosen]),
                               total / left[chosen] / survival);
    return (enum pp_lobe)chosen;
}

bool pp_photon_lobes_turn(const struct pp_photon_state *state,
                          const struct pp_lobes *lobes, enum pp_lobe lobe,
                          const struct pp_light_hit *hit, double u, double v,
                          struct pp_light_ray *ray, struct pp_rgb *throughput)
{
    struct pp_rgb factor;
    bool through = pp_scatter_goes_through(lobe);
    struct pp_vec3 from = pp_photon_state_drawn_back(hit, ray->to);
    if (!pp_scatter_sample(lobes, lobe, u, v, &ray->to, &factor))
        return false;
    *throughput = pp_rgb_times(*throughput, factor);
    ray->from = from;
    ray->off = through ? pp_vec_scale(hit->normal, -1.0) : hit->normal;
    ray->space = pp_light_scene_parts_space(state->scene, hit, through);
    return true;
}
