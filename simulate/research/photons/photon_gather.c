/* photon_gather.c - see photon_gather.h. */
#include "simulate/research/photons/photon_gather.h"

#include <math.h>

#include "simulate/research/photons/photon_outside.h"
#include "simulate/sampling/lobe.h"

/* Labels of the branches of a vertex, for independent random numbers. */
enum { OF_OUTSIDE, OF_PHOTON, OF_CONNECTION };

/* A ray on its way from a receiver. */
struct gathering {
    struct pp_photon_receiver receiver; /* place of the last diffuse scattering, where
                                         * the ray starts */
    struct pp_light_ray ray;
    struct pp_rgb throughput; /* irradiance at the first receiver for unit radiance
                               * along the ray */
    double here;              /* cosine at the receiver */
    double gone_m;
    bool straight; /* the ray arrived directly, or through clear glass */
    bool seen;     /* true if the component at the first receiver is already known:
                    * `what` */
    enum pp_photon_last what;
    struct pp_light_hit hit;
    struct pp_lobes lobes;
    int vertex;
    double *sums;
};

static void add_gathered_light(struct gathering *ray, struct pp_rgb radiance,
                               double share, enum pp_photon_last what)
{
    struct pp_rgb light = pp_rgb_times(ray->throughput, radiance);
    ray->sums[ray->seen ? ray->what : what] += share * pp_rgb_luminance(light);
}

/* Fraction of the light at the ray's end that connections do not cover. */
static double left_of(const struct pp_photon_state *state, const struct gathering *ray,
                      int source)
{
    if (!ray->straight)
        return 1.0;
    double limit = pp_photon_receiver_limit(state, &ray->receiver, source);
    double there = -pp_vec_dot(ray->hit.normal, ray->ray.to);
    double projected = ray->here * there / (ray->gone_m * ray->gone_m);
    return projected > limit ? 1.0 - limit / projected : 0.0;
}

/* Adds the light that enters through the pane, which the ray has hit from inside. */
static void add_entering(struct pp_photon_state *state, struct gathering *ray, int pane)
{
    double share = left_of(state, ray, pane), u[2];
    const struct pp_light_part *part = &state->scene->parts[ray->hit.part];
    struct pp_rgb through = ray->lobes.share[PP_LOBE_STRAIGHT];
    int vertex = pp_photon_state_branch(ray->vertex, OF_OUTSIDE);
    struct pp_vec3 out = pp_vec_scale(ray->hit.normal, -1.0);
    struct pp_light_ray back = {ray->hit.point, out, ray->ray.to, PP_OUTDOORS};
    if (!state->sources->list[pane].clear) {
        through = ray->lobes.share[PP_LOBE_THROUGH_DIFFUSE];
        pp_photon_state_draw(state, vertex, 2, u);
        back.to = pp_lobe_sample_in_frame(part->a, part->b, out, u[0], u[1]);
    }
    if (!(share > 0.0) || pp_rgb_is_black(through))
        return;
    bool is_sky;
    struct pp_rgb light = pp_photon_outside(
        state, back, state->scene->panes[pane].unobstructed, vertex + 1, &is_sky);
    add_gathered_light(ray, pp_rgb_times(light, through), share,
                       is_sky ? PP_PHOTON_FROM_SKY : PP_PHOTON_FROM_OUTSIDE);
}

/* Adds the light of sources that the ray has reached. */
static void add_sources(struct pp_photon_state *state, struct gathering *ray)
{
    const struct pp_photon_sources *sources = state->sources;
    const struct pp_light_hit *hit = &ray->hit;
    int pane = hit->part < 0 ? -1 : state->scene->parts[hit->part].window;
    if (pane >= 0 && !hit->back)
        add_entering(state, ray, pane);
    for (int i = sources->pane_count; hit->part >= 0 && i < sources->count; i++) {
        const struct pp_photon_source *lamp = &sources->list[i];
        if (lamp->part == hit->part && lamp->back == hit->back)
            add_gathered_light(ray, lamp->radiance, left_of(state, ray, i),
                               PP_PHOTON_FROM_INSIDE);
    }
}

