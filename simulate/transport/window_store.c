/* window_store.c - see window_store.h. */
#include "simulate/transport/window_store.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/sampling/hash.h"
#include "simulate/sampling/lobe.h"
#include "simulate/sampling/processors.h"

enum {
    BINS = 12,          /* of directions, along either axis of the opening */
    PATHS = 1 << 19,    /* for all bins of all patches, half a microsecond each */
    LEAST_SAMPLES = 16, /* of each bin, however many there are */
    MOST_PATCHES = 6,   /* along either axis */
    PROBES = 256,       /* rays that see how near things stand */
};

/* A patch is no larger than this share of the distance of what is stored. */
static const double PATCH_SIZE = 0.5;

/* One opening's. */
struct window_light {
    int columns, rows;
    double far_m;            /* what is nearer is not stored */
    struct pp_rgb *radiance; /* by patch and bin; NULL: nothing stands outside */
};

struct pp_window_store {
    struct window_light *windows;
    int count;
    uint32_t samples; /* paths of each bin */
};

static const struct pp_target *target_of(const struct pp_light_scene *scene, int window)
{
    return &scene->room->panes[window].target;
}

/* A point of a patch by two numbers in (0, 1). */
static struct pp_vec3 patch_point(const struct pp_target *target,
                                  const struct window_light *light, int patch, double u,
                                  double v)
{
    double x = (patch % light->columns + u) / light->columns * target->width_m;
    double y = (patch / light->columns + v) / light->rows * target->height_m;
    return pp_vec_along(pp_vec_along(target->corner, x, target->along), y, target->up);
}

static int kept_within(double x, int count)
{
    int i = (int)x;
    return i < 0 || !(x > 0.0) ? 0 : i < count ? i : count - 1;
}

static int patch_at(const struct pp_target *target, const struct window_light *light,
                    struct pp_vec3 point)
{
    struct pp_vec3 from = pp_vec_sub(point, target->corner);
    int column =
        kept_within(pp_vec_dot(from, target->along) / target->width_m * light->columns,
                    light->columns);
    int row = kept_within(pp_vec_dot(from, target->up) / target->height_m * light->rows,
                          light->rows);
    return row * light->columns + column;
}

/* Bins are squares of the direction's parts along the opening's axes. */
static int bin_of(const struct pp_target *target, struct pp_vec3 to)
{
    int column = kept_within((pp_vec_dot(to, target->along) + 1.0) / 2.0 * BINS, BINS);
    int row = kept_within((pp_vec_dot(to, target->up) + 1.0) / 2.0 * BINS, BINS);
    return row * BINS + column;
}

/* A direction of the bin; false where that would be beyond the horizon. */
static bool bin_direction(const struct pp_target *target, int bin, double u, double v,
                          struct pp_vec3 *to)
{
    double x = (bin % BINS + u) / BINS * 2.0 - 1.0;
    double y = (bin / BINS + v) / BINS * 2.0 - 1.0;
    double z2 = 1.0 - x * x - y * y;
    if (!(z2 > 0.0))
        return false;
    *to = pp_vec_along(
        pp_vec_along(pp_vec_scale(target->normal, -sqrt(z2)), x, target->along), y,
        target->up);
    return true;
}

/* ---- worked out ---- */

/* The distance of what stands nearest; INFINITY where nothing is met. */
static double nearest(const struct pp_light_scene *scene, int window,
                      const struct pp_sobol *sobol, uint64_t seed)
{
    const struct pp_target *target = target_of(scene, window);
    const struct window_light whole = {.columns = 1, .rows = 1};
    struct pp_vec3 out = pp_vec_scale(target->normal, -1.0), a, b;
    struct pp_sobol_sequence sequence;
    double least = INFINITY;
    pp_sobol_sequence_init(&sequence, sobol, seed);
    pp_lobe_frame(out, &a, &b);
    for (uint32_t i = 0; i < PROBES; i++) {
        double u[4];
        struct pp_light_hit hit;
        pp_sobol_sequence_draw(&sequence, i, 0, 4, u);
        struct pp_light_ray ray = {patch_point(target, &whole, 0, u[0], u[1]), out,
                                   pp_lobe_sample_in_frame(a, b, out, u[2], u[3]),
                                   PP_OUTDOORS};
        if (pp_light_scene_meet(scene, &ray, &hit) == PP_MEETS_PART)
            least = fmin(least, hit.distance_m);
    }
    return least;
}

static int patches_along(double length_m, double near_m)
{
    double count = ceil(length_m / (PATCH_SIZE * near_m));
    return count < 1.0 ? 1 : count > MOST_PATCHES ? MOST_PATCHES : (int)count;
}

static enum pp_status lay_out(struct window_light *light,
                              const struct pp_light_scene *scene, int window,
                              const struct pp_sobol *sobol, uint64_t seed,
                              struct pp_error *err)
{
    const struct pp_pane *pane = &scene->room->panes[window];
    double near = pane->unobstructed ? INFINITY : nearest(scene, window, sobol, seed);
    light->columns = patches_along(pane->target.width_m, near);
    light->rows = patches_along(pane->target.height_m, near);
    if (!isfinite(near))
        return PP_OK;
    size_t patches = (size_t)light->columns * (size_t)light->rows;
    light->far_m =
        fmax(pane->target.width_m / light->columns, pane->target.height_m / light->rows)
        / PATCH_SIZE;
    light->radiance = calloc(patches * BINS * BINS, sizeof *light->radiance);
    return light->radiance ? PP_OK : pp_fail_memory(err);
}

