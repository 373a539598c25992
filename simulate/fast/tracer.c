/* tracer.c - connects the estimators of path.h, and the shared light, to the sampler
 * interface of simulate/estimate. */
#include "simulate/fast/tracer.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/estimate/common_variance.h"
#include "simulate/estimate/planner.h"
#include "simulate/sampling/hash.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/scene/unsampled.h"
#include "simulate/fast/control_variate_solve.h"
#include "simulate/fast/path.h"
#include "simulate/fast/shared_light.h"
#include "simulate/transport/light_images.h"

/* Estimators, and offsets of the sums of their paths. Sums of direct light are by
 * component, PP_SC to PP_IRC. */
enum { DIRECT, GATHER, CORRECTION, SHARED, ESTIMATORS };
enum {
    SUM_DIRECT = 0,
    SUM_GATHER = 3,
    SUM_CORRECTION = 4,
    SUM_SHARED = 5,
    SUM_CELLS = 6 /* light gathered by cells, which is not a sum over paths */
};

/* Limits of the number of points that receivers share in one randomisation. At least 64
 * are used, since fewer need more randomisations and, for a large error, more work. */
enum { LEAST_SHARED = 64, MOST_SHARED = 1 << 12 };
static const double SHARED_VARIANCE = 0.0033;

/* Cost of one shared point to a receiver, in rays: a connection, plus a fifteenth of
 * the point's own 15 rays, as if 15 receivers used the point. The true number of
 * receivers is not used, since values must not depend on it. Chosen by trial. */
static const double SHARED_COST = 1.0;

/* If openings are a smaller fraction of the inside surfaces than SPOTTED_SHARE, they
 * light small spots that few paths find. A small pilot would miss the spots and plan
 * too few paths. The paths of the pilot and the least number of paths are therefore
 * doubled until the fraction times the factor reaches SPOTTED_LIKE, or the factor
 * reaches SPOTTED_MOST. Chosen by trial in rooms with slits of 0.05 to 0.1 m. */
static const double SPOTTED_SHARE = 0.015, SPOTTED_LIKE = 0.06;
enum { SPOTTED_MOST = 16 };

/* A receiver, or the working plane as a whole. */
struct traced_point {
    struct pp_start start;
    bool shares; /* receives shared light */
    struct pp_room_bound most;
    uint64_t seed;
};

struct pp_tracer {
    const struct pp_light_scene *scene;
    const struct pp_environment *environment;
    struct pp_control_variate *variate;
    struct pp_shared_density *density; /* NULL: every point samples its whole
                                        * correction */
    struct pp_gather_cells *cells;     /* NULL if there is no density */
    struct pp_shared_lights *shared;   /* NULL if there is no density */
    struct pp_sobol sobol;
    struct traced_point *points; /* the receivers, then the average if requested */
    int point_count, receiver_count;
    bool every_ray, direct; /* as in the options */
    struct pp_sampler sampler;
    struct pp_planner *planner;
};

/* ---- the sampler ---- */

static void begin_tracer_state(const void *client, void *state)
{
    const struct pp_tracer *tracer = client;
    struct pp_path_state *path = state;
    *path = pp_path_state(tracer->scene, tracer->environment, tracer->variate);
    path->light.every_ray = tracer->every_ray;
    path->shared = tracer->density;
    path->cells = tracer->cells;
    path->glass = path->glass && !tracer->direct;
}

static uint64_t traced_point_seed(const void *client, int point)
{
    return ((const struct pp_tracer *)client)->points[point].seed;
}

/* Light of the randomisation's shared points at a receiver. */
static double shared_of(const struct pp_tracer *tracer, struct pp_path_state *path,
                        const struct pp_path_range *range)
{
    const struct pp_shared_light *list =
        pp_shared_light_list(tracer->shared, range->randomisation);
    const struct pp_start *start = &tracer->points[range->point].start;
    double sum = 0.0;
    if (!tracer->points[range->point].shares)
        return sum;
    for (path->light.index = range->first; path->light.index < range->end;
         path->light.index++)
        sum += pp_path_shared(path, start, &list[path->light.index]);
    return sum;
}

