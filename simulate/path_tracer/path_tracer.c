/* path_tracer.c - samples the points of a room by the paths of path_trace.c: direct and
 * reflected light, each the mean over random paths. */
#include "simulate/path_tracer/path_tracer.h"

#include <stdlib.h>

#include "simulate/estimate/planner.h"
#include "simulate/path_tracer/path_trace.h"
#include "simulate/sampling/hash.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/scene/unsampled.h"

/* Estimators. The sums of their paths are by component, PP_SC to PP_IRC. */
enum { DIRECT, REFLECTED, ESTIMATORS };

/* Least target standard error, over Eh: a daylight factor of 0.002 %. */
static const double LEAST_ERROR = 0.00002;

struct plain_point {
    bool anywhere; /* true: anywhere on the working plane; false: at the position
                    * below */
    struct pp_vec3 position, normal;
    struct pp_room_bound most;
    uint64_t seed;
};

struct pp_path_tracer {
    const struct pp_light_scene *scene;
    const struct pp_environment *environment;
    struct plain_point *points; /* the receivers, then the average if requested */
    int point_count, receiver_count;
    struct pp_planner *planner;
};

/* ---- one path ---- */

/* Start of a path. */
static struct pp_lit_point lit_point(struct pp_path_walk *walk,
                                     const struct plain_point *point)
{
    double u[2];
    struct pp_lit_point at = {point->position, point->normal,
                              walk->scene->has_room ? PP_INDOORS : PP_ANYWHERE};
    if (point->anywhere) {
        pp_path_walk_draw(walk, 2, u);
        at.point = pp_light_scene_of_world_plane_point(walk->scene, u[0], u[1]);
    }
    return at;
}

/* Adds a path's light to the sum of its component. */
static void add_path(struct pp_path_walk *walk, const struct plain_point *point,
                     int estimator, double *sums)
{
    enum pp_path_first first = PP_FIRST_NONE;
    struct pp_lit_point at = lit_point(walk, point);
    double E;
    if (estimator == DIRECT && walk->scene->has_room) {
        E = pp_path_trace_openings(walk, &at, &first).g;
    } else {
        E = pp_path_trace_lobe(walk, &at, walk->scene->has_room, &first).g;
    }
    enum pp_component component = first == PP_FIRST_SKY       ? PP_SC
                                  : first == PP_FIRST_OUTSIDE ? PP_ERC
                                                              : PP_IRC;
    if (estimator == REFLECTED)
        component = PP_IRC;
    sums[component] += E;
}

/* ---- the sampler ---- */

/* Offsets of the sums of direct and of reflected light. */
enum { DIRECT_SUMS = 0, REFLECTED_SUMS = 3 };

static void begin_thread(const void *client, void *state)
{
    const struct pp_path_tracer *tracer = client;
    *(struct pp_path_walk *)state = (struct pp_path_walk){
        .scene = tracer->scene, .environment = tracer->environment};
}

static uint64_t seed_of_point(const void *client, int point)
{
    return ((const struct pp_path_tracer *)client)->points[point].seed;
}

static void follow_paths(const void *client, void *state,
                         const struct pp_path_range *range,
                         struct pp_randomisation *randomisation)
{
    const struct pp_path_tracer *tracer = client;
    struct pp_path_walk *walk = state;
    double *sums = randomisation->sums
                   + (range->estimator == DIRECT ? DIRECT_SUMS : REFLECTED_SUMS);
    long rays = walk->rays, leaks = walk->leaks;
    walk->sequence = range->sequence;
    for (walk->index = range->first; walk->index < range->end; walk->index++) {
        walk->vertex = 0;
        if (range->estimator == DIRECT || tracer->scene->has_room)
            add_path(walk, &tracer->points[range->point], range->estimator, sums);
    }
    randomisation->rays[range->estimator] += walk->rays - rays;
    randomisation->leaks += walk->leaks - leaks;
}

/* A component, or the daylight factor. Internally reflected light includes the
 * allowance for decorations. */
static double component_of(const void *client, int point,
                           const struct pp_randomisation *randomisation, int component)
{
    (void)point;
    double D = ((const struct pp_path_tracer *)client)->scene->decorations;
    double direct = randomisation->done.of[DIRECT];
    double reflected = randomisation->done.of[REFLECTED];
    const double *sums = randomisation->sums;
    double IRC = D
                 * (sums[DIRECT_SUMS + PP_IRC] / direct
                    + sums[REFLECTED_SUMS + PP_IRC] / reflected);
    if (component == PP_IRC)
        return IRC;
    if (component == PP_DF)
        return (sums[PP_SC] + sums[PP_ERC]) / direct + IRC;
    return sums[component] / direct;
}

static double part_of_estimator(const void *client, int point,
                                const struct pp_randomisation *randomisation,
                                int estimator)
{
    (void)point;
    double D = ((const struct pp_path_tracer *)client)->scene->decorations;
    double n = randomisation->done.of[estimator];
    const double *sums = randomisation->sums;
    if (estimator == REFLECTED)
        return D * sums[REFLECTED_SUMS + PP_IRC] / n;
    return (sums[PP_SC] + sums[PP_ERC] + D * sums[PP_IRC]) / n;
}

