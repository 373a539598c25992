/* path_correction.c - the third estimator of path.h: paths from surface to surface,
 * which correct the control variate. */
#include <stddef.h>

#include "simulate/sampling/lobe.h"
#include "simulate/sampling/lobe_run.h"
#include "simulate/fast/path_parts.h"

enum {
    /* Directions from each surface met. Several are needed, because with the control
     * variate a step is a small difference of large numbers. Chosen by trial. */
    OPENINGS = 4,
    LOBES = 8,
    FIRST_LOBES = 4,    /* from the point itself, if no light is shared */
    MOST_LOBES = LOBES, /* all numbers above must be powers of two, at most
                         * PP_RUN_MOST */
    /* Limit of bounces for an enclosure in which nothing absorbs. With a reflectance of
     * 0.99 one path in 10^70 reaches it. */
    MOST_BOUNCES = 1 << 14
};

/* Russian roulette: a path continues with the probability GOING_ON times the ratio of
 * its importance to its importance at the first surface. Chosen by trial. */
static const double GOING_ON = 0.6;

/* Defensive sampling: when an arm is chosen, this fraction of the mean importance of
 * the fan's arms is added to the importance of each arm. */
static const double LEAST_SHARE = 0.5;

/* An arm: a path on its way to a surface of the room. */
struct path_arm {
    struct pp_light_ray ray;
    double throughput;
    double importance; /* estimated contribution, according to G */
    struct pp_light_hit met;
    bool at_once; /* true if the arm has reached a surface without meeting an opening */
};

/* Arms that start together from one point. */
struct path_fan {
    struct pp_vec3 from;
    struct pp_frame frame; /* z: axis of the cosine lobe */
    uint32_t lobes;        /* number of arms */
    double throughput;     /* total throughput of the arms */
    bool gathers;          /* true if arms that reach a surface at once also gather G */
    bool cells;            /* true if cells gather G as well */
    bool glass; /* true if openings are also sampled by their images in glass */
};

/* The rays of the fans of a run of paths, fan after fan. */
struct fan_rays {
    struct pp_lanes_directions to;
    struct pp_convex_nearest nearest[PP_RUN_MOST];
    bool known; /* true if the nearest planes are known */
};

/* Draws the rays of `paths` paths (at most PP_RUN_MOST) from the present index. All
 * rays start from one place. */
static void draw_rays(const struct pp_path_state *state, const struct path_fan *fan,
                      int vertex, int paths, struct fan_rays *rays)
{
    double u[2][PP_RUN_MOST];
    int count = paths * (int)fan->lobes;
    pp_sobol_sequence_draw_run(&state->light.sequence, state->light.index * fan->lobes,
                               count, vertex * PP_DRAWS, 2, u);
    pp_lobe_run(&fan->frame, u, count, &rays->to);
    rays->known = pp_light_scene_nearest(state->light.scene, fan->from, &rays->to,
                                         count, rays->nearest);
}

/* Excludes the light of opening `met` from a path that was reflected by the glass of
 * another opening, if images in glass already count this light. */
static void leave_out_image(const struct pp_light_scene *scene, int pane,
                            const struct pp_light_hit *met, struct pp_light_path *path)
{
    int window = scene->parts[met->part].window;
    if (window >= 0 && !met->back && path->sampled == PP_DIRECTLY_SAMPLED_NONE
        && pp_glass_images_has(scene, pane, window))
        path->sampled = PP_DIRECTLY_SAMPLED_ALL;
}

/* Follows the ray through glass and frames to a surface of the room; false if the path
 * ends before. Adds the light that enters on the way to *sum. nearest: the plane that
 * the ray meets first; NULL: unknown. glass: excludes openings mirrored in the first
 * glass that the ray meets. */
static bool to_surface(struct pp_path_state *state, struct path_arm *arm,
                       const struct pp_convex_nearest *nearest, bool glass, int vertex,
                       double *sum)
{
    struct pp_radiance_state *light = &state->light;
    const struct pp_light_part *parts = light->scene->parts;
    enum pp_meeting meeting =
        pp_radiance_state_meet_by(light, &arm->ray, nearest, &arm->met);
    arm->at_once = true;
    if (meeting == PP_MEETS_PART && parts[arm->met.part].window < 0)
        return true;
    struct pp_light_path path = pp_path_of_ray(state, &arm->ray, vertex);
    struct pp_rgb found = pp_rgb_grey(0.0);
    bool goes = true, there = false;
    int pane = glass && meeting == PP_MEETS_PART ? parts[arm->met.part].window : -1;
    arm->at_once = false;
    while (goes && !there) {
        goes = pp_light_path_arrive(light, &path, meeting, &arm->met, &found);
        if (goes)
            meeting = pp_radiance_state_meet(light, &path.ray, &arm->met);
        if (goes && pane >= 0 && meeting == PP_MEETS_PART)
            leave_out_image(light->scene, pane, &arm->met, &path);
        pane = -1;
        there = goes && path.ray.space == PP_INDOORS && meeting == PP_MEETS_PART
                && parts[arm->met.part].window < 0;
    }
    *sum += arm->throughput * PP_PI * found.g;
    arm->throughput *= path.throughput.g;
    arm->ray = path.ray;
    return there;
}

