/* opening_store.c - the tables of all openings, filled by paths. The value of each bin
 * of each patch is the mean over several paths that leave the opening there. */
#include "simulate/transport/opening_store.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/thread_pool.h"
#include "simulate/sampling/hash.h"
#include "simulate/sampling/lobe.h"
#include "simulate/transport/light_path.h"

enum {
    PATHS = 1 << 19,    /* for all bins of all patches */
    LEAST_SAMPLES = 16, /* least number of paths for each bin */
    PROBES = 256,       /* rays that measure the distance of surfaces */
};

static const struct pp_target *target_of(const struct pp_light_scene *scene, int window)
{
    return &scene->panes[window].target;
}

/* Distance of the nearest surface in front of the opening, the ground included;
 * INFINITY if none is met. */
static double nearest(const struct pp_light_scene *scene, int window,
                      const struct pp_sobol *sobol, uint64_t seed)
{
    const struct pp_target *target = target_of(scene, window);
    const struct pp_opening_table whole = {.columns = 1, .rows = 1};
    struct pp_vec3 out = pp_vec_scale(target->normal, -1.0), a, b;
    struct pp_sobol_sequence sequence;
    double least = INFINITY;
    pp_sobol_sequence_init(&sequence, sobol, seed);
    pp_lobe_frame(out, &a, &b);
    for (uint32_t i = 0; i < PROBES; i++) {
        double u[4];
        struct pp_light_hit hit;
        pp_sobol_sequence_draw(&sequence, i, 0, 4, u);
        struct pp_light_ray ray = {
            pp_opening_table_point(&whole, target, 0, u[0], u[1]), out,
            pp_lobe_sample_in_frame(a, b, out, u[2], u[3]), PP_OUTDOORS};
        enum pp_meeting meeting = pp_light_scene_meet(scene, &ray, &hit);
        if (meeting == PP_MEETS_PART || meeting == PP_MEETS_GROUND)
            least = fmin(least, hit.distance_m);
    }
    return least;
}

/* One sample of the radiance along a ray that leaves a window to the outside, and its
 * length *distance_m. False if the ray meets no surface, or a pane. */
static bool outside_radiance(struct pp_radiance_state *state,
                             const struct pp_light_ray *ray, struct pp_rgb *radiance,
                             double *distance_m)
{
    struct pp_light_hit hit;
    struct pp_light_path path = pp_light_path_outside(state, ray, 1, 0);
    enum pp_meeting meeting = pp_radiance_state_meet(state, ray, &hit);
    *distance_m = hit.distance_m;
    if (!pp_opening_table_takes(state->scene, meeting, &hit))
        return false;
    *radiance = pp_rgb_grey(0.0);
    if (pp_light_path_arrive(state, &path, meeting, &hit, radiance))
        *radiance = pp_rgb_add(*radiance, pp_light_path_follow(state, &path, NULL));
    return true;
}

/* Sums the radiances that a bin's paths find at surfaces at least table->far_m away;
 * returns the number of paths that met such a surface. */
static int sample_bin(const struct pp_opening_table *table,
                      struct pp_radiance_state *state, int window, int patch, int bin,
                      uint32_t samples, struct pp_rgb *sum)
{
    const struct pp_target *target = target_of(state->scene, window);
    int met = 0;
    for (uint32_t i = 0; i < samples; i++) {
        double u[4], distance;
        struct pp_light_ray ray = {.off = pp_vec_scale(target->normal, -1.0),
                                   .space = PP_OUTDOORS};
        struct pp_rgb radiance;
        state->index = (uint32_t)bin * samples + i;
        pp_sobol_sequence_draw(&state->sequence, state->index, 0, 4, u);
        ray.from = pp_opening_table_point(table, target, patch, u[0], u[1]);
        if (!pp_opening_table_direction(target, bin, u[2], u[3], &ray.to)
            || !outside_radiance(state, &ray, &radiance, &distance)
            || distance < table->far_m)
            continue;
        *sum = pp_rgb_add(*sum, radiance);
        met++;
    }
    return met;
}

/* Fills in the mean radiance of each bin. A bin whose paths met no surface gets the
 * mean of all bins. */
static void fill_patch(struct pp_opening_table *table, struct pp_radiance_state *state,
                       int window, int patch, uint32_t samples)
{
    enum { BINS = PP_OPENING_TABLE_BINS };
    struct pp_rgb *bins = &table->radiance[(size_t)patch * BINS];
    int met[BINS] = {0}, all = 0;
    struct pp_rgb sum = pp_rgb_grey(0.0);
    for (int bin = 0; bin < BINS; bin++) {
        met[bin] = sample_bin(table, state, window, patch, bin, samples, &bins[bin]);
        sum = pp_rgb_add(sum, bins[bin]);
        all += met[bin];
    }
    for (int bin = 0; bin < BINS; bin++) {
        struct pp_rgb value = met[bin] > 0 ? bins[bin] : sum;
        int count = met[bin] > 0 ? met[bin] : all > 0 ? all : 1;
        bins[bin] = pp_rgb_scale(value, 1.0 / count);
    }
}