/* Follows a photon and adds its light at the ray's end, which acts as a receiver. */
static void add_photon(struct pp_photon_state *state, struct gathering *ray)
{
    struct pp_photon photon;
    struct pp_photon_place place;
    enum pp_photon_last last;
    int outside = pp_photon_state_branch(ray->vertex, OF_CONNECTION);
    int vertex = pp_photon_state_branch(ray->vertex, OF_PHOTON);
    if (!pp_photon_begin(state, state->sources->count, vertex, &photon, &place))
        return;
    struct pp_rgb sum =
        pp_photon_receiver_takes(state, &ray->receiver, &place, outside, &last);
    while (pp_photon_arrive(state, &photon)) {
        for (int side = 0; side < 2; side++)
            if (pp_photon_leaves(state, &photon, side, &place))
                sum = pp_rgb_add(sum, pp_photon_receiver_takes(state, &ray->receiver,
                                                               &place, outside, &last));
        if (!pp_photon_turn(state, &photon))
            break;
    }
    add_gathered_light(ray, sum, 1.0 / PP_PI, ray->what);
}

/* Continues the ray by one of the surface's lobes; false if it ends. */
static bool turn_gathering_ray(struct pp_photon_state *state, struct gathering *ray)
{
    double u[3]; /* direction (2), lobe */
    double left = left_of(state, ray, -1);
    const double weights[PP_LOBE_COUNT] = {left, left, 1.0, 1.0, 1.0, 1.0};
    pp_photon_state_draw(state, ray->vertex, 3, u);
    enum pp_lobe lobe =
        pp_photon_lobes_choose(&ray->lobes, weights, PP_PI, u[2], &ray->throughput);
    if (lobe == PP_LOBE_COUNT
        || !pp_photon_lobes_turn(state, &ray->lobes, lobe, &ray->hit, u[0], u[1],
                                 &ray->ray, &ray->throughput))
        return false;
    if (lobe == PP_LOBE_STRAIGHT)
        return true;
    ray->straight = false;
    enum pp_space space =
        pp_scatter_goes_through(lobe) ? ray->ray.space : ray->hit.space;
    if (!ray->seen)
        ray->what =
            space == PP_INDOORS ? PP_PHOTON_FROM_INSIDE : PP_PHOTON_FROM_OUTSIDE;
    ray->seen = true;
    if (lobe != PP_LOBE_DIFFUSE && lobe != PP_LOBE_THROUGH_DIFFUSE)
        return true;
    ray->throughput = pp_rgb_scale(ray->throughput, weights[lobe]);
    ray->receiver =
        (struct pp_photon_receiver){ray->ray.from, ray->ray.off, ray->ray.space, NULL};
    ray->here = pp_vec_dot(ray->ray.off, ray->ray.to);
    ray->gone_m = 0.0;
    ray->straight = true;
    add_photon(state, ray);
    return true;
}

static struct gathering begin_gathering(const struct pp_photon_state *state,
                                        const struct pp_photon_receiver *receiver,
                                        int vertex, double sums[3])
{
    double u[2];
    struct pp_vec3 a, b;
    struct gathering ray = {.receiver = *receiver,
                            .throughput = pp_rgb_grey(PP_PI),
                            .straight = true,
                            .vertex = vertex + 1,
                            .sums = sums};
    pp_photon_state_draw(state, vertex, 2, u);
    pp_lobe_frame(receiver->normal, &a, &b);
    ray.ray = (struct pp_light_ray){
        receiver->point, receiver->normal,
        pp_lobe_sample_in_frame(a, b, receiver->normal, u[0], u[1]), receiver->space};
    ray.here = pp_vec_dot(receiver->normal, ray.ray.to);
    return ray;
}

void pp_photon_gather(struct pp_photon_state *state,
                      const struct pp_photon_receiver *receiver, int vertex,
                      double sums[3])
{
    struct gathering ray = begin_gathering(state, receiver, vertex, sums);
    if (!state->scene->has_room) {
        bool is_sky;
        struct pp_rgb light =
            pp_photon_outside(state, ray.ray, false, ray.vertex, &is_sky);
        add_gathered_light(&ray, light, 1.0,
                           is_sky ? PP_PHOTON_FROM_SKY : PP_PHOTON_FROM_OUTSIDE);
        return;
    }
    for (int i = 0; i < PP_PHOTON_MOST_VERTICES; i++, ray.vertex++) {
        enum pp_meeting meeting = pp_photon_state_meet(state, &ray.ray, &ray.hit);
        if (meeting != PP_MEETS_PART && meeting != PP_MEETS_GROUND)
            return;
        ray.gone_m += ray.hit.distance_m;
        ray.lobes = pp_photon_lobes_at(state, &ray.hit, ray.ray.to);
        add_sources(state, &ray);
        if (!turn_gathering_ray(state, &ray))
            return;
    }
}
