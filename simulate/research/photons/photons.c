/* photons.c - connects receivers to the sampler, with three estimators: direct light,
 * the light of surfaces hit by photons, and light found by rays from the receiver. */
#include "simulate/research/photons/photons.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/estimate/common_variance.h"
#include "simulate/estimate/planner.h"
#include "simulate/research/photons/photon_counter.h"
#include "simulate/research/photons/photon_gather.h"
#include "simulate/research/photons/photon_store.h"
#include "simulate/scene/unsampled.h"

/* Estimators, and offsets of their sums. Direct light has sums for PP_SC and PP_ERC,
 * photons for PP_ERC and PP_IRC, rays from the receiver for all three. */
enum { DIRECT, PHOTONS, GATHER, ESTIMATORS };
enum { SUM_DIRECT = 0, SUM_PHOTONS = 2, SUM_GATHER = 4 };

/* Greatest number of photons that receivers share in a randomisation. The photons of
 * one randomisation take about 5 MB in a bright room, and those of 64 are in memory at
 * a time. If more photons are needed, there are more randomisations. */
enum { MOST_SHARED = 1024 };

/* Cost of a shared photon to a receiver, in rays, as if about 25 receivers used the
 * photon. */
static const double SHARED_COST = 0.3;

/* Smallest target standard error, over Eh: a daylight factor of 0.002 %. */
static const double LEAST_ERROR = 0.00002;

/* A receiver, or the working plane as a whole. */
struct photon_point {
    struct pp_photon_receiver receiver;
    struct pp_photon_counter counter;
    bool sees; /* true if an opening is visible from the point */
    struct pp_room_bound most;
    uint64_t seed;
};

struct pp_photons {
    const struct pp_light_scene *scene;
    const struct pp_environment *environment;
    struct pp_photon_sources *sources;
    struct photon_point *points; /* the receivers, then the average if requested */
    double *chances;             /* probabilities of openings, by receiver */
    struct pp_photon_store *store;
    bool shares; /* true if there are receivers, and they are points, not discs */
    int point_count, receiver_count;
    struct pp_sampler sampler;
    struct pp_planner *planner;
};

/* ---- the estimators ---- */

static void take_direct(struct pp_photon_state *state, const struct photon_point *point,
                        double *sums)
{
    struct pp_photon_place place;
    enum pp_photon_last last;
    if (!point->sees)
        return;
    pp_photon_enter(state, point->receiver.chances, 0, &place);
    struct pp_rgb light = pp_photon_receiver_takes(state, &point->receiver, &place,
                                                   pp_photon_state_branch(0, 2), &last);
    sums[last == PP_PHOTON_FROM_SKY ? PP_SC : PP_ERC] += pp_rgb_luminance(light);
}

/* Adds the light of a shared photon. The last surface that scattered the photon
 * determines the sum: outside, sums[0] (PP_ERC); inside, sums[1] (PP_IRC). */
static void take_photon(struct pp_photon_state *state, const struct photon_point *point,
                        const struct pp_photon_place *places, int count, double *sums)
{
    enum pp_photon_last last;
    for (int i = 0; i < count; i++) {
        struct pp_rgb light =
            pp_photon_receiver_takes(state, &point->receiver, &places[i], 0, &last);
        sums[last == PP_PHOTON_FROM_INSIDE] += pp_rgb_luminance(light);
    }
}

/* Counting sensor: adds the direct light of openings. */
static void count_direct(struct pp_photon_state *state,
                         const struct photon_point *point, double *sums)
{
    struct pp_photon photon;
    struct pp_photon_place place;
    bool goes = pp_photon_begin(state, state->sources->pane_count, 0, &photon, &place);
    while (goes) {
        goes = pp_photon_arrive(state, &photon);
        sums[photon.last == PP_PHOTON_FROM_SKY ? PP_SC : PP_ERC] +=
            pp_photon_counter_takes(&point->counter, &photon);
        struct pp_rgb clear = pp_rgb_grey(1.0);
        if (!goes || photon.hit.part < 0
            || !pp_light_scene_parts_pass(state->scene, &photon.hit, &photon.ray,
                                          &clear))
            return;
        photon.flux = pp_rgb_times(photon.flux, clear);
    }
}

