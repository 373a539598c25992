/* path.c - the first two estimators of path.h: direct light, and gathering of the
 * control variate. */
#include "simulate/fast/path_parts.h"

#include <stddef.h>

#include "model/results/reading.h"
#include "simulate/sampling/lobe.h"
#include "simulate/sampling/lobe_run.h"
#include "simulate/scene/convex_room.h"
#include "simulate/scene/light_scene_of_world.h"

/* The light of niches according to the control variate. NULL if the room is not convex
 * or has no niches, or if there is no control variate. */
static const struct pp_niche_light *niches_of(const struct pp_control_variate *variate)
{
    return variate && variate->scene->convex && variate->scene->has_niches
               ? &variate->niches
               : NULL;
}

struct pp_path_state pp_path_state(const struct pp_light_scene *scene,
                                   const struct pp_environment *environment,
                                   const struct pp_control_variate *variate)
{
    return (struct pp_path_state){.light = {.scene = scene,
                                            .environment = environment,
                                            .options = pp_radiance_state_defaults()},
                                  .variate = variate,
                                  .niches = niches_of(variate),
                                  .glass = scene->glass_image_count > 0};
}

struct pp_vec3 pp_path_begin(const struct pp_path_state *state,
                             const struct pp_start *start, int vertex, double u[2])
{
    double draw[5]; /* direction (2), choice of an opening, place on the plane (2) */
    pp_sobol_sequence_draw(&state->light.sequence, state->light.index, vertex,
                           start->anywhere ? 5 : 2, draw);
    u[0] = draw[0];
    u[1] = draw[1];
    return start->anywhere ? pp_light_scene_of_world_plane_point(state->light.scene,
                                                                 draw[3], draw[4])
                           : start->position;
}

/* A ray in a direction from the start of a path. */
static struct pp_light_ray start_ray(const struct pp_path_state *state,
                                     const struct pp_start *start, struct pp_vec3 from,
                                     struct pp_vec3 to)
{
    return (struct pp_light_ray){from, start->normal, to,
                                 state->light.scene->has_room ? PP_INDOORS
                                                              : PP_ANYWHERE};
}

/* A ray drawn from the point's cosine lobe. */
static struct pp_light_ray lobe_ray(const struct pp_path_state *state,
                                    const struct pp_start *start)
{
    double u[2];
    struct pp_vec3 a, b, from = pp_path_begin(state, start, 0, u);
    pp_lobe_frame(start->normal, &a, &b);
    return start_ray(state, start, from,
                     pp_lobe_sample_in_frame(a, b, start->normal, u[0], u[1]));
}

/* The light of niches that next-event estimation at this point counts; NULL if none. */
static const struct pp_niche_light *niches_from(const struct pp_path_state *state,
                                                struct pp_vec3 point)
{
    const struct pp_light_scene *scene = state->light.scene;
    return state->niches && pp_convex_room_encloses(scene->convex, point)
               ? state->niches
               : NULL;
}

bool pp_path_counted_by_nee(const struct pp_path_state *state, struct pp_vec3 from,
                            const struct pp_light_hit *met)
{
    return state->niches && state->light.scene->parts[met->part].niche >= 0
           && niches_from(state, from);
}

static struct pp_shading_point shading_point(const struct pp_path_state *state,
                                             struct pp_vec3 point,
                                             struct pp_vec3 normal, int vertex,
                                             uint32_t directions)
{
    return (struct pp_shading_point){.point = point,
                                     .normal = normal,
                                     .space = PP_INDOORS,
                                     .diffuse = pp_rgb_grey(PP_PI),
                                     .vertex = vertex,
                                     .directions = directions,
                                     .niches = niches_from(state, point)};
}

struct pp_irradiance pp_path_by_openings(struct pp_path_state *state,
                                         struct pp_vec3 point, struct pp_vec3 normal,
                                         int vertex, uint32_t directions)
{
    struct pp_irradiance e = {.rest = pp_rgb_grey(0.0)};
    struct pp_shading_point shading =
        shading_point(state, point, normal, vertex, directions);
    pp_light_path_windows(&state->light, &shading, &e);
    return e;
}

/* Adds light through the openings for one path, or for a run of paths from the present
 * index. For a run, the existing sum is divided by the number of paths, a power of two,
 * before the addition and multiplied by it afterwards. The result is therefore
 * bit-identical to adding the paths one by one. */
static void add_direct(struct pp_path_state *state, const struct pp_start *start,
                       struct pp_vec3 point, int paths, struct pp_light *light)
{
    struct pp_shading_point shading =
        shading_point(state, point, start->normal, 0, (uint32_t)paths);
    uint32_t first = state->light.index;
    double *part = light->part;
    struct pp_irradiance e = {.sky = pp_rgb_grey(part[PP_SC] / paths),
                              .outside = pp_rgb_grey(part[PP_ERC] / paths),
                              .rest = pp_rgb_grey(part[PP_IRC] / paths)};
    state->light.index = first / (uint32_t)paths;
    pp_light_path_windows(&state->light, &shading, &e);
    part[PP_SC] = e.sky.g * paths;
    part[PP_ERC] = e.outside.g * paths;
    part[PP_IRC] = e.rest.g * paths;
    state->light.index = first;
}