static enum pp_status share_light(const void *client, int stage, int first, int count,
                                  const struct pp_counts *wanted,
                                  struct pp_thread_pool *pool, struct pp_error *err)
{
    const struct pp_tracer *tracer = client;
    uint32_t *each = malloc((size_t)count * sizeof *each);
    if (!each)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        each[i] = wanted[i].of[SHARED];
    enum pp_status status =
        pp_shared_light_extend(tracer->shared, stage, first, count, each, pool, err);
    free(each);
    return status;
}

static void follow_traced_paths(const void *client, void *state,
                                const struct pp_path_range *range,
                                struct pp_randomisation *randomisation)
{
    const struct pp_tracer *tracer = client;
    const struct pp_start *start = &tracer->points[range->point].start;
    struct pp_path_state *path = state;
    double *sums = randomisation->sums;
    long rays = path->light.rays, leaks = path->light.leaks;
    path->light.sequence = range->sequence;
    bool shares = tracer->points[range->point].shares;
    path->shared = shares ? tracer->density : NULL;
    path->cells = shares ? tracer->cells : NULL;
    path->net =
        shares ? pp_shared_light_net(tracer->shared, range->randomisation) : NULL;
    if (range->estimator == SHARED) {
        sums[SUM_SHARED] += shared_of(tracer, path, range);
        return;
    }
    struct pp_light direct = {{sums[PP_SC], sums[PP_ERC], sums[PP_IRC]}};
    path->light.index = range->first;
    if (range->estimator == GATHER) {
        if (range->first == 0)
            sums[SUM_CELLS] = pp_path_gather_cells(path, start);
        pp_path_gather(path, start, range->end, &sums[SUM_GATHER]);
    } else if (range->estimator == CORRECTION) {
        pp_path_correction(path, start, range->end, &sums[SUM_CORRECTION]);
    } else {
        pp_path_direct(path, start, range->end, &direct);
    }
    for (int i = PP_SC; i <= PP_IRC; i++)
        sums[SUM_DIRECT + i] = direct.part[i];
    randomisation->rays[range->estimator] += path->light.rays - rays;
    randomisation->leaks += path->light.leaks - leaks;
}

/* The estimator's contribution to the daylight factor. Internally reflected light
 * includes the allowance for decorations. */
static double tracer_part(const void *client, int point,
                          const struct pp_randomisation *randomisation, int estimator)
{
    (void)point;
    double D = ((const struct pp_tracer *)client)->scene->decorations;
    double n = randomisation->done.of[estimator];
    const double *sums = randomisation->sums;
    switch (estimator) {
    case DIRECT:
        return (sums[PP_SC] + sums[PP_ERC] + D * sums[PP_IRC]) / n;
    case GATHER:
        return D * (sums[SUM_GATHER] / n + sums[SUM_CELLS]);
    case CORRECTION:
        return D * sums[SUM_CORRECTION] / n;
    default:
        return D * sums[SUM_SHARED] / n;
    }
}

static double tracer_value(const void *client, int point,
                           const struct pp_randomisation *randomisation, int component)
{
    double D = ((const struct pp_tracer *)client)->scene->decorations;
    double direct = randomisation->done.of[DIRECT];
    double reflected = tracer_part(client, point, randomisation, GATHER)
                       + tracer_part(client, point, randomisation, CORRECTION);
    if (((const struct pp_tracer *)client)->shared)
        reflected += tracer_part(client, point, randomisation, SHARED);
    switch (component) {
    case PP_SC:
    case PP_ERC:
        return randomisation->sums[component] / direct;
    case PP_IRC:
        return D * randomisation->sums[PP_IRC] / direct + reflected;
    default:
        return tracer_part(client, point, randomisation, DIRECT) + reflected;
    }
}