/* Counting sensor: adds all other light. */
static void count_photon(struct pp_photon_state *state,
                         const struct photon_point *point, double *sums)
{
    struct pp_photon photon;
    struct pp_photon_place place;
    bool goes = pp_photon_begin(state, state->sources->count, 0, &photon, &place);
    while (goes) {
        goes = pp_photon_arrive(state, &photon);
        if (photon.scattered)
            sums[photon.last == PP_PHOTON_FROM_INSIDE] +=
                pp_photon_counter_takes(&point->counter, &photon);
        goes = goes && pp_photon_turn(state, &photon);
    }
}

/* ---- the sampler ---- */

static void begin_photon_state(const void *client, void *data)
{
    const struct pp_photons *photons = client;
    *(struct pp_photon_state *)data =
        (struct pp_photon_state){.scene = photons->scene,
                                 .environment = photons->environment,
                                 .sources = photons->sources};
}

static uint64_t photon_point_seed(const void *client, int point)
{
    return ((const struct pp_photons *)client)->points[point].seed;
}

/* Follows one path of an estimator. */
static void follow_one(const struct pp_photons *photons, struct pp_photon_state *state,
                       const struct pp_path_range *range, double *sums)
{
    const struct photon_point *point = &photons->points[range->point];
    bool counts = point->counter.area_m2 > 0.0;
    if (range->estimator == DIRECT)
        (counts ? count_direct : take_direct)(state, point, sums + SUM_DIRECT);
    else if (range->estimator == GATHER && !counts)
        pp_photon_gather(state, &point->receiver, 0, sums + SUM_GATHER);
    else if (range->estimator == PHOTONS && counts)
        count_photon(state, point, sums + SUM_PHOTONS);
    else if (range->estimator == PHOTONS) {
        int count;
        const struct pp_photon_place *places = pp_photon_store_places(
            photons->store, range->randomisation, state->index, &count);
        take_photon(state, point, places, count, sums + SUM_PHOTONS);
    }
}

static void follow_photon_range(const void *client, void *data,
                                const struct pp_path_range *range,
                                struct pp_randomisation *randomisation)
{
    struct pp_photon_state *state = data;
    long rays = state->rays, leaks = state->leaks;
    state->sequence = range->sequence;
    for (state->index = range->first; state->index < range->end; state->index++)
        follow_one(client, state, range, randomisation->sums);
    randomisation->rays[range->estimator] += state->rays - rays;
    randomisation->leaks += state->leaks - leaks;
}

static enum pp_status prepare_photons(const void *client, int stage, int first,
                                      int count, const struct pp_counts *wanted,
                                      struct pp_thread_pool *pool, struct pp_error *err)
{
    const struct pp_photons *photons = client;
    uint32_t *each = malloc((size_t)count * sizeof *each);
    if (!each)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        each[i] = wanted[i].of[PHOTONS];
    enum pp_status status =
        pp_photon_store_extend(photons->store, stage, first, count, each, pool, err);
    free(each);
    return status;
}

/* An estimator's contribution to a component. */
static double estimator_share(const struct pp_randomisation *randomisation,
                              int estimator, int component)
{
    static const int first[ESTIMATORS] = {SUM_DIRECT, SUM_PHOTONS - PP_ERC, SUM_GATHER};
    static const bool has[ESTIMATORS][3] = {
        {true, true, false}, {false, true, true}, {true, true, true}};
    if (!has[estimator][component])
        return 0.0;
    return randomisation->sums[first[estimator] + component]
           / randomisation->done.of[estimator];
}

/* Factor by which a component is multiplied: the allowance for decorations for
 * internally reflected light, else 1. */
static double allowance_of(const void *client, int component)
{
    return component == PP_IRC ? ((const struct pp_photons *)client)->scene->decorations
                               : 1.0;
}

static double photon_estimate(const void *client, int point,
                              const struct pp_randomisation *randomisation,
                              int estimator)
{
    (void)point;
    double sum = 0.0;
    for (int i = PP_SC; i <= PP_IRC; i++)
        sum += allowance_of(client, i) * estimator_share(randomisation, estimator, i);
    return sum;
}

