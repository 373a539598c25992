/* light_sources.c - direct light of concentrated emitters: connections, straight and by
 * mirrors, and the choice among connections. */
#include "simulate/transport/light_sources.h"

#include <math.h>

#include "simulate/sampling/sample_discrete.h"

enum {
    /* Up to this number, all emitters are sampled at the first surface. If there are
     * more, only one is sampled. */
    MOST_EMITTERS = 64,
    /* The same limit for connections by mirrors. */
    MOST_MIRRORED = 8,
};

/* Connection of an emitter with the shading point: straight (mirror_path -1), or by
 * mirrors. */
struct connection {
    const struct pp_emitter *emitter; /* not owned */
    int mirror_path;
    struct pp_vec3 from, n; /* the shading point and its normal, or their images in the
                             * mirrors */
    double angular_size;
};

/* Connection number `index`. Direct connections come first, in the order of the
 * emitters, then the connections by each mirror path in turn. */
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

/* Connections that are sampled together: the direct ones, or those by mirrors. */
struct connection_group {
    int first, end, most;
};

static struct connection_group group_of(const struct pp_light_scene *scene,
                                        bool straight)
{
    int count = scene->emitter_count;
    if (straight)
        return (struct connection_group){0, count, MOST_EMITTERS};
    return (struct connection_group){count, count * (1 + scene->mirror_path_count),
                                     MOST_MIRRORED};
}

/* True if all connections are sampled, which is so at the first surface unless there
 * are too many. Otherwise one connection is chosen at random. */
static bool samples_all(struct connection_group group, bool split)
{
    int count = group.end - group.first;
    return count <= 1 || (split && count <= group.most);
}

/* Number of directions to an emitter by a connection; if one connection is chosen at
 * random, the mean number. */
static double samples_of(const struct pp_radiance_state *state, bool split,
                         const struct connection *connection)
{
    struct connection_group group = group_of(state->scene, connection->mirror_path < 0);
    if (!samples_all(group, split))
        return 1.0 / (group.end - group.first);
    return pp_path_vertex_direction_count(state, split, connection->angular_size);
}

double pp_light_sources_weight(const struct pp_radiance_state *state,
                               const struct pp_light_path *path, int emitter)
{
    const struct pp_light_scene *scene = state->scene;
    if (!state->options.sources || path->sampled == PP_DIRECTLY_SAMPLED_NONE)
        return 1.0;
    if (path->sampled == PP_DIRECTLY_SAMPLED_ALL)
        return 0.0;
    const struct pp_shading_point shading = {.point = path->gloss_point,
                                             .normal = path->gloss_normal};
    struct connection connection = connection_of(
        scene, &shading, emitter + (path->mirror_path + 1) * scene->emitter_count);
    struct pp_emitter_sampler sampler;
    if (!pp_emitters_sampler_init(&sampler, scene, connection.emitter, connection.from,
                                  connection.n))
        return 1.0;
    double share = path->mirror_path < 0
                       ? pp_path_vertex_arrival_weight(scene, &path->arrival, emitter)
                       : 1.0;
    return share
           * pp_path_vertex_mis(path->gloss_pdf,
                                samples_of(state, path->gloss_split, &connection)
                                    * pp_emitters_pdf(&sampler, path->ray.to));
}

/* Light from one direction to an emitter: BRDF, cosine and visibility times radiance,
 * divided by the direction's density. */
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
    double share = 1.0;
    if (shading->arrival && connection->mirror_path < 0)
        share = pp_path_vertex_arrival_weight(scene, shading->arrival,
                                              (int)(emitter - scene->emitters));
    struct pp_rgb f = pp_path_vertex_brdf(
        shading, to,
        samples_of(state, shading->split, connection) / sample->per_density, share);
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
        pp_path_vertex_direction_count(state, shading->split, connection.angular_size);
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

/* A list of connections that begins at `first`. */
struct connections {
    const struct pp_light_scene *scene;
    const struct pp_shading_point *shading;
    int first;
};

/* Importance of a connection, never 0 if the connection may carry light: glass reflects
 * more at oblique than at normal incidence. */
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

