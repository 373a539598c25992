/* path.c - see path.h. */
#include "simulate/tracer/path.h"

#include <math.h>
#include <stddef.h>

#include "model/results/reading.h"
#include "simulate/sampling/lobe.h"

enum {
    UNSORTED = -1,       /* nothing met yet: sky will be PP_SC, a surface PP_ERC */
    OUTSIDE_STEP = 1024, /* vertex numbers for what follows outside of each vertex */
    /* A path ends here where nothing ever absorbs: shut in by what reflects all. With
     * 0.99 a path comes so far once in 10^70. */
    MOST_BOUNCES = 1 << 14,
    /* Directions from each surface met, where a guess leaves a small difference of two
     * large numbers. Measured in two rooms: half and twice as many lose 10 to 40 % of
     * the efficiency, one of each two thirds. */
    OPENINGS = 4,
    LOBES = 8
};

/* Paths that have come down to this share of the weight they began with go on by
 * Russian roulette only. */
static const double LEAST_SHARE = 0.3;

/* Share of the paths that go on, for each unit of weight, where a guess stands for
 * what they would bring. Flat between 0.5 and 1. */
static const double GOING_ON = 0.7;

struct pp_contact pp_path_first(struct pp_path_state *state, struct pp_vec3 p,
                                struct pp_vec3 n, struct pp_vec3 u)
{
    state->rays++;
    if (state->log && state->log->count < state->log->capacity) {
        long i = state->log->count++;
        state->log->rays[i].point = p;
        state->log->rays[i].normal = n;
        state->log->rays[i].direction = u;
    }
    return pp_ray_scene_first(state->scene, p, n, u);
}

static struct pp_vec3 side_normal(const struct pp_facet *facet, enum pp_facet_side side)
{
    return side == PP_FRONT ? facet->normal : pp_vec_scale(facet->normal, -1.0);
}

static struct pp_vec3 lobe(const struct pp_facet *facet, enum pp_facet_side side,
                           double u, double v)
{
    return pp_lobe_sample_in_frame(facet->a, facet->b, side_normal(facet, side), u, v);
}

/* The end of a path so far, on its way to the next surface. */
struct ray {
    struct pp_vec3 from, normal; /* of the plane that it leaves, on the side it goes */
    struct pp_vec3 to;           /* direction */
    double weight;
    bool inside; /* in the room? */
    int kind;    /* where its light counts: PP_SC .. PP_IRC, or UNSORTED */
};

/* Does a path with this chance go on? If so its weight makes up for those that don't.
 */
static bool goes_on(struct ray *ray, double chance, double u)
{
    if (chance >= 1.0)
        return ray->weight > 0.0;
    if (!(u < chance))
        return false;
    ray->weight /= chance;
    return true;
}

/* ---- openings ---- */

/* What an opening does with light that meets it, by shares of one. */
struct opening_optics {
    double mirror;  /* of the glass */
    double scatter; /* of the frame, and of a diffusing pane */
    double through;
};

static struct opening_optics optics_of(const struct pp_opening *opening,
                                       const struct pp_facet *facet,
                                       enum pp_facet_side side, double cos_incidence)
{
    double frame = (1.0 - opening->frame_factor) * facet->reflectance[side];
    double glass =
        opening->frame_factor * pp_glass_reflectance(&opening->glass, cos_incidence);
    double through = pp_glass_transmittance(&opening->glass, cos_incidence)
                     * opening->frame_factor * opening->maintenance * opening->curtains;
    if (opening->glass.diffusing)
        return (struct opening_optics){0.0, frame + glass, through};
    return (struct opening_optics){glass, frame, through};
}

enum event { MIRROR, SCATTER, THROUGH };

/* One of the three in proportion. Their sum must not be 0. */
static enum event choose(const struct opening_optics *optics, double u)
{
    double left = u * (optics->mirror + optics->scatter + optics->through);
    if (left < optics->mirror)
        return MIRROR;
    if (left < optics->mirror + optics->scatter || !(optics->through > 0.0))
        return optics->scatter > 0.0 ? SCATTER : MIRROR;
    return THROUGH;
}

/* The ray that leaves an opening where another came, by event; false where nothing
 * does. Light goes through only where that is counted. u: direction (2), event. */