static double photon_point_value(const void *client, int point,
                                 const struct pp_randomisation *randomisation,
                                 int component)
{
    (void)point;
    double sum = 0.0;
    for (int i = 0; i < ESTIMATORS; i++)
        sum += component == PP_DF ? photon_estimate(client, point, randomisation, i)
                                  : allowance_of(client, component)
                                        * estimator_share(randomisation, i, component);
    return sum;
}

static double photon_point_bound(const void *client, int point, int component,
                                 unsigned found, const double *paths)
{
    const struct pp_photons *photons = client;
    return pp_unsampled_of_component(&photons->points[point].most, component, found,
                                     paths[DIRECT], paths[PHOTONS]);
}

/* Sampler for sensors on which photons are counted, each with its own photons. */
static const struct pp_sampler counting = {
    .estimators = ESTIMATORS,
    .values = PP_COMPONENT_COUNT,
    .fall = {1.3, 1.05, 1.05}, /* measured, conservative */
    .pilot = {{16, 16, 16}},
    .least = {{16, 16, 16}},
    .state_size = sizeof(struct pp_photon_state),
    .begin = begin_photon_state,
    .seed = photon_point_seed,
    .follow = follow_photon_range,
    .value = photon_point_value,
    .part = photon_estimate,
    .bound = photon_point_bound,
};

/* Sampler in which receivers share photons. */
static struct pp_sampler sharing(void)
{
    struct pp_sampler sampler = counting;
    sampler.most.of[PHOTONS] = MOST_SHARED;
    sampler.cost[PHOTONS] = SHARED_COST;
    sampler.cost_of_more = SHARED_COST * MOST_SHARED;
    sampler.prepare = prepare_photons;
    return sampler;
}

/* ---- making ---- */

/* Makes the point of a receiver. The seed of the point depends on the receiver's
 * position, not on other receivers. */
static struct photon_point receiver_of(const struct pp_photons *photons,
                                       const struct pp_receiver *receiver,
                                       double sensor_m, uint64_t seed, double *chances)
{
    const struct pp_light_scene *scene = photons->scene;
    struct photon_point point = {
        .receiver = {pp_vec_sub(receiver->position, scene->centre), receiver->normal,
                     scene->has_room ? PP_INDOORS : PP_ANYWHERE, chances},
        .seed = pp_hash_vec(pp_hash_vec(seed, receiver->position), receiver->normal)};
    point.sees = pp_photon_sources_for(chances, photons->sources, scene,
                                       point.receiver.point, receiver->normal);
    if (sensor_m > 0.0)
        point.counter =
            pp_photon_counter_disc(point.receiver.point, receiver->normal, sensor_m);
    point.most = pp_unsampled_of_room(scene, &point.receiver.point, receiver->normal);
    return point;
}

static struct photon_point photon_plane_point(const struct pp_photons *photons,
                                              uint64_t seed)
{
    return (struct photon_point){
        .counter = pp_photon_counter_plane(photons->scene),
        .most = pp_unsampled_of_room(photons->scene, NULL, pp_vec(0.0, 0.0, 1.0)),
        .seed = pp_hash(seed, UINT64_MAX)};
}

static enum pp_status fill_photons(struct pp_photons *photons,
                                   const struct pp_receiver *receivers,
                                   const struct pp_photons_options *options,
                                   struct pp_error *err)
{
    struct pp_photon_state state;
    const struct pp_light_scene *scene = photons->scene;
    size_t panes = (size_t)photons->sources->pane_count;
    uint64_t seed = pp_hash(pp_hash_name(options->seed, scene->world->name), 0);
    int count = photons->receiver_count;
    photons->point_count = count + (options->average && scene->plane_count > 0);
    photons->points = calloc((size_t)photons->point_count + 1, sizeof *photons->points);
    photons->chances = calloc((size_t)count * panes + 1, sizeof *photons->chances);
    if (!photons->points || !photons->chances)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        photons->points[i] = receiver_of(photons, &receivers[i], options->sensor_m,
                                         seed, photons->chances + (size_t)i * panes);
    if (photons->point_count > count)
        photons->points[count] = photon_plane_point(photons, seed);
    photons->shares = count > 0 && options->sensor_m == 0.0;
    photons->sampler = photons->shares ? sharing() : counting;
    begin_photon_state(photons, &state);
    return pp_photon_store_create(&photons->store, &state, pp_hash(seed, 1), err);
}

