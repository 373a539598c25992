/* light_sources.c - direct light of concentrated emitters: connections, straight and by
 * mirrors, and the choice among them. */
#include "simulate/transport/light_sources.h"

#include <math.h>

#include "simulate/sampling/choose.h"

enum {
    /* Up to this many emitters, all are sampled at the first surface; of more, one. */
    MOST_EMITTERS = 64,
    /* The same for the connections by mirrors. */
    MOST_MIRRORED = 8,
};

bool pp_light_sources_directly_sampled(const struct pp_radiance_state *state,
                                       const struct pp_light_path *path, int emitter)
{
    if (!state->options.sources || path->sampled == PP_DIRECTLY_SAMPLED_NONE)
        return false;
    if (path->sampled == PP_DIRECTLY_SAMPLED_ALL)
        return true;
    struct pp_vec3 from =
        pp_mirrors_path_point(state->scene, path->mirror_path, path->gloss_point);
    return pp_emitters_angular_size(&state->scene->emitters[emitter], state->scene,
                                    from)
           < path->gloss_size;
}

/* How light gets from an emitter to the shading point: straight (mirror_path -1), or by
 * mirrors. */
struct connection {
    const struct pp_emitter *emitter; /* not owned */
    int mirror_path;
    struct pp_vec3 from, n; /* the shading point and its normal, or their images in the
                             * mirrors */
    double angular_size;
};

/* Connections are counted emitter by emitter: the straight ones, then those of each
 * mirror path. */
static struct connection connection_of(const struct pp_light_scene *scene,
                                       const struct pp_shading_point *shading,
                                       int index)
{
    struct connection connection = {&scene->emitters[index % scene->emitter_count],
                                    index / scene->emitter_count - 1, shading->point,
                                    shading->normal, 0.0};
    connection.from =
        pp_mirrors_path_point(scene, connection.mirror_path, connection.from);
    connection.n =
        pp_mirrors_path_direction(scene, connection.mirror_path, connection.n);
    connection.angular_size =
        pp_emitters_angular_size(connection.emitter, scene, connection.from);
    return connection;
}

/* Light from one direction to an emitter: BRDF, cosine and visibility times radiance,
 * over the direction's density. */
static struct pp_rgb light_from(struct pp_radiance_state *state,
                                const struct pp_shading_point *shading,
                                const struct connection *connection,
                                const struct pp_direction_sample *sample)
{
    const struct pp_light_scene *scene = state->scene;
    const struct pp_emitter *emitter = connection->emitter;
    struct pp_rgb none = pp_rgb_grey(0.0), through = pp_rgb_grey(1.0);
    struct pp_vec3 to =
        pp_mirrors_path_unfold(scene, connection->mirror_path, sample->direction);
    double cosine = pp_vec_dot(shading->normal, to), left = sample->distance_m;
    if (!(cosine > 0.0))
        return none;
    struct pp_rgb f = pp_path_vertex_brdf(shading, to, connection->angular_size);
    if (pp_rgb_is_black(f))
        return none;
    struct pp_light_ray ray = pp_path_vertex_shadow_ray(shading, to);
    for (int i = 0; connection->mirror_path >= 0 && i < PP_MIRROR_PATH_MOST; i++) {
        int mirror = scene->mirror_paths[connection->mirror_path].mirrors[i];
        if (mirror >= 0
            && !pp_radiance_state_reach_mirror(state, &ray, mirror, &left, &through))
            return none;
    }
    if (!pp_radiance_state_unoccluded(state, ray, emitter->part, left, &through))
        return none;
    struct pp_rgb radiance =
        emitter->distant < 0 ? emitter->radiance
                             : pp_light_scene_distant_radiance(scene, emitter->distant,
                                                               sample->direction);
    return pp_rgb_scale(pp_rgb_times(pp_rgb_times(f, through), radiance),
                        cosine * sample->per_density);
}

static struct pp_rgb sample_connection(struct pp_radiance_state *state,
                                       const struct pp_shading_point *shading,
                                       int index, int vertex)
{
    struct connection connection = connection_of(state->scene, shading, index);
    struct pp_rgb sum = pp_rgb_grey(0.0);
    struct pp_emitter_sampler sampler;
    if (!pp_emitters_sampler_init(&sampler, state->scene, connection.emitter,
                                  connection.from, connection.n))
        return sum;
    uint32_t count =
        pp_path_vertex_direction_count(state, shading, connection.angular_size);
    for (uint32_t i = 0; i < count; i++) {
        double u[2];
        struct pp_direction_sample sample;
        pp_sobol_sequence_draw(&state->sequence, state->index * count + i, vertex, 2,
                               u);
        if (pp_emitters_sample(&sampler, u[0], u[1], &sample))
            sum = pp_rgb_add(sum, light_from(state, shading, &connection, &sample));
    }
    return pp_rgb_scale(sum, 1.0 / count);
}

/* The connections from `first` on. */
struct connections {
    const struct pp_light_scene *scene;
    const struct pp_shading_point *shading;
    int first;
};

/* What may come by that connection. Never 0 where there may be light: glass mirrors
 * more at other angles than at normal incidence. */
static double importance_of(const void *of, int index)
{
    const struct connections *connections = of;
    const struct pp_light_scene *scene = connections->scene;
    struct connection connection =
        connection_of(scene, connections->shading, connections->first + index);
    double reflected =
        connection.mirror_path < 0
            ? 1.0
            : fmax(scene->mirror_paths[connection.mirror_path].share, 0.02);
    return reflected
           * pp_emitters_importance(connection.emitter, scene, connection.from,
                                    connection.n);
}

/* The connections from `first` to `end`: all of them at the first surface if they are
 * no more than `most`, else one at random. */
static struct pp_rgb sample_connections(struct pp_radiance_state *state,
                                        const struct pp_shading_point *shading,
                                        int first, int end, int most, int vertex)
{
    struct pp_rgb sum = pp_rgb_grey(0.0);
    if (end - first <= 1 || (shading->split && end - first <= most)) {
        for (int i = first; i < end; i++) {
            int own = i == first ? vertex : pp_path_vertex_branch(vertex, i - first);
            sum = pp_rgb_add(sum, sample_connection(state, shading, i, own));
        }
        return sum;
    }
    double u, probability;
    pp_sobol_sequence_draw(&state->sequence, state->index,
                           pp_path_vertex_branch(vertex, 0), 1, &u);
    struct connections connections = {state->scene, shading, first};
    int chosen = pp_choose(importance_of, &connections, end - first, u, &probability);
    if (chosen < 0)
        return sum;
    return pp_rgb_scale(sample_connection(state, shading, first + chosen, vertex),
                        1.0 / probability);
}

struct pp_rgb pp_light_sources_next_event(struct pp_radiance_state *state,
                                          const struct pp_shading_point *shading)
{
    int count = state->scene->emitter_count;
    if (!state->options.sources || count == 0)
        return pp_rgb_grey(0.0);
    int vertex = shading->vertex * PP_DRAWS + PP_DRAW_SOURCES;
    struct pp_rgb straight =
        sample_connections(state, shading, 0, count, MOST_EMITTERS, vertex);
    struct pp_rgb mirrored = sample_connections(
        state, shading, count, count * (1 + state->scene->mirror_path_count),
        MOST_MIRRORED, pp_path_vertex_branch(vertex, -1));
    return pp_rgb_add(straight, mirrored);
}