static bool pass_opening(const struct pp_ray_scene *scene, struct ray *ray,
                         const struct pp_contact *met, bool count_through,
                         const double u[3], enum event *event)
{
    const struct pp_facet *facet = &scene->facets[met->facet];
    const struct pp_opening *opening = scene->panes[facet->opening].opening;
    double cosine = pp_vec_dot(facet->normal, ray->to);
    struct opening_optics optics = optics_of(opening, facet, met->side, fabs(cosine));
    if (!count_through)
        optics.through = 0.0;
    double sum = optics.mirror + optics.scatter + optics.through;
    if (!(sum > 0.0))
        return false;

    *event = choose(&optics, u[2]);
    enum pp_facet_side leaves = met->side;
    if (*event == THROUGH) {
        leaves = met->side == PP_FRONT ? PP_BACK : PP_FRONT;
        ray->inside = !ray->inside;
    }
    if (*event == MIRROR)
        ray->to = pp_vec_along(ray->to, -2.0 * cosine, facet->normal);
    else if (*event == SCATTER || opening->glass.diffusing)
        ray->to = lobe(facet, leaves, u[0], u[1]);
    ray->from = met->point;
    ray->normal = side_normal(facet, leaves);
    ray->weight *= sum;
    return true;
}

/* Has a ray met the wrong side of the room's envelope: has it slipped through a crack? */
static bool is_leak(const struct pp_ray_scene *scene, const struct ray *ray,
                    const struct pp_contact *met)
{
    if (met->facet < 0)
        return ray->inside;
    const struct pp_facet *facet = &scene->facets[met->facet];
    return scene->has_room && (facet->envelope || facet->opening >= 0)
           && (met->side == PP_FRONT) != ray->inside;
}

/* ---- outside ---- */

static void add_sky(const struct pp_ray_scene *scene, const struct ray *ray,
                    struct pp_light *light)
{
    bool is_sky;
    double value = pp_environment_light(&scene->outside, ray->to, &is_sky);
    int kind = ray->kind != UNSORTED ? ray->kind : is_sky ? PP_SC : PP_ERC;
    light->part[kind] += ray->weight * value;
}

/* Adds a skyline that stands before what was met; false if there is none. */
static bool add_near_skyline(const struct pp_ray_scene *scene, const struct ray *ray,
                             const struct pp_contact *met, struct pp_light *light)
{
    double exitance = 0.0;
    double distance =
        pp_environment_near_skyline(&scene->outside, ray->from, ray->to, &exitance);
    if (isinf(distance) || (met->facet >= 0 && met->distance_m < distance))
        return false;
    light->part[ray->kind == UNSORTED ? PP_ERC : ray->kind] += ray->weight * exitance;
    return true;
}

/* A surface's own light, and what goes on from it; whither is for the caller. */
static void leave_surface(const struct pp_facet *facet, struct ray *ray,
                          const struct pp_contact *met, struct pp_light *light)
{
    light->part[ray->kind] += ray->weight * facet->exitance;
    ray->weight *= facet->reflectance[met->side];
    ray->from = met->point;
    ray->normal = side_normal(facet, met->side);
}

/* Follows a ray to its end without sampling openings, in and out of the room. Roulette
 * goes by what is left of the ray's weight, not by the weight itself: far from a window
 * that is small from the start, and a façade opposite would be seen by one path in
 * hundreds, as bright as hundreds. */
static void follow(struct pp_path_state *state, struct ray ray, int vertex,
                   struct pp_light *light)
{
    const struct pp_ray_scene *scene = state->scene;
    double least = LEAST_SHARE * ray.weight;
    for (int last = vertex + MOST_BOUNCES; vertex < last; vertex++) {
        struct pp_contact met = pp_path_first(state, ray.from, ray.normal, ray.to);
        if (!ray.inside && add_near_skyline(scene, &ray, &met, light))
            return;
        if (is_leak(scene, &ray, &met)) {
            state->leaks++;
            return;
        }
        if (met.facet < 0) {
            add_sky(scene, &ray, light);
            return;
        }
        double u[4]; /* direction (2), event, going on */
        pp_sobol_sequence_draw(&state->sequence, state->index, vertex, 4, u);
        const struct pp_facet *facet = &scene->facets[met.facet];
        int seen = ray.inside ? PP_IRC : PP_ERC;
        enum event event = SCATTER;
        if (facet->opening >= 0) {
            if (!pass_opening(scene, &ray, &met, true, u, &event))
                return;
        }
        if (event != THROUGH && ray.kind == UNSORTED)
            ray.kind = seen;
        if (facet->opening < 0) {
            leave_surface(facet, &ray, &met, light);
            ray.to = lobe(facet, met.side, u[0], u[1]);
        }
        if (!goes_on(&ray, ray.weight / least, u[3]))
            return;
    }
}

/* ---- openings, sampled directly ---- */

/* The ray that leaves by the opening where the aim goes; false where nothing comes in
 * that way, or a surface stands before it. */