/* Mean radiance of what is met in each bin; where nothing is, of what is met at all. */
static void fill_radiance(struct window_light *light, struct pp_radiance_state *state,
                          int window, int patch, uint32_t samples)
{
    const struct pp_target *target = target_of(state->scene, window);
    struct pp_rgb *bins = &light->radiance[(size_t)patch * BINS * BINS];
    int met[BINS * BINS] = {0}, all = 0;
    struct pp_rgb sum = pp_rgb_grey(0.0);
    for (int bin = 0; bin < BINS * BINS; bin++) {
        for (uint32_t i = 0; i < samples; i++) {
            double u[4], distance;
            struct pp_light_ray ray = {.off = pp_vec_scale(target->normal, -1.0),
                                       .space = PP_OUTDOORS};
            struct pp_rgb radiance;
            state->index = (uint32_t)bin * samples + i;
            pp_sobol_sequence_draw(&state->sequence, state->index, 0, 4, u);
            ray.from = patch_point(target, light, patch, u[0], u[1]);
            if (!bin_direction(target, bin, u[2], u[3], &ray.to)
                || !pp_light_windows_outside_radiance(state, &ray, &radiance, &distance)
                || distance < light->far_m)
                continue;
            bins[bin] = pp_rgb_add(bins[bin], radiance);
            met[bin]++;
        }
        sum = pp_rgb_add(sum, bins[bin]);
        all += met[bin];
    }
    for (int bin = 0; bin < BINS * BINS; bin++) {
        struct pp_rgb value = met[bin] > 0 ? bins[bin] : sum;
        int count = met[bin] > 0 ? met[bin] : all > 0 ? all : 1;
        bins[bin] = pp_rgb_scale(value, 1.0 / count);
    }
}

static void fill(struct pp_window_store *store, const struct pp_light_scene *scene,
                 const struct pp_sobol *sobol, uint64_t seed, int window, int patch)
{
    struct window_light *light = &store->windows[window];
    struct pp_radiance_state state = {.scene = scene,
                                      .options = pp_radiance_defaults()};
    pp_sobol_sequence_init(&state.sequence, sobol,
                           pp_hash(pp_hash(seed, (uint64_t)window), (uint64_t)patch));
    fill_radiance(light, &state, window, patch, store->samples);
}

/* As many paths for few large patches as for many small ones. */
static uint32_t samples_of(const struct pp_window_store *store)
{
    long bins = 1;
    for (int i = 0; i < store->count; i++)
        if (store->windows[i].radiance)
            bins +=
                (long)store->windows[i].columns * store->windows[i].rows * BINS * BINS;
    long samples = PATHS / bins;
    return samples > LEAST_SAMPLES ? (uint32_t)samples : LEAST_SAMPLES;
}

static void fill_all(struct pp_window_store *store, const struct pp_light_scene *scene,
                     const struct pp_sobol *sobol, uint64_t seed, int threads)
{
    (void)threads;
    for (int i = 0; i < store->count; i++) {
        struct window_light *light = &store->windows[i];
        int patches = light->radiance ? light->columns * light->rows : 0;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
        for (int k = 0; k < patches; k++)
            fill(store, scene, sobol, seed, i, k);
    }
}

enum pp_status pp_window_store_create(struct pp_window_store **result,
                                      const struct pp_light_scene *scene, uint64_t seed,
                                      int threads, struct pp_error *err)
{
    *result = NULL;
    if (!scene->room || scene->room->pane_count == 0)
        return PP_OK;
    if (threads <= 0)
        threads = pp_processors();
    struct pp_window_store *store = calloc(1, sizeof *store);
    struct pp_sobol *sobol = malloc(sizeof *sobol);
    enum pp_status status = store && sobol ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK) {
        pp_sobol_init(sobol);
        store->count = scene->room->pane_count;
        store->windows = calloc((size_t)store->count, sizeof *store->windows);
        status = store->windows ? PP_OK : pp_fail_memory(err);
    }
    for (int i = 0; status == PP_OK && i < store->count; i++)
        status = lay_out(&store->windows[i], scene, i, sobol,
                         pp_hash(seed, (uint64_t)-1 - (uint64_t)i), err);
    if (status == PP_OK) {
        store->samples = samples_of(store);
        fill_all(store, scene, sobol, seed, threads);
    }
    free(sobol);
    if (status != PP_OK) {
        pp_window_store_destroy(store);
        return status;
    }
    *result = store;
    return PP_OK;
}

void pp_window_store_destroy(struct pp_window_store *store)
{
    if (!store)
        return;
    for (int i = 0; store->windows && i < store->count; i++) {
        free(store->windows[i].radiance);
    }
    free(store->windows);
    free(store);
}

/* ---- asked ---- */

bool pp_window_store_radiance(const struct pp_window_store *store,
                              const struct pp_light_scene *scene, int window,
                              struct pp_vec3 point, struct pp_vec3 to,
                              double distance_m, struct pp_rgb *radiance)
{
    const struct window_light *light = &store->windows[window];
    if (!light->radiance || distance_m < light->far_m)
        return false;
    const struct pp_target *target = target_of(scene, window);
    *radiance = light->radiance[(size_t)patch_at(target, light, point) * BINS * BINS
                                + (size_t)bin_of(target, to)];
    return true;
}
