/* photon_outside.c - see photon_outside.h. */
#include "simulate/research/photons/photon_outside.h"

#include "simulate/research/photons/photon_lobes.h"

/* Russian roulette applies if the throughput is below this value. Chosen by
 * trial. */
static const double LEAST = 0.1;

/* Emission of a side of a part outdoors; lamps indoors are sources of photons
 * instead. */
static struct pp_rgb emission(const struct pp_light_scene *scene,
                              const struct pp_light_hit *hit)
{
    const struct pp_material *material;
    if (hit->part < 0 || (scene->has_room && hit->space == PP_INDOORS)
        || (hit->back && !scene->parts[hit->part].back_emits))
        return pp_rgb_grey(0.0);
    material = &scene->materials[hit->material];
    return material->emits == PP_EMITS_NOTHING ? pp_rgb_grey(0.0) : material->radiance;
}

/* Scatters the path at the surface met and sets its next ray; returns the lobe,
 * PP_LOBE_COUNT if the path ends. */
static enum pp_lobe next_photon_ray(struct pp_photon_state *state,
                                    const struct pp_light_hit *hit, int vertex,
                                    struct pp_light_ray *ray, struct pp_rgb *throughput)
{
    double u[3]; /* direction (2), lobe */
    struct pp_lobes lobes = pp_photon_lobes_at(state, hit, ray->to);
    if (hit->part >= 0 && state->scene->parts[hit->part].window >= 0)
        lobes.share[PP_LOBE_STRAIGHT] = lobes.share[PP_LOBE_THROUGH_DIFFUSE] =
            pp_rgb_grey(0.0);
    pp_photon_state_draw(state, vertex, 3, u);
    enum pp_lobe lobe = pp_photon_lobes_choose(&lobes, NULL, LEAST, u[2], throughput);
    return lobe != PP_LOBE_COUNT
                   && pp_photon_lobes_turn(state, &lobes, lobe, hit, u[0], u[1], ray,
                                           throughput)
               ? lobe
               : PP_LOBE_COUNT;
}

struct pp_rgb pp_photon_outside(struct pp_photon_state *state, struct pp_light_ray ray,
                                bool free, int vertex, bool *is_sky)
{
    struct pp_rgb sum = pp_rgb_grey(0.0), throughput = pp_rgb_grey(1.0);
    bool straight = true; /* only panes passed so far */
    *is_sky = false;
    for (int i = 0; i < PP_PHOTON_MOST_VERTICES; i++) {
        struct pp_light_hit hit;
        bool sky;
        enum pp_meeting meeting =
            free && i == 0 ? pp_light_scene_meet_outside(state->scene, &ray, &hit)
                           : pp_photon_state_meet(state, &ray, &hit);
        if (meeting == PP_MEETS_LEAK)
            return sum;
        if (meeting == PP_MEETS_ENVIRONMENT) {
            struct pp_rgb light = pp_light_scene_environment(
                state->scene, state->environment, ray.to, &sky);
            *is_sky = straight && sky;
            return pp_rgb_add(sum, pp_rgb_times(throughput, light));
        }
        sum = pp_rgb_add(sum, pp_rgb_times(throughput, emission(state->scene, &hit)));
        enum pp_lobe lobe = next_photon_ray(state, &hit, vertex + i, &ray, &throughput);
        if (lobe == PP_LOBE_COUNT)
            return sum;
        straight = straight && lobe == PP_LOBE_STRAIGHT;
    }
    return sum;
}