static double missed_light(const void *client, int point, int component, unsigned found,
                           const double *paths)
{
    const struct pp_path_tracer *tracer = client;
    return pp_unsampled_of_component(&tracer->points[point].most, component, found,
                                     paths[DIRECT], paths[REFLECTED]);
}

static const struct pp_sampler plain_sampler = {
    .estimators = ESTIMATORS,
    .values = PP_COMPONENT_COUNT,
    .fall = {1.2, 1.0},
    .pilot = {{16, 16}},
    .least = {{16, 16}},
    .state_size = sizeof(struct pp_path_walk),
    .begin = begin_thread,
    .seed = seed_of_point,
    .follow = follow_paths,
    .value = component_of,
    .part = part_of_estimator,
    .bound = missed_light,
};

/* ---- create, and the caller's loop ---- */

static struct plain_point plain_point_of(const struct pp_light_scene *scene,
                                         const struct pp_receiver *receiver,
                                         uint64_t seed)
{
    struct plain_point point = {.anywhere = !receiver,
                                .normal = {0.0, 0.0, 1.0},
                                .seed = pp_hash(seed, UINT64_MAX)};
    if (receiver) {
        point.position = pp_vec_sub(receiver->position, scene->centre);
        point.normal = receiver->normal;
        point.seed =
            pp_hash_vec(pp_hash_vec(seed, receiver->position), receiver->normal);
    }
    point.most =
        pp_unsampled_of_room(scene, receiver ? &point.position : NULL, point.normal);
    return point;
}

static enum pp_status make_points(struct pp_path_tracer *tracer,
                                  const struct pp_receiver *receivers,
                                  const struct pp_path_tracer_options *options,
                                  struct pp_error *err)
{
    /* Makes the seed differ from that of simulate/fast/tracer.h for the same option
     * --seed. */
    uint64_t seed = pp_hash_name(options->seed, tracer->scene->world->name);
    int count = tracer->receiver_count;
    tracer->point_count = count + (options->average && tracer->scene->plane_count > 0);
    tracer->points = calloc((size_t)tracer->point_count + 1, sizeof *tracer->points);
    if (!tracer->points)
        return pp_fail_memory(err);
    for (int i = 0; i < tracer->point_count; i++)
        tracer->points[i] =
            plain_point_of(tracer->scene, i < count ? &receivers[i] : NULL, seed);
    return PP_OK;
}

enum pp_status pp_path_tracer_create(struct pp_path_tracer **result,
                                     const struct pp_light_scene *scene,
                                     const struct pp_environment *environment,
                                     const struct pp_receiver *receivers,
                                     int receiver_count,
                                     const struct pp_path_tracer_options *options,
                                     struct pp_error *err)
{
    *result = NULL;
    struct pp_path_tracer *tracer = calloc(1, sizeof *tracer);
    if (!tracer)
        return pp_fail_memory(err);
    tracer->scene = scene;
    tracer->environment = environment;
    tracer->receiver_count = receiver_count;
    const struct pp_planner_options planned = {.error = options->error,
                                               .least_error = LEAST_ERROR,
                                               .samples = options->samples,
                                               .threads = options->threads};
    enum pp_status status = make_points(tracer, receivers, options, err);
    if (status == PP_OK)
        status = pp_planner_create(&tracer->planner, &plain_sampler, tracer,
                                   tracer->point_count, &planned, err);
    if (status != PP_OK) {
        pp_path_tracer_destroy(tracer);
        return status;
    }
    *result = tracer;
    return PP_OK;
}

void pp_path_tracer_destroy(struct pp_path_tracer *tracer)
{
    if (!tracer)
        return;
    pp_planner_destroy(tracer->planner);
    free(tracer->points);
    free(tracer);
}

enum pp_status pp_path_tracer_advance(struct pp_path_tracer *tracer, double seconds,
                                      struct pp_error *err)
{
    return pp_planner_advance(tracer->planner, seconds, err);
}

bool pp_path_tracer_done(const struct pp_path_tracer *tracer)
{
    return pp_planner_done(tracer->planner);
}

double pp_path_tracer_progress(const struct pp_path_tracer *tracer)
{
    return pp_planner_progress(tracer->planner);
}

double pp_path_tracer_error(const struct pp_path_tracer *tracer)
{
    return pp_planner_error(tracer->planner);
}

void pp_path_tracer_read(const struct pp_path_tracer *tracer, int index,
                         struct pp_reading readings[PP_COMPONENT_COUNT])
{
    if (index < 0)
        index = tracer->receiver_count;
    if (index < tracer->point_count) {
        pp_planner_read(tracer->planner, index, readings);
        return;
    }
    for (int i = 0; i < PP_COMPONENT_COUNT; i++)
        readings[i] = pp_reading_none("the average was not requested");
}
