/* irradiance_cache.c - creates a cache from its options, and reads it. */
#include "simulate/cache/irradiance_cache.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "simulate/cache/cache_parts.h"
#include "simulate/sampling/hash.h"

/* Records of depth 1 may have LIGHTING_ERROR times the error and have
 * LIGHTING_DIVISIONS times fewer rays, since their light is averaged over a hemisphere
 * once more. Chosen by trial. With these and the other settings, the examples' means
 * are within 0.3 % of the tracer's. */
static const double LIGHTING_ERROR = 4.0;
enum { LIGHTING_DIVISIONS = 4, LEAST_SIDE = 4, MOST_SIDE = 1024 };

/* The total error allowed to a record, divided by its value (m2), is the accuracy times
 * the square of this fraction of the scene's size. Chosen by trial. */
static const double ERROR_SPACING = 1.0 / 64.0;

/* Least radius, as a fraction of the scene's size, if the resolution sets no limit. */
static const double LEAST_RADIUS = 1e-5;

/* Standard deviation of the light of one ray of a hemisphere, divided by the mean of
 * all rays. Chosen by trial. */
static const double RAY_NOISE = 0.5;

/* Largest radius, as a fraction of the scene's size. Chosen by trial. */
static const double MOST_RADIUS = 0.125;

struct pp_cache_options pp_irradiance_cache_defaults(void)
{
    return (struct pp_cache_options){.accuracy = 0.1,
                                     .resolution = 128,
                                     .divisions = 1024,
                                     .supersamples = 256,
                                     .bounces = -1};
}

static bool is_material(const struct pp_light_scene *scene, const char *name)
{
    for (int i = 0; i < pp_light_scene_material_count(scene); i++)
        if (strcmp(pp_light_scene_material(scene, i)->name, name) == 0)
            return true;
    return false;
}

enum pp_status pp_irradiance_cache_check_options(const struct pp_cache_options *options,
                                                 const struct pp_light_scene *scene,
                                                 struct pp_error *err)
{
    struct pp_rgb constant = options->constant;
    if (!(options->accuracy > 0.0 && options->accuracy <= 1.0))
        return pp_fail(
            err, PP_BAD_INPUT,
            "the accuracy of the cache is %g; expected more than 0, at most 1",
            options->accuracy);
    if (options->resolution < 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "the resolution of the cache is %d; expected 0 or more",
                       options->resolution);
    if (options->divisions < 16 || options->divisions > MOST_SIDE * MOST_SIDE)
        return pp_fail(err, PP_BAD_INPUT,
                       "the number of divisions for the cache is %d; expected 16 to %d",
                       options->divisions, MOST_SIDE * MOST_SIDE);
    if (options->supersamples < 0 || options->supersamples > MOST_SIDE * MOST_SIDE)
        return pp_fail(err, PP_BAD_INPUT,
                       "the number of supersamples for the cache is %d; expected 0 to "
                       "%d",
                       options->supersamples, MOST_SIDE * MOST_SIDE);
    if (!(constant.r >= 0.0 && constant.g >= 0.0 && constant.b >= 0.0)
        || !isfinite(pp_rgb_luminance(constant)))
        return pp_fail(err, PP_BAD_INPUT,
                       "the ambient constant is %g %g %g; expected 0 or more",
                       constant.r, constant.g, constant.b);
    for (int i = 0; i < options->material_count; i++)
        if (!is_material(scene, options->materials[i]))
            return pp_fail(
                err, PP_BAD_INPUT, "the scene has no material \"%s\" that can be %s",
                options->materials[i], options->only ? "included" : "excluded");
    return PP_OK;
}

/* ---- read ---- */

enum pp_space pp_irradiance_cache_hit_space(const struct pp_irradiance_cache *cache,
                                            const struct pp_light_hit *hit,
                                            struct pp_vec3 normal)
{
    if (pp_vec_dot(normal, hit->normal) > 0.0)
        return hit->space;
    return pp_light_scene_space(cache->scene,
                                pp_vec_along(hit->point, 1e-6 * cache->size_m, normal));
}