static double tracer_bound(const void *client, int point, int component, unsigned found,
                           const double *paths)
{
    const struct pp_tracer *tracer = client;
    /* A shared point counts as one path, since its mean weight at a receiver is about
     * 1. */
    double reflected = paths[tracer->points[point].shares ? SHARED : CORRECTION];
    if (tracer->scene->glass_image_count > 0) /* other openings mirrored in glass */
        reflected = fmin(reflected, PP_GLASS_CHANCE * paths[DIRECT]);
    return pp_unsampled_of_component(&tracer->points[point].most, component, found,
                                     paths[DIRECT], reflected);
}

/* Sampler in which each point has its own correction. */
static const struct pp_sampler sampler = {
    .estimators = SHARED,
    .values = PP_COMPONENT_COUNT,
    .fall = {1.5, 1.2, 1.05}, /* measured, conservative */
    .pilot = {{4, 4, 1}},
    .least = {{16, 8, 2}},
    .state_size = sizeof(struct pp_path_state),
    .begin = begin_tracer_state,
    .seed = traced_point_seed,
    .follow = follow_traced_paths,
    .value = tracer_value,
    .part = tracer_part,
    .bound = tracer_bound,
};

/* Greatest number of points that receivers share in a randomisation: a power of two at
 * which the points cause a third of the target variance in a room like the deep office.
 * If more points are needed, there are more randomisations. */
static uint32_t most_shared(double error)
{
    uint32_t most = LEAST_SHARED;
    while (2 * most <= MOST_SHARED && 2.0 * most * error * error <= SHARED_VARIANCE)
        most *= 2;
    return most;
}

/* Estimate of the direct light alone. */
static double direct_part_of(const void *client, int point,
                             const struct pp_randomisation *randomisation,
                             int estimator)
{
    (void)client, (void)point, (void)estimator;
    return (randomisation->sums[PP_SC] + randomisation->sums[PP_ERC])
           / randomisation->done.of[DIRECT];
}

/* Components of direct light, or their sum for any other index. */
static double direct_value_of(const void *client, int point,
                              const struct pp_randomisation *randomisation,
                              int component)
{
    return component == PP_SC || component == PP_ERC
               ? randomisation->sums[component] / randomisation->done.of[DIRECT]
               : direct_part_of(client, point, randomisation, DIRECT);
}

static double direct_bound_of(const void *client, int point, int component,
                              unsigned found, const double *paths)
{
    return tracer_bound(client, point, component, found | 1U << PP_IRC, paths);
}

static struct pp_sampler of_direct_light(void)
{
    struct pp_sampler direct = sampler;
    direct.estimators = DIRECT + 1;
    direct.value = direct_value_of;
    direct.part = direct_part_of;
    direct.bound = direct_bound_of;
    return direct;
}

/* Sampler in which part of the correction is shared. The receiver's own paths then
 * sample only the remainder. */
static struct pp_sampler sharing(double error)
{
    struct pp_sampler shared = sampler;
    shared.estimators = ESTIMATORS;
    shared.fall[SHARED] = 1.05;
    shared.pilot = (struct pp_counts){{4, 8, 2, 8}};
    /* With only 8 shared points, a single one may cause most of a receiver's error. */
    shared.least = (struct pp_counts){{4, 8, 4, 16}};
    /* Half of PP_RANDOMISATIONS: saves time, with equally reliable standard errors.
     * Without shared points, the standard errors would be less reliable. */
    shared.pilot_randomisations = 16;
    shared.most.of[SHARED] = most_shared(error);
    shared.cost[SHARED] = SHARED_COST;
    shared.cost_of_more = SHARED_COST * most_shared(error);
    shared.prepare = share_light;
    return shared;
}

/* ---- making ---- */