/* The patches of one window, to be filled by any worker of a pool. */
struct filling {
    struct pp_opening_store *store;
    const struct pp_light_scene *scene;
    const struct pp_environment *environment;
    const struct pp_sobol *sobol;
    uint64_t seed;
    int window;
};

static bool fill_opening_patch(void *data, int worker, int patch)
{
    (void)worker;
    const struct filling *filling = data;
    struct pp_opening_store *store = filling->store;
    int window = filling->window;
    struct pp_radiance_state state = {.scene = filling->scene,
                                      .environment = filling->environment,
                                      .options = pp_radiance_state_defaults()};
    pp_sobol_sequence_init(
        &state.sequence, filling->sobol,
        pp_hash(pp_hash(filling->seed, (uint64_t)window), (uint64_t)patch));
    fill_patch(&store->tables[window], &state, window, patch, store->samples);
    return true;
}

/* Number of paths for each bin: a fixed total divided by the number of bins, at least
 * LEAST_SAMPLES. */
static uint32_t samples_of(const struct pp_opening_store *store)
{
    long bins = 1;
    for (int i = 0; i < store->count; i++)
        if (store->tables[i].radiance)
            bins += (long)store->tables[i].columns * store->tables[i].rows
                    * PP_OPENING_TABLE_BINS;
    long samples = PATHS / bins;
    return samples > LEAST_SAMPLES ? (uint32_t)samples : LEAST_SAMPLES;
}

static void fill_all(struct pp_opening_store *store, const struct pp_light_scene *scene,
                     const struct pp_environment *environment,
                     const struct pp_sobol *sobol, uint64_t seed,
                     struct pp_thread_pool *pool)
{
    for (int i = 0; i < store->count; i++) {
        const struct pp_opening_table *table = &store->tables[i];
        int patches = table->radiance ? table->columns * table->rows : 0;
        struct filling filling = {store, scene, environment, sobol, seed, i};
        pp_thread_pool_run(pool, 0, patches, fill_opening_patch, &filling);
    }
}

static enum pp_status lay_out_tables(struct pp_opening_store *store,
                                     const struct pp_light_scene *scene,
                                     const struct pp_sobol *sobol, uint64_t seed,
                                     struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; status == PP_OK && i < store->count; i++) {
        bool empty = scene->panes[i].unobstructed && !scene->ground.shaded;
        double near =
            empty ? INFINITY
                  : nearest(scene, i, sobol, pp_hash(seed, (uint64_t)-1 - (uint64_t)i));
        status =
            pp_opening_table_init(&store->tables[i], target_of(scene, i), near, err);
    }
    return status;
}

enum pp_status pp_opening_store_create(struct pp_opening_store **result,
                                       const struct pp_light_scene *scene,
                                       const struct pp_environment *environment,
                                       uint64_t seed, int threads, struct pp_error *err)
{
    *result = NULL;
    if (scene->pane_count == 0 || environment->bright)
        return PP_OK;
    struct pp_opening_store *store = calloc(1, sizeof *store);
    struct pp_sobol *sobol = malloc(sizeof *sobol);
    struct pp_thread_pool *pool = NULL;
    enum pp_status status = store && sobol ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK) {
        pp_sobol_init(sobol);
        store->count = scene->pane_count;
        store->tables = calloc((size_t)store->count, sizeof *store->tables);
        status = store->tables ? PP_OK : pp_fail_memory(err);
    }
    if (status == PP_OK)
        status = lay_out_tables(store, scene, sobol, seed, err);
    if (status == PP_OK)
        status = pp_thread_pool_create(&pool, threads, err);
    if (status == PP_OK) {
        store->samples = samples_of(store);
        fill_all(store, scene, environment, sobol, seed, pool);
    }
    pp_thread_pool_destroy(pool);
    free(sobol);
    if (status != PP_OK) {
        pp_opening_store_destroy(store);
        return status;
    }
    *result = store;
    return PP_OK;
}

void pp_opening_store_destroy(struct pp_opening_store *store)
{
    if (!store)
        return;
    for (int i = 0; store->tables && i < store->count; i++)
        pp_opening_table_clear(&store->tables[i]);
    free(store->tables);
    free(store);
}