/* Chooses, by u in (0, 1), the arm that continues for all arms. The noise of a path at
 * a surface grows with the light at the surface. An arm's probability is therefore
 * proportional to its contribution according to G, so that all choices contribute about
 * equal noise. */
static struct path_arm choose_path_arm(const struct path_arm *arms, int count, double u)
{
    double mean = 0.0, total = 0.0, below = 0.0, share[MOST_LOBES];
    for (int i = 0; i < count; i++)
        mean += arms[i].importance / count;
    for (int i = 0; i < count; i++) {
        share[i] = arms[i].importance + LEAST_SHARE * mean;
        if (!(mean > 0.0))
            share[i] = arms[i].throughput;
        total += share[i];
    }
    int chosen = 0;
    while (chosen + 1 < count && below + share[chosen] <= u * total)
        below += share[chosen++];
    struct path_arm arm = arms[chosen];
    arm.throughput *= total / share[chosen];
    arm.importance = mean * count;
    return arm;
}

/* The part of G at the arm's vertex that the fan's own rays must gather. */
static double gathered(const struct pp_path_state *state, const struct path_fan *fan,
                       const struct path_arm *arm, double guess)
{
    if (!arm->at_once)
        return guess;
    if (!fan->gathers || pp_path_counted_by_nee(state, fan->from, &arm->met))
        return 0.0;
    return fan->cells ? pp_gather_cells_left(state->cells, &arm->ray, &arm->met, guess)
                      : guess;
}

/* Adds K G from the arms of the fan, whose rays begin at index `first`. One arm
 * continues as *arm with the throughput of all. False if none continues. */
static bool spread(struct pp_path_state *state, const struct path_fan *fan,
                   const struct fan_rays *rays, int first, int vertex,
                   struct path_arm *arm, double *sum)
{
    struct pp_radiance_state *light = &state->light;
    struct path_arm arms[MOST_LOBES];
    const struct pp_lanes_directions *to = &rays->to;
    int count = 0, lobes = (int)fan->lobes;
    uint32_t index = light->index;
    for (int i = 0; i < lobes; i++) {
        struct path_arm *next = &arms[count];
        int k = first + i;
        light->index = index * fan->lobes + (uint32_t)i;
        next->ray = (struct pp_light_ray){
            fan->from, fan->frame.z, pp_vec(to->x[k], to->y[k], to->z[k]), PP_INDOORS};
        next->throughput = fan->throughput / fan->lobes;
        if (!to_surface(state, next, rays->known ? &rays->nearest[k] : NULL, fan->glass,
                        pp_path_vertex_branch(vertex, PP_DRAWS), sum)
            || !(next->throughput > 0.0))
            continue;
        double guess = pp_path_guess(state, &next->met);
        next->importance = next->throughput * guess;
        *sum += next->throughput * gathered(state, fan, next, guess);
        count++;
    }
    light->index = index;
    double chosen = 0.0;
    if (count > 1)
        pp_sobol_sequence_draw(&light->sequence, index,
                               vertex * PP_DRAWS + PP_DRAW_PANES, 1, &chosen);
    if (count > 0)
        *arm = choose_path_arm(arms, count, chosen);
    return count > 0;
}

/* Samples E + K G of a surface over several directions. One direction continues as *arm
 * with the whole throughput; false if none continues. */
static bool bounce(struct pp_path_state *state, struct path_arm *arm, int vertex,
                   uint32_t openings, uint32_t lobes, double *sum)
{
    const struct pp_light_part *part = &state->light.scene->parts[arm->met.part];
    struct path_fan fan = {
        .from = pp_rays_draw_back(arm->met.point, arm->ray.to),
        .frame = {part->a, part->b, arm->met.normal},
        .lobes = lobes,
        .throughput = arm->throughput,
        .gathers = true,
        .cells = state->cells && pp_gather_cells_are_on(state->cells, arm->met.part)};
    struct fan_rays rays;
    struct pp_irradiance e =
        pp_path_by_openings(state, fan.from, fan.frame.z, vertex, openings);
    *sum += arm->throughput * pp_irradiance_sum(&e).g;
    if (fan.cells)
        *sum +=
            arm->throughput
            * pp_gather_cells_taken(state->cells, state->net, fan.from, fan.frame.z);
    draw_rays(state, &fan, vertex, 1, &rays);
    return spread(state, &fan, &rays, 0, vertex, arm, sum);
}