bool pp_irradiance_cache_value(const struct pp_irradiance_cache *cache,
                               struct pp_vec3 point, struct pp_vec3 normal,
                               enum pp_space space, int depth, struct pp_rgb *value)
{
    int bounces = cache->options.bounces;
    if (bounces >= 0 && depth >= bounces) {
        *value = pp_rgb_scale(cache->options.constant, PP_PI);
        return true;
    }
    /* With a limited number of bounces the light differs by depth. */
    if (bounces >= 0 && depth >= PP_CACHE_DEPTHS)
        return false;
    int layer = depth < PP_CACHE_DEPTHS ? depth : PP_CACHE_DEPTHS - 1;
    struct pp_cache_place place = {point, normal, space};
    return pp_cache_layer_read(&cache->layers[layer], &place, value);
}

static bool ambient_irradiance(void *store, const struct pp_light_hit *hit,
                               struct pp_vec3 normal, int depth, struct pp_rgb *value)
{
    const struct pp_irradiance_cache *cache = store;
    if (cache->left_out[hit->material]) {
        *value = pp_rgb_scale(cache->options.constant, PP_PI);
        return true;
    }
    return pp_irradiance_cache_value(cache, hit->point, normal,
                                     pp_irradiance_cache_hit_space(cache, hit, normal),
                                     depth, value);
}

/* ---- made ---- */

/* Finds the materials left out of the cache by the options. */
static enum pp_status leave_out(struct pp_irradiance_cache *cache, struct pp_error *err)
{
    const struct pp_cache_options *options = &cache->options;
    int count = pp_light_scene_material_count(cache->scene);
    cache->left_out = calloc((size_t)count + 1, sizeof *cache->left_out);
    if (!cache->left_out)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++) {
        const char *name = pp_light_scene_material(cache->scene, i)->name;
        bool listed = false;
        for (int k = 0; k < options->material_count; k++)
            listed = listed || strcmp(name, options->materials[k]) == 0;
        cache->left_out[i] = options->only ? !listed : listed;
    }
    return PP_OK;
}

static double longest_side(struct pp_bounds3 box)
{
    return fmax(fmax(box.high.x - box.low.x, box.high.y - box.low.y),
                box.high.z - box.low.z);
}

static enum pp_status make_layer(struct pp_irradiance_cache *cache, int depth,
                                 struct pp_vec3 low, double size, struct pp_error *err)
{
    const struct pp_cache_options *options = &cache->options;
    struct pp_cache_layer *layer = &cache->layers[depth];
    double spacing = ERROR_SPACING * cache->size_m;
    int share = depth > 0 ? LIGHTING_DIVISIONS : 1;
    int side = (int)ceil(sqrt((double)options->divisions / share) - 1e-9);
    layer->settings = (struct pp_cache_record_settings){
        .side = side < LEAST_SIDE ? LEAST_SIDE : side,
        .supersamples = options->supersamples / share,
        .error =
            options->accuracy * spacing * spacing * (depth > 0 ? LIGHTING_ERROR : 1.0),
        .least_m = options->resolution > 0
                       ? cache->size_m * options->accuracy / options->resolution
                       : LEAST_RADIUS * cache->size_m,
        .most_m = MOST_RADIUS * cache->size_m};
    layer->settings.noise = RAY_NOISE
                            / sqrt((double)layer->settings.side * layer->settings.side
                                   + layer->settings.supersamples);
    layer->corners = pp_cache_hemisphere_corners(layer->settings.side);
    if (!layer->corners)
        return pp_fail_memory(err);
    layer->settings.corners = layer->corners;
    return pp_cache_octree_init(&layer->tree, low, size, err);
}