static enum pp_status make_photons(struct pp_photons *photons,
                                   const struct pp_receiver *receivers,
                                   const struct pp_photons_options *options,
                                   struct pp_error *err)
{
    if (!(options->sensor_m >= 0.0) || isinf(options->sensor_m))
        return pp_fail(err, PP_BAD_INPUT,
                       "the sensor radius is %g m; expected 0 or more",
                       options->sensor_m);
    const struct pp_planner_options planned = {.error = options->error,
                                               .least_error = LEAST_ERROR,
                                               .samples = options->samples,
                                               .threads = options->threads};
    enum pp_status status = pp_photon_sources_create(&photons->sources, photons->scene,
                                                     photons->environment, err);
    if (status == PP_OK)
        status = fill_photons(photons, receivers, options, err);
    if (status == PP_OK)
        status = pp_planner_create(&photons->planner, &photons->sampler, photons,
                                   photons->point_count, &planned, err);
    return status;
}

enum pp_status pp_photons_create(
    struct pp_photons **result, const struct pp_light_scene *scene,
    const struct pp_environment *environment, const struct pp_receiver *receivers,
    int receiver_count, const struct pp_photons_options *options, struct pp_error *err)
{
    *result = NULL;
    struct pp_photons *photons = calloc(1, sizeof *photons);
    if (!photons)
        return pp_fail_memory(err);
    photons->scene = scene;
    photons->environment = environment;
    photons->receiver_count = receiver_count;
    enum pp_status status = make_photons(photons, receivers, options, err);
    if (status != PP_OK) {
        pp_photons_destroy(photons);
        return status;
    }
    *result = photons;
    return PP_OK;
}

void pp_photons_destroy(struct pp_photons *photons)
{
    if (!photons)
        return;
    pp_planner_destroy(photons->planner);
    pp_photon_store_destroy(photons->store);
    pp_photon_sources_destroy(photons->sources);
    free(photons->points);
    free(photons->chances);
    free(photons);
}

/* ---- the caller's loop ---- */

enum pp_status pp_photons_advance(struct pp_photons *photons, double seconds,
                                  struct pp_error *err)
{
    return pp_planner_advance(photons->planner, seconds, err);
}

bool pp_photons_done(const struct pp_photons *photons)
{
    return pp_planner_done(photons->planner);
}

double pp_photons_progress(const struct pp_photons *photons)
{
    return pp_planner_progress(photons->planner);
}

double pp_photons_error(const struct pp_photons *photons)
{
    return pp_planner_error(photons->planner);
}

void pp_photons_read(const struct pp_photons *photons, int index,
                     struct pp_reading readings[PP_COMPONENT_COUNT])
{
    if (index < 0)
        index = photons->receiver_count;
    if (index < photons->point_count)
        pp_planner_read(photons->planner, index, readings);
    for (int i = 0; i < PP_COMPONENT_COUNT && index >= photons->point_count; i++)
        readings[i] = pp_reading_none("the average was not requested");
}

double pp_photons_common(const struct pp_photons *photons)
{
    if (!photons->shares)
        return 0.0;
    return pp_common_variance_of_all(photons->planner, photons->receiver_count);
}

double pp_photons_common_near(const struct pp_photons *photons)
{
    int count = photons->receiver_count;
    if (!photons->shares)
        return 0.0;
    struct pp_vec3 *places = calloc((size_t)count, sizeof *places);
    if (!places)
        return 1.0; /* out of memory: full correlation, the conservative value */
    for (int i = 0; i < count; i++)
        places[i] = photons->points[i].receiver.point;
    double common = pp_common_variance_of_near(photons->planner, places, count);
    free(places);
    return common;
}

struct pp_photons_work pp_photons_work(const struct pp_photons *photons)
{
    struct pp_path_work work = pp_planner_work(photons->planner);
    long long rays, leaks;
    pp_photon_store_work(photons->store, &rays, &leaks);
    return (struct pp_photons_work){work.paths, work.rays + rays, work.leaks + leaks};
}