static double share_of_openings(const struct pp_world *world)
{
    double openings_m2 = 0.0, inside_m2 = 0.0;
    for (int i = 0; i < world->opening_count; i++)
        openings_m2 += world->openings[i].inner.area_m2;
    for (int i = 0; i < world->face_count; i++)
        inside_m2 += world->surfaces[i].outline.area_m2;
    return openings_m2 > 0.0 && inside_m2 > 0.0 ? openings_m2 / inside_m2 : 1.0;
}

/* Increases the paths of the pilot and the least number of paths if openings are
 * small. */
static void look_closer(struct pp_sampler *changed, const struct pp_world *world)
{
    uint32_t times = 1;
    double share = share_of_openings(world);
    while (share < SPOTTED_SHARE && times < SPOTTED_MOST
           && times * share < SPOTTED_LIKE)
        times *= 2;
    for (int k = 0; k < changed->estimators; k++) {
        changed->pilot.of[k] *= times;
        changed->least.of[k] *= times;
    }
}

/* Makes the point of a receiver; NULL: the working plane as a whole. The seed of the
 * point depends on the receiver's position, not on other receivers. */
static struct traced_point traced_at(const struct pp_tracer *tracer,
                                     const struct pp_receiver *receiver, uint64_t seed)
{
    const struct pp_light_scene *scene = tracer->scene;
    struct traced_point point = {
        .start = {.anywhere = !receiver, .normal = {0.0, 0.0, 1.0}},
        .seed = pp_hash(seed, UINT64_MAX)};
    if (receiver) {
        point.start.position = pp_vec_sub(receiver->position, scene->centre);
        point.start.normal = receiver->normal;
        point.seed =
            pp_hash_vec(pp_hash_vec(seed, receiver->position), receiver->normal);
    }
    point.shares =
        tracer->density
        && (!receiver
            || pp_shared_density_serves(tracer->density, point.start.position));
    point.most = pp_unsampled_of_room(scene, receiver ? &point.start.position : NULL,
                                      point.start.normal);
    return point;
}

/* Prepares light shared by receivers, if the room allows it. */
static enum pp_status share(struct pp_tracer *tracer, uint64_t seed,
                            struct pp_error *err)
{
    enum pp_status status =
        pp_shared_density_create(&tracer->density, tracer->scene, tracer->variate, err);
    if (status == PP_OK && tracer->density)
        status =
            pp_gather_cells_create(&tracer->cells, tracer->scene, tracer->variate, err);
    if (status != PP_OK || !tracer->density)
        return status;
    struct pp_path_state path;
    begin_tracer_state(tracer, &path);
    return pp_shared_light_create(&tracer->shared, &path, &tracer->sobol, seed, err);
}

enum pp_status pp_tracer_create(struct pp_tracer **result,
                                const struct pp_light_scene *scene,
                                const struct pp_environment *environment,
                                const struct pp_receiver *receivers, int receiver_count,
                                const struct pp_tracer_options *options,
                                struct pp_error *err)
{
    *result = NULL;
    struct pp_tracer *tracer = calloc(1, sizeof *tracer);
    if (!tracer)
        return pp_fail_memory(err);
    tracer->scene = scene;
    tracer->environment = environment;
    tracer->every_ray = options->every_ray;
    tracer->direct = options->direct;
    tracer->receiver_count = receiver_count;
    uint64_t seed = pp_hash(pp_hash_name(options->seed, scene->world->name), 0);
    pp_sobol_init(&tracer->sobol);
    enum pp_status status = PP_OK;
    if (!options->direct)
        status = pp_control_variate_solve(&tracer->variate, scene, environment,
                                          &tracer->sobol, pp_hash(seed, 1),
                                          options->threads, err);
    if (status == PP_OK && !options->direct && !options->alone)
        status = share(tracer, pp_hash(seed, 2), err);
    tracer->sampler = options->direct  ? of_direct_light()
                      : tracer->shared ? sharing(options->error)
                                       : sampler;
    look_closer(&tracer->sampler, scene->world);
    if (status == PP_OK) {
        bool average = options->average && tracer->scene->plane_count > 0;
        tracer->point_count = receiver_count + average;
        tracer->points =
            calloc((size_t)tracer->point_count + 1, sizeof *tracer->points);
        status = tracer->points ? PP_OK : pp_fail_memory(err);
    }
    for (int i = 0; status == PP_OK && i < tracer->point_count; i++)
        tracer->points[i] =
            traced_at(tracer, i < receiver_count ? &receivers[i] : NULL, seed);
    const struct pp_planner_options planned = {.error = options->error,
                                               .least_error = PP_TRACER_LEAST_ERROR,
                                               .samples = options->samples,
                                               .threads = options->threads};
    if (status == PP_OK)
        status = pp_planner_create(&tracer->planner, &tracer->sampler, tracer,
                                   tracer->point_count, &planned, err);
    if (status != PP_OK) {
        pp_tracer_destroy(tracer);
        return status;
    }
    *result = tracer;
    return PP_OK;
}