static enum pp_status make_irradiance_cache(struct pp_irradiance_cache *cache,
                                            struct pp_error *err)
{
    cache->size_m = longest_side(pp_light_scene_bounds(cache->scene, true));
    if (!(cache->size_m > 0.0))
        cache->size_m = 1.0;
    struct pp_bounds3 all = pp_light_scene_bounds(cache->scene, false);
    double size = fmax(longest_side(all), cache->size_m) * 1.01;
    struct pp_vec3 middle = pp_bounds3_middle(&all);
    struct pp_vec3 low = pp_vec_sub(middle, pp_vec(0.5 * size, 0.5 * size, 0.5 * size));
    pp_sobol_init(&cache->sobol);
    cache->ambient = (struct pp_ambient){ambient_irradiance, cache};
    enum pp_status status = leave_out(cache, err);
    for (int i = 0; status == PP_OK && i < PP_CACHE_DEPTHS; i++)
        status = make_layer(cache, i, low, size, err);
    return status;
}

enum pp_status pp_irradiance_cache_create(struct pp_irradiance_cache **result,
                                          const struct pp_light_scene *scene,
                                          const struct pp_environment *environment,
                                          const struct pp_opening_store *store,
                                          const struct pp_radiance_options *light,
                                          const struct pp_cache_options *options,
                                          struct pp_error *err)
{
    *result = NULL;
    enum pp_status status = pp_irradiance_cache_check_options(options, scene, err);
    if (status != PP_OK)
        return status;
    struct pp_irradiance_cache *cache = calloc(1, sizeof *cache);
    if (!cache)
        return pp_fail_memory(err);
    cache->scene = scene;
    cache->environment = environment;
    cache->store = store;
    cache->light = *light;
    cache->light.bounces = -1;
    cache->options = *options;
    status = pp_thread_pool_create(&cache->pool, options->threads, err);
    if (status == PP_OK)
        status = make_irradiance_cache(cache, err);
    cache->options.materials = NULL; /* owned by the caller; `left_out` holds the
                                      * result */
    if (status != PP_OK) {
        pp_irradiance_cache_destroy(cache);
        return status;
    }
    *result = cache;
    return PP_OK;
}

void pp_irradiance_cache_destroy(struct pp_irradiance_cache *cache)
{
    if (!cache)
        return;
    for (int i = 0; i < PP_CACHE_DEPTHS; i++) {
        struct pp_cache_layer *layer = &cache->layers[i];
        pp_cache_octree_clear(&layer->tree);
        free(layer->corners);
        free(layer->entries);
        free(layer->requests);
        free(layer->open);
    }
    pp_thread_pool_destroy(cache->pool);
    free(cache->left_out);
    free(cache);
}

uint64_t pp_irradiance_cache_hash_options(const struct pp_irradiance_cache *cache)
{
    const struct pp_cache_options *o = &cache->options;
    const struct pp_radiance_options *light = &cache->light;
    uint64_t hash = pp_hash_double(o->seed, o->accuracy);
    const double numbers[] = {o->resolution, o->divisions,        o->supersamples,
                              o->bounces,    o->constant.r,       o->constant.g,
                              o->constant.b, light->sources,      light->windows,
                              light->stored, light->source_size,  light->source_most,
                              light->least,  cache->store != NULL};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        hash = pp_hash_double(hash, numbers[i]);
    for (int i = 0; i < pp_light_scene_material_count(cache->scene); i++)
        hash = pp_hash(hash, cache->left_out[i]);
    return hash;
}

/* ---- reading ---- */

const struct pp_ambient *pp_irradiance_cache_ambient(struct pp_irradiance_cache *cache)
{
    return &cache->ambient;
}

size_t pp_irradiance_cache_count(const struct pp_irradiance_cache *cache)
{
    size_t count = 0;
    for (int i = 0; i < PP_CACHE_DEPTHS; i++)
        count += (size_t)cache->layers[i].entry_count;
    return count;
}

struct pp_cache_record pp_irradiance_cache_record(
    const struct pp_irradiance_cache *cache, size_t index)
{
    int depth = 0;
    for (; index >= (size_t)cache->layers[depth].entry_count; depth++)
        index -= (size_t)cache->layers[depth].entry_count;
    struct pp_cache_record record = cache->layers[depth].entries[index].is;
    record.depth = depth;
    return record;
}
