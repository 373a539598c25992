/* photon_receiver.c - see photon_receiver.h. */
#include "simulate/research/photons/photon_receiver.h"

#include <math.h>

#include "simulate/research/photons/photon_outside.h"

enum { MOST_PANES = 64 }; /* most panes that a shadow ray passes */

/* Surfaces at less than this height above the receiver's plane do not hide it. They may
 * be the receiver's own surface, since intersections have single precision. */
static const double OVER_PLANE_M = 1e-5;

double pp_photon_receiver_limit(const struct pp_photon_state *state,
                                const struct pp_photon_receiver *receiver, int source)
{
    if (source < 0)
        return state->sources->limit;
    const struct pp_photon_source *of = &state->sources->list[source];
    if (of->pane >= 0 && receiver->chances)
        return pp_photon_sources_limit(of->area_m2, receiver->chances[of->pane]);
    return of->limit;
}

/* True if the ray meets only clear surfaces within the distance; multiplies *through by
 * their transmittance. cosine: at the receiver. */
static bool passes(struct pp_photon_state *state, struct pp_light_ray ray,
                   double distance_m, double cosine, struct pp_rgb *through)
{
    double left = distance_m;
    for (int i = 0; i < MOST_PANES; i++) {
        struct pp_light_hit hit;
        enum pp_meeting meeting = pp_photon_state_meet(state, &ray, &hit);
        if ((left - hit.distance_m) * cosine < OVER_PLANE_M)
            return true;
        if (meeting != PP_MEETS_PART)
            return false;
        if (!pp_light_scene_parts_pass(state->scene, &hit, &ray, through))
            return false;
        left -= hit.distance_m;
    }
    return false;
}

/* Light from outside that arrives at the place against direction `to` through its clear
 * pane, times the transmittance. */
static struct pp_rgb through_glass(struct pp_photon_state *state,
                                   const struct pp_photon_place *place,
                                   struct pp_vec3 to, int vertex,
                                   enum pp_photon_last *last)
{
    const struct pp_pane *pane = &state->scene->panes[place->clear];
    const struct pp_light_part *part = &state->scene->parts[pane->part];
    bool is_sky;
    struct pp_light_ray back = {place->point, pp_vec_scale(place->normal, -1.0),
                                pp_vec_scale(to, -1.0), PP_OUTDOORS};
    struct pp_rgb light =
        pp_photon_outside(state, back, pane->unobstructed, vertex, &is_sky);
    *last = is_sky ? PP_PHOTON_FROM_SKY : PP_PHOTON_FROM_OUTSIDE;
    return pp_rgb_times(light, pp_scatter_regular_transmittance(
                                   &state->scene->materials[part->material[0]],
                                   pp_vec_dot(place->normal, to)));
}

struct pp_rgb pp_photon_receiver_takes(struct pp_photon_state *state,
                                       const struct pp_photon_receiver *receiver,
                                       const struct pp_photon_place *place, int vertex,
                                       enum pp_photon_last *last)
{
    struct pp_vec3 way = pp_vec_sub(receiver->point, place->point);
    double distance = pp_vec_length(way);
    struct pp_rgb light = pp_rgb_grey(1.0), none = pp_rgb_grey(0.0);
    *last = place->last;
    if (!(distance > 0.0))
        return none;
    struct pp_vec3 to = pp_vec_scale(way, 1.0 / distance);
    double here = -pp_vec_dot(receiver->normal, to);
    double there = pp_vec_dot(place->normal, to);
    if (!(here > 0.0 && there > 0.0))
        return none;
    struct pp_light_ray ray = {place->point, place->normal, to, place->space};
    bool seen = state->sources->all_seen && receiver->space == PP_INDOORS
                && place->space == PP_INDOORS;
    if (!seen && !passes(state, ray, distance, here, &light))
        return none;
    if (place->clear >= 0)
        light = pp_rgb_times(light, through_glass(state, place, to, vertex, last));
    double projected = fmin(here * there / (distance * distance),
                            pp_photon_receiver_limit(state, receiver, place->source));
    return pp_rgb_scale(pp_rgb_times(light, place->exitance), projected / PP_PI);
}
