/* photon.c - see photon.h. */
#include "simulate/research/photons/photon.h"

#include "simulate/research/photons/photon_outside.h"
#include "simulate/sampling/lobe.h"
#include "simulate/sampling/sample_discrete.h"

/* Russian roulette applies to photons with less than this fraction of the mean flux of
 * all photons. Chosen by trial. */
static const double LEAST = 0.3;

static struct pp_rgb through_of(const struct pp_photon_state *state,
                                const struct pp_photon_source *source, double cosine)
{
    const struct pp_light_part *part = &state->scene->parts[source->part];
    const struct pp_material *material =
        &state->scene->materials[part->material[source->back]];
    return source->clear ? pp_scatter_regular_transmittance(material, cosine)
                         : material->through_diffuse;
}

/* Light that enters at a point of an opening from a sampled direction, divided by the
 * density of the direction. The density is relative to that of the cosine lobe. At
 * clear glass the photon continues in this direction. */
static struct pp_rgb enter(struct pp_photon_state *state,
                           const struct pp_photon_source *source, const double u[2],
                           int vertex, struct pp_photon *photon)
{
    double density;
    bool is_sky;
    struct pp_vec3 out = pp_vec_scale(photon->ray.off, -1.0);
    struct pp_light_ray back = {photon->ray.from, out, out, PP_OUTDOORS};
    back.to =
        pp_photon_sources_direction(state->scene, source, out, u[0], u[1], &density);
    struct pp_rgb light = pp_photon_outside(
        state, back, state->scene->panes[source->pane].unobstructed, vertex, &is_sky);
    struct pp_rgb through = through_of(state, source, pp_vec_dot(out, back.to));
    photon->ray.to = pp_vec_scale(back.to, -1.0);
    photon->last = is_sky ? PP_PHOTON_FROM_SKY : PP_PHOTON_FROM_OUTSIDE;
    return pp_rgb_scale(pp_rgb_times(light, through), 1.0 / density);
}

/* Starts a photon at a source that was drawn with probability `chance`: its direction
 * from u[0] and u[1], its position from u[2] and u[3]. */
static void set_out(struct pp_photon_state *state,
                    const struct pp_photon_source *source, double chance,
                    const double u[4], int vertex, struct pp_photon *photon)
{
    const struct pp_light_part *part = &state->scene->parts[source->part];
    double w[2];
    *photon = (struct pp_photon){.last = PP_PHOTON_FROM_INSIDE,
                                 .scattered = source->pane < 0};
    photon->ray.from = pp_photon_sources_point(state->scene, source, u[2], u[3]);
    photon->ray.off = source->back ? pp_vec_scale(part->normal, -1.0) : part->normal;
    photon->ray.space = (enum pp_space)part->space[source->back];
    struct pp_rgb light = source->radiance;
    if (source->pane >= 0)
        light = enter(state, source, u, pp_photon_state_branch(vertex, 0), photon);
    photon->flux = pp_rgb_scale(light, PP_PI * source->area_m2 / chance);
    if (!source->clear) {
        pp_photon_state_draw(state, pp_photon_state_branch(vertex, 1), 2, w);
        photon->ray.to =
            pp_lobe_sample_in_frame(part->a, part->b, photon->ray.off, w[0], w[1]);
    }
}

/* Position of the photon's start, as a source of light for receivers. */
static struct pp_photon_place first_place(const struct pp_photon *photon,
                                          const struct pp_photon_source *source,
                                          int index, double chance)
{
    double per_density = PP_PI * source->area_m2 / chance;
    return (struct pp_photon_place){photon->ray.from,
                                    photon->ray.off,
                                    photon->ray.space,
                                    source->clear ? pp_rgb_grey(per_density)
                                                  : photon->flux,
                                    source->clear ? source->pane : -1,
                                    index,
                                    photon->last};
}

bool pp_photon_begin(struct pp_photon_state *state, int count, int vertex,
                     struct pp_photon *photon, struct pp_photon_place *place)
{
    const struct pp_photon_sources *sources = state->sources;
    double u[5]; /* direction (2), place (2), source */
    pp_photon_state_draw(state, vertex, 5, u);
    int index = pp_photon_sources_choose(sources, count, u[4]);
    if (index < 0)
        return false;
    const struct pp_photon_source *source = &sources->list[index];
    double total = count < sources->count ? sources->pane_power : sources->power;
    double chance = source->power / total;
    set_out(state, source, chance, u, vertex, photon);
    *place = first_place(photon, source, index, chance);
    photon->vertex = vertex + 1;
    return true;
}