/* Adds the light of openings that are seen mirrored in the glass of other openings. */
static void add_glass(struct pp_path_state *state, const struct pp_start *start,
                      struct pp_vec3 point, struct pp_light *light)
{
    struct pp_shading_point shading = shading_point(state, point, start->normal, 0, 1);
    struct pp_irradiance e = {.rest = pp_rgb_grey(0.0)};
    pp_light_path_glass(&state->light, &shading, &state->view, &e);
    light->part[PP_IRC] += e.rest.g;
}

/* Adds the direct light of one ray in a scene without a room: from the sky, or from the
 * ground and other surfaces. */
static void add_open_direct(struct pp_path_state *state, const struct pp_start *start,
                            struct pp_light *light)
{
    struct pp_light_ray ray = lobe_ray(state, start);
    struct pp_light_path path = pp_path_of_ray(state, &ray, 1);
    double value = PP_PI * pp_light_path_follow(&state->light, &path, NULL).g;
    light->part[path.first_met == PP_MET_SKY ? PP_SC : PP_ERC] += value;
}

void pp_path_direct(struct pp_path_state *state, const struct pp_start *start,
                    uint32_t end, struct pp_light *light)
{
    const struct pp_light_scene *scene = state->light.scene;
    for (; !scene->has_room && state->light.index < end; state->light.index++)
        add_open_direct(state, start, light);
    while (state->light.index < end) {
        /* Runs of several paths are possible only if pp_light_path_windows samples no
         * images of openings. */
        bool runs = !start->anywhere && scene->window_image_count == 0;
        int paths = runs ? pp_path_run_from(state->light.index, end, PP_RUN_MOST) : 1;
        double u[2];
        struct pp_vec3 point = start->anywhere
                                   ? pp_path_begin(state, start, PP_DRAW_WINDOWS, u)
                                   : start->position;
        add_direct(state, start, point, paths, light);
        for (int i = 0; i < paths; i++, state->light.index++)
            if (state->glass)
                add_glass(state, start, point, light);
    }
}

/* G at the end of the ray if the ray meets a surface directly; otherwise 0. With
 * `cells`, only the part of G that the cells do not cover. */
static double gathered(struct pp_path_state *state, const struct pp_light_ray *ray,
                       const struct pp_convex_nearest *nearest, bool cells)
{
    struct pp_light_hit met;
    if (pp_radiance_state_meet_by(&state->light, ray, nearest, &met) != PP_MEETS_PART
        || pp_path_counted_by_nee(state, ray->from, &met))
        return 0.0;
    double guess = pp_path_guess(state, &met);
    return cells ? pp_gather_cells_left(state->cells, ray, &met, guess) : guess;
}

/* Gathers over a run of path indices that begins at state->light.index. */
static void gather_run(struct pp_path_state *state, const struct pp_start *start,
                       const struct pp_frame *frame, int count, double *sum)
{
    double u[2][PP_RUN_MOST];
    struct pp_lanes_directions to;
    struct pp_convex_nearest nearest[PP_RUN_MOST];
    pp_sobol_sequence_draw_run(&state->light.sequence, state->light.index, count, 0, 2,
                               u);
    pp_lobe_run(frame, u, count, &to);
    bool known = pp_light_scene_nearest(state->light.scene, start->position, &to, count,
                                        nearest);
    for (int i = 0; i < count; i++, state->light.index++) {
        struct pp_light_ray ray =
            start_ray(state, start, start->position, pp_vec(to.x[i], to.y[i], to.z[i]));
        *sum += gathered(state, &ray, known ? &nearest[i] : NULL, state->cells != NULL);
    }
}

void pp_path_gather(struct pp_path_state *state, const struct pp_start *start,
                    uint32_t end, double *sum)
{
    struct pp_frame frame = {.z = start->normal};
    pp_lobe_frame(start->normal, &frame.x, &frame.y);
    while (state->variate && state->light.index < end) {
        int count = pp_path_run_from(state->light.index, end, PP_RUN_MOST);
        if (!start->anywhere && count > 1) {
            gather_run(state, start, &frame, count, sum);
            continue;
        }
        struct pp_light_ray ray = lobe_ray(state, start);
        *sum += gathered(state, &ray, NULL, state->cells && !start->anywhere);
        state->light.index++;
    }
    state->light.index = end;
}

double pp_path_gather_cells(const struct pp_path_state *state,
                            const struct pp_start *start)
{
    if (!state->cells || start->anywhere)
        return 0.0;
    return pp_gather_cells_taken(state->cells, state->net, start->position,
                                 start->normal);
}

double pp_path_shared(const struct pp_path_state *state, const struct pp_start *start,
                      const struct pp_shared_light *shared)
{
    double u[2];
    struct pp_vec3 point =
        start->anywhere ? pp_path_begin(state, start, 0, u) : start->position;
    return pp_shared_density_taken(shared, point, start->normal);
}
