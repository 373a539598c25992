/* path_scatter.c - see path_scatter.h. */
#include "simulate/transport/path_scatter.h"

#include "simulate/sampling/sample_bright.h"
#include "simulate/sampling/sample_discrete.h"

void pp_path_scatter_note_met(struct pp_light_path *path, enum pp_space space)
{
    if (path->first_met == PP_MET_NOTHING)
        path->first_met = space == PP_INDOORS ? PP_MET_INSIDE : PP_MET_OUTSIDE;
}

bool pp_path_scatter_survives(struct pp_light_path *path, double least, double u)
{
    double chance = pp_rgb_most(path->throughput) / least;
    if (chance >= 1.0)
        return true;
    path->throughput = pp_rgb_scale(path->throughput, 1.0 / chance);
    return u < chance;
}

enum pp_lobe pp_path_scatter_choose_lobe(const struct pp_lobes *lobes, double u,
                                         struct pp_rgb *throughput)
{
    double chance[PP_LOBE_COUNT], total = 0.0;
    for (int i = 0; i < PP_LOBE_COUNT; i++)
        total += chance[i] = pp_rgb_most(lobes->share[i]);
    if (!(total > 0.0))
        return PP_LOBE_COUNT;
    int chosen = pp_sample_discrete(chance, PP_LOBE_COUNT, u * total);
    *throughput = pp_rgb_scale(pp_rgb_times(*throughput, lobes->share[chosen]),
                               total / chance[chosen]);
    return (enum pp_lobe)chosen;
}

/* Records, for a ray that leaves by this lobe, which light of emitters and windows was
 * already sampled directly. */
static void note_sampled(const struct pp_radiance_state *state,
                         struct pp_light_path *path, const struct pp_lobes *lobes,
                         enum pp_lobe lobe, const struct pp_light_hit *hit)
{
    if (lobe != PP_LOBE_STRAIGHT || path->ray.space == PP_OUTDOORS)
        path->sampled_in = path->ray.space;
    path->from_diffuse = lobe == PP_LOBE_DIFFUSE || lobe == PP_LOBE_THROUGH_DIFFUSE;
    if (path->from_diffuse) {
        path->sampled = PP_DIRECTLY_SAMPLED_ALL;
        path->mirror_path = -1;
        path->depth++;
    } else if (lobe == PP_LOBE_GLOSS || lobe == PP_LOBE_THROUGH_GLOSS) {
        path->sampled = PP_DIRECTLY_SAMPLED_GLOSS;
        path->mirror_path = -1;
        path->gloss_point = hit->point;
        path->gloss_normal = path->ray.off;
        path->gloss_split = path->here_split;
        path->arrival = path->here_arrival;
        if (lobe == PP_LOBE_THROUGH_GLOSS)
            path->arrival.reflector = -1;
        path->gloss_rays = path->here_gloss_rays;
        path->gloss_pdf =
            path->here_gloss_rays * pp_scatter_gloss_pdf(lobes, path->ray.to);
    } else if (lobe == PP_LOBE_MIRROR) {
        path->arrival = path->here_arrival;
        path->mirror_path = pp_mirrors_path_extend(
            state->scene, path->mirror_path, state->scene->parts[hit->part].mirror);
        if (path->mirror_path < 0)
            path->sampled = PP_DIRECTLY_SAMPLED_NONE;
    }
}

bool pp_path_scatter_by_lobe(const struct pp_radiance_state *state,
                             struct pp_light_path *path, const struct pp_lobes *lobes,
                             enum pp_lobe lobe, const struct pp_light_hit *hit,
                             double u, double v)
{
    struct pp_rgb factor;
    if (!pp_scatter_sample(lobes, lobe, u, v, &path->ray.to, &factor))
        return false;
    path->throughput = pp_rgb_times(path->throughput, factor);
    bool through = pp_scatter_goes_through(lobe);
    if (!through)
        pp_path_scatter_note_met(path, hit->space);
    path->ray.from = hit->point;
    path->ray.off = through ? pp_vec_scale(lobes->frame.z, -1.0) : lobes->frame.z;
    path->ray.space = pp_light_scene_parts_space(state->scene, hit, through);
    note_sampled(state, path, lobes, lobe, hit);
    return true;
}

/* The bright parts of the sky to which directions of a path are sampled; NULL: none.
 * Indoors there are none, since their light comes by samples through the openings,
 * unless the path has come from an opening. */
static const struct pp_sky_bright *bright_for(const struct pp_radiance_state *state,
                                              const struct pp_light_path *path,
                                              enum pp_space space)
{
    bool here = state->environment && (path->from_window || space != PP_INDOORS);
    return here ? state->environment->bright : NULL;
}

bool pp_path_scatter_diffuse(const struct pp_radiance_state *state,
                             struct pp_light_path *path, struct pp_vec3 from,
                             const struct pp_frame *frame, enum pp_space space,
                             double least)
{
    double u[4]; /* direction (2), choice of its density, Russian roulette */
    pp_sobol_sequence_draw(&state->sequence, state->index, path->vertex * PP_DRAWS, 4,
                           u);
    path->ray = (struct pp_light_ray){from, frame->z, frame->z, space};
    double weight;
    if (space != PP_OUTDOORS || state->scene->coarse.count == 0
        || !pp_coarse_openings_draw(
            &state->scene->coarse, &state->environment->brightness, from, frame,
            pp_rgb_most(path->throughput), u, &path->ray.to, &weight))
        weight = pp_sample_bright_lobe(bright_for(state, path, space), frame->x,
                                       frame->y, frame->z, u[0], u[1], &path->ray.to);
    path->sampled = PP_DIRECTLY_SAMPLED_ALL;
    path->sampled_in = space;
    path->from_diffuse = true;
    path->mirror_path = -1;
    bool survives = pp_path_scatter_survives(path, least, u[3]);
    path->throughput = pp_rgb_scale(path->throughput, weight);
    return survives;
}