/* Samples the direct connections (`straight` true), or those by mirrors. */
static struct pp_rgb sample_connections(struct pp_radiance_state *state,
                                        const struct pp_shading_point *shading,
                                        bool straight, int vertex)
{
    struct pp_rgb sum = pp_rgb_grey(0.0);
    struct connection_group group = group_of(state->scene, straight);
    if (samples_all(group, shading->split)) {
        for (int i = group.first; i < group.end; i++) {
            int own = i == group.first ? vertex
                                       : pp_path_vertex_branch(vertex, i - group.first);
            sum = pp_rgb_add(sum, sample_connection(state, shading, i, own));
        }
        return sum;
    }
    double u, probability;
    pp_sobol_sequence_draw(&state->sequence, state->index,
                           pp_path_vertex_branch(vertex, 0), 1, &u);
    struct connections connections = {state->scene, shading, group.first};
    int chosen = pp_sample_discrete_of(importance_of, &connections,
                                       group.end - group.first, 0.0, u, &probability);
    if (chosen < 0)
        return sum;
    return pp_rgb_scale(sample_connection(state, shading, group.first + chosen, vertex),
                        1.0 / probability);
}

/* Light of one emitter by way of one reflector (reflectors.h), at a diffuse side of a
 * surface. */
static struct pp_rgb sample_reflection(struct pp_radiance_state *state,
                                       const struct pp_shading_point *shading)
{
    const struct pp_light_scene *scene = state->scene;
    struct pp_rgb none = pp_rgb_grey(0.0);
    int most = state->options.bounces;
    if (scene->reflection_count == 0 || pp_rgb_is_black(shading->diffuse)
        || (most >= 0 && shading->depth >= most))
        return none;
    double u[3];
    int vertex =
        pp_path_vertex_branch(shading->vertex * PP_DRAWS + PP_DRAW_SOURCES, -2);
    pp_sobol_sequence_draw(&state->sequence, state->index, vertex, 3, u);
    int index = pp_reflectors_choose(scene, u[2]);
    const struct pp_reflection *reflection = &scene->reflections[index];
    struct pp_light_ray ray = pp_path_vertex_shadow_ray(shading, shading->normal);
    struct pp_light_hit hit;
    if (!pp_reflectors_sample(scene, index, shading->point, u[0], u[1], &ray.to))
        return none;
    double cosine = pp_vec_dot(shading->normal, ray.to);
    if (!(cosine > 0.0) || pp_radiance_state_meet(state, &ray, &hit) != PP_MEETS_PART
        || scene->parts[hit.part].reflector[hit.back] != reflection->reflector)
        return none;
    struct pp_lobes lobes;
    pp_light_scene_parts_lobes(scene, &hit, ray.to, &lobes);
    const struct pp_shading_point there = {.point =
                                               pp_rays_draw_back(hit.point, ray.to),
                                           .normal = hit.normal,
                                           .space = hit.space,
                                           .diffuse = none,
                                           .lobes = &lobes,
                                           .vertex = vertex,
                                           .whole_gloss = true};
    struct pp_rgb light = sample_connection(state, &there, reflection->emitter,
                                            pp_path_vertex_branch(vertex, 0));
    double pdf = pp_reflectors_pdf(scene, index, shading->point, ray.to);
    double weight = pp_path_vertex_mis(pdf, cosine / PP_PI);
    return pp_rgb_scale(pp_rgb_times(light, shading->diffuse),
                        weight * cosine / (PP_PI * pdf));
}

struct pp_rgb pp_light_sources_next_event(struct pp_radiance_state *state,
                                          const struct pp_shading_point *shading)
{
    if (!state->options.sources || state->scene->emitter_count == 0)
        return pp_rgb_grey(0.0);
    int vertex = shading->vertex * PP_DRAWS + PP_DRAW_SOURCES;
    struct pp_rgb sum = sample_connections(state, shading, true, vertex);
    sum = pp_rgb_add(sum, sample_connections(state, shading, false,
                                             pp_path_vertex_branch(vertex, -1)));
    return pp_rgb_add(sum, sample_reflection(state, shading));
}