void pp_photon_enter(struct pp_photon_state *state, const double *chances, int vertex,
                     struct pp_photon_place *place)
{
    const struct pp_photon_sources *sources = state->sources;
    double u[3], w[2]; /* place (2), opening; direction outside (2) */
    struct pp_photon photon = {.turns = 0};
    pp_photon_state_draw(state, vertex, 3, u);
    int index = pp_sample_discrete(chances, sources->pane_count, u[2]);
    const struct pp_photon_source *source = &sources->list[index];
    photon.last = PP_PHOTON_FROM_OUTSIDE;
    photon.ray.from = pp_photon_sources_point(state->scene, source, u[0], u[1]);
    photon.ray.off = state->scene->parts[source->part].normal;
    photon.ray.space = PP_INDOORS;
    if (!source->clear) {
        int branch = pp_photon_state_branch(vertex, 0);
        pp_photon_state_draw(state, branch, 2, w);
        struct pp_rgb light = enter(state, source, w, branch + 1, &photon);
        photon.flux = pp_rgb_scale(light, PP_PI * source->area_m2 / chances[index]);
    }
    *place = first_place(&photon, source, index, chances[index]);
}

bool pp_photon_arrive(struct pp_photon_state *state, struct pp_photon *photon)
{
    enum pp_meeting meeting = pp_photon_state_meet(state, &photon->ray, &photon->hit);
    if (meeting == PP_MEETS_LEAK)
        photon->hit.distance_m = 0.0;
    if (meeting != PP_MEETS_PART && meeting != PP_MEETS_GROUND)
        return false;
    photon->lobes = pp_photon_lobes_at(state, &photon->hit, photon->ray.to);
    return true;
}

/* Component of the photon's light. Light through a diffusing pane belongs to the same
 * component as light through clear glass. */
static enum pp_photon_last last_of(const struct pp_photon *photon, bool through,
                                   enum pp_space space)
{
    if (through && space == PP_INDOORS)
        return photon->last;
    return space == PP_INDOORS ? PP_PHOTON_FROM_INSIDE : PP_PHOTON_FROM_OUTSIDE;
}

bool pp_photon_leaves(const struct pp_photon_state *state,
                      const struct pp_photon *photon, int side,
                      struct pp_photon_place *place)
{
    const struct pp_light_hit *hit = &photon->hit;
    struct pp_rgb share =
        photon->lobes.share[side ? PP_LOBE_THROUGH_DIFFUSE : PP_LOBE_DIFFUSE];
    if (pp_rgb_is_black(share))
        return false;
    *place = (struct pp_photon_place){
        .point = pp_photon_state_drawn_back(hit, photon->ray.to),
        .normal = side ? pp_vec_scale(hit->normal, -1.0) : hit->normal,
        .space = pp_light_scene_parts_space(state->scene, hit, side),
        .exitance = pp_rgb_times(photon->flux, share),
        .clear = -1,
        .source = -1};
    place->last = last_of(photon, side, place->space);
    return true;
}

bool pp_photon_turn(struct pp_photon_state *state, struct pp_photon *photon)
{
    double u[3]; /* direction (2), lobe */
    if (photon->turns++ >= PP_PHOTON_MOST_VERTICES)
        return false;
    pp_photon_state_draw(state, photon->vertex++, 3, u);
    enum pp_lobe lobe = pp_photon_lobes_choose(
        &photon->lobes, NULL, LEAST * state->sources->power, u[2], &photon->flux);
    if (lobe == PP_LOBE_COUNT
        || !pp_photon_lobes_turn(state, &photon->lobes, lobe, &photon->hit, u[0], u[1],
                                 &photon->ray, &photon->flux))
        return false;
    photon->scattered |= lobe != PP_LOBE_STRAIGHT;
    if (lobe != PP_LOBE_STRAIGHT)
        photon->last =
            last_of(photon, pp_scatter_goes_through(lobe), photon->ray.space);
    return true;
}