static bool leave_by(struct pp_path_state *state, const struct pp_pane *pane,
                     const struct pp_direction_sample *aimed, struct pp_vec3 n,
                     int vertex, struct ray *ray)
{
    const struct pp_ray_scene *scene = state->scene;
    double facing = pp_vec_dot(n, aimed->direction);
    if (!(facing > 0.0))
        return false;
    if (!pane->seen_by_all || state->every_ray) {
        struct pp_contact met = pp_path_first(state, ray->from, n, aimed->direction);
        if (met.facet != pane->facet && !pane->seen_by_all)
            return false;
    }
    const struct pp_facet *facet = &scene->facets[pane->facet];
    double cosine = -pp_vec_dot(facet->normal, aimed->direction);
    struct opening_optics optics = optics_of(pane->opening, facet, PP_FRONT, cosine);
    ray->weight *= facing * aimed->per_density / PP_PI * optics.through;
    ray->from = aimed->point;
    ray->normal = side_normal(facet, PP_BACK);
    ray->to = aimed->direction;
    if (pane->opening->glass.diffusing) {
        double u[2];
        pp_sobol_sequence_draw(&state->sequence, state->index, vertex, 2, u);
        ray->to = lobe(facet, PP_BACK, u[0], u[1]);
    }
    return ray->weight > 0.0;
}

static bool is_aimed(const struct pp_polygon_sampler *aim,
                     const struct pp_target *target, struct pp_vec3 p, struct pp_vec3 n)
{
    return aim->target == target && aim->from.x == p.x && aim->from.y == p.y
           && aim->from.z == p.z && aim->facing.x == n.x && aim->facing.y == n.y
           && aim->facing.z == n.z;
}

void pp_path_openings(struct pp_path_state *state, struct pp_vec3 p, struct pp_vec3 n,
                      const double u[3], int vertex, double weight, int kind,
                      struct pp_light *light)
{
    const struct pp_ray_scene *scene = state->scene;
    double probability;
    int chosen = pp_ray_scene_choose_pane(scene, p, n, u[2], &probability);
    if (chosen < 0)
        return;
    const struct pp_pane *pane = &scene->panes[chosen];
    if (!is_aimed(&state->aim, &pane->target, p, n))
        pp_sample_polygon_init(&state->aim, &pane->target, p, n, scene->brightness);
    struct pp_direction_sample aimed = pp_sample_polygon_draw(&state->aim, u[0], u[1]);

    int outside_vertex = OUTSIDE_STEP * (vertex + 1);
    struct ray ray = {
        .from = p, .weight = weight / probability, .inside = false, .kind = kind};
    if (!leave_by(state, pane, &aimed, n, outside_vertex, &ray))
        return;
    if (!pane->unobstructed) {
        follow(state, ray, outside_vertex + 1, light);
        return;
    }
    struct pp_contact nothing = {.facet = -1};
    if (state->every_ray)
        pp_path_first(state, ray.from, ray.normal, ray.to);
    if (!add_near_skyline(scene, &ray, &nothing, light))
        add_sky(scene, &ray, light);
}

/* ---- from the point ---- */

/* The point, and the numbers that the path begins with: direction (2) and choice. */
static struct pp_vec3 begin(const struct pp_path_state *state,
                            const struct pp_start *start, double u[3])
{
    double draw[5];
    pp_sobol_sequence_draw(&state->sequence, state->index, 0, start->anywhere ? 5 : 3,
                           draw);
    u[0] = draw[0];
    u[1] = draw[1];
    u[2] = draw[2];
    if (!start->anywhere)
        return start->position;
    u[2] = draw[4];
    return pp_ray_scene_plane_point(state->scene, draw[2], draw[3]);
}

static struct ray lobe_ray(struct pp_vec3 p, struct pp_vec3 n, const double u[2],
                           bool inside)
{
    struct pp_vec3 a, b;
    pp_lobe_frame(n, &a, &b);
    return (struct ray){.from = p,
                        .normal = n,
                        .to = pp_lobe_sample_in_frame(a, b, n, u[0], u[1]),
                        .weight = 1.0,
                        .inside = inside,
                        .kind = inside ? PP_IRC : UNSORTED};
}

void pp_path_direct(struct pp_path_state *state, const struct pp_start *start,
                    struct pp_light *light)
{
    double u[3];
    struct pp_vec3 p = begin(state, start, u);
    if (state->scene->has_room)
        pp_path_openings(state, p, start->normal, u, 0, 1.0, UNSORTED, light);
    else
        follow(state, lobe_ray(p, start->normal, u, false), 1, light);
}

double pp_path_gather(struct pp_path_state *state, const struct pp_start *start)
{
    double u[3];
    struct pp_vec3 p = begin(state, start, u);
    if (!state->guess)
        return 0.0;
    struct ray ray = lobe_ray(p, start->normal, u, true);
    struct pp_contact met = pp_path_first(state, ray.from, ray.normal, ray.to);
    return pp_radiosity_at(state->guess, state->scene, &met);
}

/* Follows a ray in the room until it meets a surface, past glass and frames; false if
 * it ends before. What comes in on the way is added. */