void pp_tracer_destroy(struct pp_tracer *tracer)
{
    if (!tracer)
        return;
    pp_planner_destroy(tracer->planner);
    free(tracer->points);
    pp_shared_light_destroy(tracer->shared);
    pp_shared_density_destroy(tracer->density);
    pp_gather_cells_destroy(tracer->cells);
    pp_control_variate_destroy(tracer->variate);
    free(tracer);
}

/* ---- the caller's loop ---- */

enum pp_status pp_tracer_advance(struct pp_tracer *tracer, double seconds,
                                 struct pp_error *err)
{
    return pp_planner_advance(tracer->planner, seconds, err);
}

bool pp_tracer_done(const struct pp_tracer *tracer)
{
    return pp_planner_done(tracer->planner);
}

double pp_tracer_progress(const struct pp_tracer *tracer)
{
    return pp_planner_progress(tracer->planner);
}

double pp_tracer_error(const struct pp_tracer *tracer)
{
    return pp_planner_error(tracer->planner);
}

void pp_tracer_read(const struct pp_tracer *tracer, int index,
                    struct pp_reading readings[PP_COMPONENT_COUNT])
{
    if (index < 0)
        index = tracer->receiver_count;
    if (index < tracer->point_count)
        pp_planner_read(tracer->planner, index, readings);
    for (int i = 0; i < PP_COMPONENT_COUNT; i++)
        if (index >= tracer->point_count)
            readings[i] = pp_reading_none("the average was not requested");
        else if (tracer->direct && i != PP_SC && i != PP_ERC)
            readings[i] = pp_reading_none("only direct light was requested");
}

double pp_tracer_common(const struct pp_tracer *tracer)
{
    if (!tracer->shared)
        return 0.0;
    return pp_common_variance_of_all(tracer->planner, tracer->receiver_count);
}

double pp_tracer_common_near(const struct pp_tracer *tracer)
{
    if (!tracer->shared)
        return 0.0;
    int count = tracer->receiver_count;
    struct pp_vec3 *places = calloc((size_t)count + 1, sizeof *places);
    if (!places)
        return 1.0; /* out of memory: full correlation, the conservative value */
    for (int i = 0; i < count; i++)
        places[i] = tracer->points[i].start.position;
    double common = pp_common_variance_of_near(tracer->planner, places, count);
    free(places);
    return common;
}

struct pp_tracer_work pp_tracer_work(const struct pp_tracer *tracer)
{
    struct pp_path_work work = pp_planner_work(tracer->planner);
    long long rays = 0, leaks = 0;
    if (tracer->shared)
        pp_shared_light_work(tracer->shared, &rays, &leaks);
    return (struct pp_tracer_work){work.paths, work.rays + rays, work.leaks + leaks};
}