/* Russian roulette: true if the path continues. `first`: the arm's importance at its
 * first surface. */
static bool survives(const struct pp_path_state *state, struct path_arm *arm,
                     double first, int vertex)
{
    const struct pp_radiance_state *light = &state->light;
    double u, left = first > 0.0 ? arm->importance / first : arm->throughput;
    double chance =
        state->variate ? GOING_ON * left : arm->throughput / light->options.least;
    if (vertex == 1 || chance >= 1.0)
        return true;
    pp_sobol_sequence_draw(&light->sequence, light->index,
                           vertex * PP_DRAWS + PP_DRAW_SOURCES, 1, &u);
    arm->throughput /= chance;
    arm->importance /= chance;
    return u < chance;
}

/* Adds one step of (2) at the arm's vertex, times the throughput, and directs the arm
 * to its next surface. False if the arm ends before. */
static bool step(struct pp_path_state *state, struct path_arm *arm, int vertex,
                 double *sum)
{
    const struct pp_material *material =
        &state->light.scene->materials[arm->met.material];
    uint32_t lobes = state->variate ? LOBES : 1;
    uint32_t openings = state->variate ? OPENINGS : 1;
    *sum += arm->throughput
            * (PP_PI * material->radiance.g - pp_path_guess(state, &arm->met));
    arm->throughput *= pp_light_scene_parts_diffuse(state->light.scene, &arm->met).g;
    return arm->throughput > 0.0 && bounce(state, arm, vertex, openings, lobes, sum);
}

/* B - G at the arm's vertex, times the arm's throughput. */
static double residual(struct pp_path_state *state, struct path_arm *arm, int vertex)
{
    double sum = 0.0, first = arm->importance;
    while (vertex < MOST_BOUNCES && survives(state, arm, first, vertex)
           && step(state, arm, vertex, &sum))
        vertex++;
    return sum;
}

/* True if the residual at the arm's vertex must be sampled by this ray. If the ray
 * arrived directly, shared points cover part of the residual. The result is then true
 * with the probability of the remainder. */
static bool is_left(const struct pp_path_state *state, const struct path_arm *arm,
                    int vertex)
{
    double u;
    if (!arm->at_once || !state->shared)
        return true;
    double left = pp_shared_density_left(state->shared, &arm->ray, &arm->met);
    if (!(left > 0.0))
        return false;
    pp_sobol_sequence_draw(&state->light.sequence, state->light.index,
                           vertex * PP_DRAWS + PP_DRAW_SOURCES, 1, &u);
    return u < left;
}

double pp_path_residual(struct pp_path_state *state, const struct pp_light_hit *met,
                        const struct pp_shared_light *others, int count)
{
    struct path_arm arm = {.ray.to = pp_vec_scale(met->normal, -1.0),
                           .throughput = 1.0,
                           .importance = pp_path_guess(state, met),
                           .met = *met,
                           .at_once = true};
    if (count == 0)
        return residual(state, &arm, 1);
    double sum = 0.0, shared = 0.0;
    bool reached = step(state, &arm, 1, &sum);
    for (int i = 0; i < count; i++)
        shared += pp_shared_density_taken(&others[i], met->point, met->normal);
    sum += pp_light_scene_parts_diffuse(state->light.scene, met).g * shared / count;
    return reached && is_left(state, &arm, 1) ? sum + residual(state, &arm, 2) : sum;
}

/* Correction by one path, whose rays begin at index `first`. */
static double correction(struct pp_path_state *state, const struct path_fan *fan,
                         const struct fan_rays *rays, int first)
{
    double sum = 0.0;
    struct path_arm arm;
    bool goes_on = spread(state, fan, rays, first, 0, &arm, &sum);
    return goes_on && is_left(state, &arm, 0) ? sum + residual(state, &arm, 1) : sum;
}

void pp_path_correction(struct pp_path_state *state, const struct pp_start *start,
                        uint32_t end, double *sum)
{
    uint32_t lobes = state->variate && !state->shared ? FIRST_LOBES : 1;
    struct path_fan fan = {.frame = {.z = start->normal},
                           .lobes = lobes,
                           .throughput = 1.0,
                           .glass = state->glass};
    pp_lobe_frame(start->normal, &fan.frame.x, &fan.frame.y);
    while (state->light.scene->has_room && state->light.index < end) {
        struct fan_rays rays;
        int paths = 1;
        if (start->anywhere) {
            double u[2];
            fan.from = pp_path_begin(state, start, 0, u);
        } else {
            fan.from = start->position;
            paths = pp_path_run_from(state->light.index, end, PP_RUN_MOST / lobes);
        }
        draw_rays(state, &fan, 0, paths, &rays);
        for (int i = 0; i < paths; i++, state->light.index++)
            *sum += correction(state, &fan, &rays, i * (int)lobes);
    }
    state->light.index = end;
}