static bool to_surface(struct pp_path_state *state, struct ray *ray, int vertex,
                       struct pp_contact *met, bool *at_once, struct pp_light *light)
{
    const struct pp_ray_scene *scene = state->scene;
    double least = LEAST_SHARE * ray->weight;
    bool count_through = false;
    *at_once = true;
    for (;; vertex++) {
        *met = pp_path_first(state, ray->from, ray->normal, ray->to);
        if (is_leak(scene, ray, met)) {
            state->leaks++;
            return false;
        }
        if (scene->facets[met->facet].opening < 0)
            return true;
        *at_once = false;
        double u[6]; /* direction (2), event, position in an opening (2), choice */
        enum event event;
        pp_sobol_sequence_draw(&state->sequence, state->index, vertex, 6, u);
        if (!pass_opening(scene, ray, met, count_through, u, &event))
            return false;
        if (event == THROUGH) {
            follow(state, *ray, vertex + OUTSIDE_STEP / 2, light);
            return false;
        }
        if (event == SCATTER)
            pp_path_openings(state, ray->from, ray->normal, &u[3], vertex, ray->weight,
                             PP_IRC, light);
        count_through = event == MIRROR;
        double roulette;
        pp_sobol_sequence_draw(&state->sequence, state->index,
                               vertex + OUTSIDE_STEP / 4, 1, &roulette);
        if (!goes_on(ray, ray->weight / least, roulette))
            return false;
    }
}

static double guess_at(const struct pp_path_state *state, const struct pp_contact *met)
{
    return state->guess ? pp_radiosity_at(state->guess, state->scene, met) : 0.0;
}

/* E + K G of a surface, over several directions; one of these goes on as *ray with its
 * whole weight, to *met; false if it ends before. */
static bool bounce(struct pp_path_state *state, struct ray *ray, int vertex,
                   uint32_t openings, uint32_t lobes, struct pp_contact *met,
                   struct pp_light *light)
{
    const struct pp_facet *facet = &state->scene->facets[met->facet];
    struct ray from = *ray;
    enum pp_facet_side side = met->side;
    uint32_t path = state->index;
    for (uint32_t i = 0; i < openings; i++) {
        double u[3];
        state->index = path * openings + i;
        pp_sobol_sequence_draw(&state->sequence, state->index, vertex, 3, u);
        pp_path_openings(state, from.from, from.normal, u, vertex,
                         from.weight / openings, PP_IRC, light);
    }
    bool reached = false;
    for (uint32_t i = 0; i < lobes; i++) {
        double u[2];
        state->index = path * lobes + i;
        pp_sobol_sequence_draw(&state->sequence, state->index, vertex + 1, 2, u);
        struct ray arm = from;
        struct pp_contact end;
        bool at_once;
        arm.weight /= lobes;
        arm.to = lobe(facet, side, u[0], u[1]);
        if (!to_surface(state, &arm, OUTSIDE_STEP * (vertex + 2), &end, &at_once,
                        light))
            continue;
        light->part[PP_IRC] += arm.weight * guess_at(state, &end);
        if (i == 0) {
            reached = true;
            *met = end;
            *ray = arm;
            ray->weight *= lobes;
        }
    }
    state->index = path;
    return reached;
}

/* Follows a path in the room from the start to its end. */
static void correct(struct pp_path_state *state, const struct pp_start *start,
                    struct pp_light *light)
{
    double u[3];
    struct pp_vec3 p = begin(state, start, u);
    struct ray ray = lobe_ray(p, start->normal, u, true);
    struct pp_contact met;
    bool at_once;
    if (!to_surface(state, &ray, OUTSIDE_STEP, &met, &at_once, light))
        return;
    if (!at_once) /* else the gathering has it */
        light->part[PP_IRC] += ray.weight * guess_at(state, &met);
    for (int vertex = 1; vertex < 3 * MOST_BOUNCES; vertex += 3) {
        double chance = 1.0, roulette = 0.0;
        if (vertex > 1) {
            pp_sobol_sequence_draw(&state->sequence, state->index, vertex + 2, 1,
                                   &roulette);
            chance = state->guess ? GOING_ON * ray.weight : ray.weight / LEAST_SHARE;
        }
        if (!goes_on(&ray, chance, roulette))
            return;
        const struct pp_facet *facet = &state->scene->facets[met.facet];
        light->part[PP_IRC] -= ray.weight * guess_at(state, &met);
        leave_surface(facet, &ray, &met, light);
        if (!(ray.weight > 0.0))
            return;
        bool many = state->guess != NULL;
        if (!bounce(state, &ray, vertex, many ? OPENINGS : 1, many ? LOBES : 1, &met,
                    light))
            return;
    }
}

double pp_path_correction(struct pp_path_state *state, const struct pp_start *start)
{
    struct pp_light light = {{0.0, 0.0, 0.0}};
    if (state->scene->has_room)
        correct(state, start, &light);
    return light.part[PP_IRC];
}
