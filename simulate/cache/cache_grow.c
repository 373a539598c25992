/* cache_grow.c - requests, and records made in batches until all requests are covered.
 *
 * Requests are processed in a scattered order, so that the first records are far apart
 * and later ones lie between them. The requests are divided into chunks. A batch is
 * chosen from those requests of a chunk that no record covers, at places that are not
 * too close together. All records of a batch are calculated from the current cache and
 * entered in order. Then the rest of the chunk is examined again. Records on surfaces
 * that light the visible surfaces come first, then records on the visible surfaces. */
#include "simulate/cache/cache_grow.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/base/clock.h"
#include "simulate/cache/cache_parts.h"
#include "simulate/cache/cache_smooth.h"
#include "simulate/sampling/hash.h"
#include "simulate/sampling/lobe.h"

enum {
    CHUNK = 1 << 16,
    LOOK = 1 << 10,       /* open requests examined at a time, as a batch is chosen */
    RAY_CHUNK = 1 << 12,  /* rays followed at a time, before their requests are
                           * stored */
    MOST_AHEAD = 1 << 20, /* most requests for which memory is reserved before rays are
                           * followed */
    /* Greatest number of rays that search for the surfaces that light the requested
     * places. Light from surfaces that these rays miss is calculated by paths. */
    EXPANSION_RAYS = 8192,
    /* Greatest number of requests by one ray of a picture: at a pane for its frame, on
     * either side, for the mirrored surface, and for the surface behind. */
    RAY_REQUESTS = 6,
};

/* Least distance between two places of a batch, divided by the expected radius. Chosen
 * by trial. */
static const double APART = 0.7;
/* Expected radius where no record is valid yet, over the scene's size; by trial. */
static const double FIRST_GUESS = 1.0 / 32.0;

/* ---- requests ---- */

/* Reserves memory for `count` more requests. */
static enum pp_status reserve(struct pp_cache_layer *layer, int count,
                              struct pp_error *err)
{
    return pp_array_reserve(&layer->requests, &layer->request_capacity,
                            layer->request_count + count, sizeof *layer->requests, err);
}

/* Appends a request; memory must have been reserved. */
static void append_cache_request(struct pp_cache_layer *layer,
                                 const struct pp_cache_place *place)
{
    layer->requests[layer->request_count++] =
        (struct pp_cache_request){.place = *place};
}

/* Removes the old requests before new ones are added, if all old ones are covered. */
static void forget(struct pp_irradiance_cache *cache)
{
    if (!pp_cache_grow_done(cache))
        return;
    for (int i = 0; i < PP_CACHE_DEPTHS; i++)
        cache->layers[i].request_count = cache->layers[i].next = 0;
    cache->expanded = 0;
}

/* Shuffles the requests from index `first`, in the same way each time. */
static void scatter(struct pp_cache_layer *layer, int first)
{
    size_t count = (size_t)(layer->request_count - first);
    struct pp_cache_request *requests = layer->requests + first;
    for (size_t i = count; i > 1; i--) {
        size_t k = (size_t)(pp_hash(i, count) % i);
        struct pp_cache_request swap = requests[i - 1];
        requests[i - 1] = requests[k];
        requests[k] = swap;
    }
}

/* Requests made by one ray. */
struct ray_requests {
    const struct pp_irradiance_cache *cache;
    int depth; /* depth of the requests that are kept */
    int count;
    struct pp_cache_place places[RAY_REQUESTS];
};

static bool record_request(void *store, const struct pp_light_hit *hit,
                           struct pp_vec3 normal, int depth, struct pp_rgb *value)
{
    struct ray_requests *wanted = store;
    *value = pp_rgb_grey(0.0);
    if (depth != wanted->depth || wanted->cache->left_out[hit->material]
        || wanted->count == RAY_REQUESTS)
        return true;
    wanted->places[wanted->count++] = (struct pp_cache_place){
        hit->point, normal, pp_irradiance_cache_hit_space(wanted->cache, hit, normal)};
    return true;
}

static struct pp_radiance_state state_of(const struct pp_irradiance_cache *cache,
                                         uint64_t seed)
{
    struct pp_radiance_state state = {.scene = cache->scene,
                                      .environment = cache->environment,
                                      .options = cache->light,
                                      .store = cache->store};
    pp_sobol_sequence_init(&state.sequence, &cache->sobol, seed);
    return state;
}

/* A chunk of rays that the pool's workers share. */
struct request_rays {
    const struct pp_irradiance_cache *cache;
    pp_cache_ray *ray_of;
    const void *list;
    size_t first; /* number of the chunk's first ray */
    int depth;
    struct ray_requests *requests; /* requests of the chunk's rays */
};

/* Follows a ray without next-event estimation, and stores its requests. */
static bool trace_one(void *data, int worker, int i)
{
    (void)worker;
    const struct request_rays *chunk = data;
    const struct pp_irradiance_cache *cache = chunk->cache;
    struct ray_requests *wanted = &chunk->requests[i];
    size_t number = chunk->first + (size_t)i;
    struct pp_light_ray ray;
    struct pp_ambient ambient = {record_request, wanted};
    struct pp_radiance_state state = state_of(cache, cache->options.seed);
    *wanted = (struct ray_requests){.cache = cache, .depth = chunk->depth};
    state.options.sources = state.options.windows = false;
    state.ambient = &ambient;
    state.index = (uint32_t)number;
    if (!chunk->ray_of(chunk->list, number, &ray))
        return true;
    if (chunk->depth == 0)
        pp_radiance_along(&state, &ray, NULL);
    else
        pp_radiance_indirect(&state, &ray, NULL);
    return true;
}

/* Appends the requests of depth `depth` that rays make, in scattered order. */
static enum pp_status request_along(struct pp_irradiance_cache *cache,
                                    pp_cache_ray *ray_of, const void *list,
                                    size_t count, int depth, struct pp_error *err)
{
    struct pp_cache_layer *layer = &cache->layers[depth];
    int before = layer->request_count;
    /* Reserves memory for one request per ray; most rays make one. */
    enum pp_status status =
        reserve(layer, count < MOST_AHEAD ? (int)count : MOST_AHEAD, err);
    if (status != PP_OK)
        return status;
    struct ray_requests *rays_requests = malloc(RAY_CHUNK * sizeof *rays_requests);
    if (!rays_requests)
        return pp_fail_memory(err);
    for (size_t first = 0; status == PP_OK && first < count; first += RAY_CHUNK) {
        int n = count - first < RAY_CHUNK ? (int)(count - first) : RAY_CHUNK;
        struct request_rays chunk = {cache, ray_of, list, first, depth, rays_requests};
        pp_thread_pool_run_small(cache->pool, 0, n, trace_one, &chunk);
        int wanted = 0;
        for (int i = 0; i < n; i++)
            wanted += rays_requests[i].count;
        status = reserve(layer, wanted, err);
        for (int i = 0; i < n && status == PP_OK; i++)
            for (int k = 0; k < rays_requests[i].count; k++)
                append_cache_request(layer, &rays_requests[i].places[k]);
    }
    free(rays_requests);
    if (status == PP_OK)
        scatter(layer, before);
    return status;
}

enum pp_status pp_cache_grow_request_rays(struct pp_irradiance_cache *cache,
                                          pp_cache_ray *ray_of, const void *list,
                                          size_t count, struct pp_error *err)
{
    if (cache->options.bounces == 0)
        return PP_OK;
    forget(cache);
    return request_along(cache, ray_of, list, count, 0, err);
}

enum pp_status pp_cache_grow_request_point(struct pp_irradiance_cache *cache,
                                           struct pp_vec3 point, struct pp_vec3 normal,
                                           enum pp_space space, struct pp_error *err)
{
    struct pp_cache_place place = {point, normal, space};
    if (cache->options.bounces == 0)
        return PP_OK;
    forget(cache);
    enum pp_status status = reserve(&cache->layers[0], 1, err);
    if (status == PP_OK)
        append_cache_request(&cache->layers[0], &place);
    return status;
}

/* Requests from whose places rays search for the surfaces that light these places. */
struct looked_over {
    const struct pp_irradiance_cache *cache;
    const struct pp_cache_request *requests;
    size_t count;
};

static bool ray_about(const void *list, size_t number, struct pp_light_ray *ray)
{
    const struct looked_over *over = list;
    const struct pp_cache_place *place = &over->requests[number % over->count].place;
    struct pp_sobol_sequence sequence;
    struct pp_vec3 a, b;
    double u[2];
    pp_sobol_sequence_init(&sequence, &over->cache->sobol, over->cache->options.seed);
    pp_sobol_sequence_draw(&sequence, (uint32_t)number, 0, 2, u);
    pp_lobe_frame(place->normal, &a, &b);
    *ray = (struct pp_light_ray){
        place->point, place->normal,
        pp_lobe_sample_in_frame(a, b, place->normal, u[0], u[1]), place->space};
    return true;
}

enum pp_status pp_cache_grow_request_hemisphere(struct pp_irradiance_cache *cache,
                                                struct pp_vec3 point,
                                                struct pp_vec3 normal,
                                                enum pp_space space,
                                                struct pp_error *err)
{
    enum { RAYS = 256 };
    struct pp_cache_request request = {.place = {point, normal, space}};
    struct looked_over over = {cache, &request, 1};
    if (cache->options.bounces >= 0 && cache->options.bounces < 2)
        return PP_OK;
    forget(cache);
    return request_along(cache, ray_about, &over, RAYS, 1, err);
}

/* Creates requests of depth 1 on the surfaces that light new requests of depth 0. */
static enum pp_status expand(struct pp_irradiance_cache *cache, struct pp_error *err)
{
    const struct pp_cache_layer *seen = &cache->layers[0];
    size_t new = (size_t)(seen->request_count - cache->expanded);
    size_t left = (size_t)(EXPANSION_RAYS - cache->expanded_rays);
    size_t count = 8 * new < left ? 8 * new : left;
    size_t begin = (size_t)cache->expanded;
    cache->expanded = seen->request_count;
    cache->expanded_rays += (int)count;
    if (count == 0 || (cache->options.bounces >= 0 && cache->options.bounces < 2))
        return PP_OK;
    struct looked_over over = {cache, seen->requests + begin, new};
    return request_along(cache, ray_about, &over, count, 1, err);
}

/* ---- growing ---- */

/* The record being calculated, for the cache look-ups by the rays of its hemisphere. */
struct asking_record {
    struct pp_irradiance_cache *cache;
    int depth; /* depth of the record */
};

static bool ask_from_record(void *store, const struct pp_light_hit *hit,
                            struct pp_vec3 normal, int depth, struct pp_rgb *value)
{
    const struct asking_record *from = store;
    struct pp_irradiance_cache *cache = from->cache;
    int at = from->depth + depth, bounces = cache->options.bounces;
    /* Records of depth 1 do not use the cache: their paths are traced to the end,
     * without bias. */
    if (from->depth > 0 && !cache->left_out[hit->material]
        && (bounces < 0 || at < bounces))
        return false;
    return cache->ambient.irradiance(cache, hit, normal, at, value);
}

static uint64_t cache_place_seed(const struct pp_irradiance_cache *cache,
                                 const struct pp_cache_place *place, int depth)
{
    uint64_t seed = pp_hash(cache->options.seed, (uint64_t)depth);
    return pp_hash_vec(pp_hash_vec(seed, place->point), place->normal);
}

/* Expected radius (m) of a record at a place; below 0 if records cover the place. */
static double guess_of(const struct pp_irradiance_cache *cache,
                       const struct pp_cache_layer *layer,
                       const struct pp_cache_place *place)
{
    if (pp_cache_layer_covers(layer, place))
        return -1.0;
    double guess = pp_cache_layer_guess(layer, place);
    return guess > 0.0 ? guess : FIRST_GUESS * cache->size_m;
}

/* Requests of a chunk, all or only the open ones, which the pool's workers examine. */
struct look {
    const struct pp_irradiance_cache *cache;
    struct pp_cache_layer *layer;
};

static bool look_at(void *data, int worker, int i)
{
    (void)worker;
    const struct look *look = data;
    struct pp_cache_request *request = &look->layer->requests[look->layer->next + i];
    request->guess_m = (float)guess_of(look->cache, look->layer, &request->place);
    return true;
}

static bool look_at_open(void *data, int worker, int i)
{
    const struct look *look = data;
    return look_at(data, worker, look->layer->open[i]);
}

/* Lists the open requests of the chunk, in their order. */
static void find_open(struct pp_irradiance_cache *cache, struct pp_cache_layer *layer,
                      int count)
{
    struct look look = {cache, layer};
    layer->open_count = 0;
    pp_thread_pool_run_small(cache->pool, 0, count, look_at, &look);
    for (int i = 0; i < count; i++)
        if (layer->requests[layer->next + i].guess_m >= 0.0f)
            layer->open[layer->open_count++] = i;
}

static bool stands_apart(const struct pp_cache_request *request,
                         const struct pp_cache_request *const chosen[], int count)
{
    for (int k = 0; k < count; k++)
        if (pp_vec_dot(request->place.normal, chosen[k]->place.normal) >= 0.5
            && pp_vec_length(pp_vec_sub(request->place.point, chosen[k]->place.point))
                   <= APART * fmin(request->guess_m, chosen[k]->guess_m))
            return false;
    return true;
}

/* Chooses the first open requests that are far enough apart, and removes requests from
 * the list that are covered by now. Examines the list in parts, only as far as the
 * batch needs. */
static int choose_open_requests(struct pp_irradiance_cache *cache,
                                struct pp_cache_layer *layer,
                                const struct pp_cache_request *chosen[])
{
    struct look look = {cache, layer};
    int count = 0, kept = 0, i = 0, looked = 0;
    for (; i < layer->open_count && count < PP_CACHE_BATCH; i++) {
        if (i == looked) {
            int end = i + LOOK < layer->open_count ? i + LOOK : layer->open_count;
            looked = pp_thread_pool_run_small(cache->pool, i, end, look_at_open, &look);
        }
        const struct pp_cache_request *request =
            &layer->requests[layer->next + layer->open[i]];
        if (request->guess_m < 0.0f)
            continue;
        if (stands_apart(request, chosen, count))
            chosen[count++] = request;
        layer->open[kept++] = layer->open[i];
    }
    for (; i < layer->open_count; i++)
        layer->open[kept++] = layer->open[i];
    layer->open_count = kept;
    return count;
}

/* The records of a batch, calculated by the pool's workers. */
struct batch_records {
    struct pp_irradiance_cache *cache;
    int depth;
    const struct pp_cache_request *const *chosen;
    struct pp_cache_hemisphere_cell *cells; /* cells of a hemisphere for each worker */
    struct pp_cache_entry *entries;
};

static bool compute_one(void *data, int worker, int i)
{
    const struct batch_records *records = data;
    struct pp_irradiance_cache *cache = records->cache;
    int depth = records->depth;
    const struct pp_cache_record_settings *settings = &cache->layers[depth].settings;
    const struct pp_cache_place *place = &records->chosen[i]->place;
    struct asking_record from = {cache, depth};
    struct pp_ambient ambient = {ask_from_record, &from};
    struct pp_radiance_state state =
        state_of(cache, cache_place_seed(cache, place, depth));
    state.ambient = &ambient;
    size_t cells = (size_t)settings->side * (size_t)settings->side;
    pp_cache_record_compute(settings, &state, place,
                            records->cells + (size_t)worker * cells,
                            &records->entries[i]);
    records->entries[i].is.depth = depth;
    return true;
}

/* Calculates and adds a batch of records for open requests. */
static enum pp_status batch(struct pp_irradiance_cache *cache, int depth,
                            struct pp_error *err)
{
    struct pp_cache_layer *layer = &cache->layers[depth];
    const struct pp_cache_request *chosen[PP_CACHE_BATCH];
    int count = choose_open_requests(cache, layer, chosen);
    if (count == 0)
        return PP_OK;
    size_t side = (size_t)layer->settings.side;
    struct pp_cache_hemisphere_cell *cells =
        malloc((size_t)pp_thread_pool_size(cache->pool) * side * side * sizeof *cells);
    struct pp_cache_entry *entries = calloc(PP_CACHE_BATCH, sizeof *entries);
    enum pp_status status = cells && entries ? PP_OK : pp_fail_memory(err);
    struct batch_records records = {cache, depth, chosen, cells, entries};
    if (status == PP_OK)
        pp_thread_pool_run(cache->pool, 0, count, compute_one, &records);
    for (int i = 0; status == PP_OK && i < count; i++)
        status = pp_cache_layer_add(layer, &entries[i], err);
    layer->again = true;
    free(entries);
    free(cells);
    return status;
}

/* Depth of the next requests to process; -1: all are covered. */
static int depth_at_work(const struct pp_irradiance_cache *cache)
{
    for (int depth = PP_CACHE_DEPTHS - 1; depth >= 0; depth--)
        if (cache->layers[depth].next < cache->layers[depth].request_count)
            return depth;
    return -1;
}

/* One step of the growth: adds a batch of records, or examines the next chunk of
 * requests. */
static enum pp_status step(struct pp_irradiance_cache *cache, struct pp_error *err)
{
    int depth = depth_at_work(cache);
    struct pp_cache_layer *layer = &cache->layers[depth];
    if (!layer->open) {
        layer->open = malloc(CHUNK * sizeof *layer->open);
        if (!layer->open)
            return pp_fail_memory(err);
    }
    int left = layer->request_count - layer->next;
    int chunk = left < CHUNK ? left : CHUNK;
    if (layer->open_count == 0) {
        find_open(cache, layer, chunk);
    } else {
        enum pp_status status = batch(cache, depth, err);
        if (status != PP_OK)
            return status;
    }
    if (layer->open_count > 0)
        return PP_OK;
    layer->next += chunk;
    if (layer->next < layer->request_count)
        return PP_OK;
    if (!layer->again)
        return pp_cache_smooth_layer(layer, cache->pool, err);
    /* New records have reduced the radii of their neighbours, so requests may no longer
     * be covered. The repetition ends, since each request can get a record of its
     * own. */
    layer->again = false;
    layer->next = 0;
    return pp_cache_layer_rebuild_tree(layer, err);
}

enum pp_status pp_cache_grow(struct pp_irradiance_cache *cache, double seconds,
                             struct pp_error *err)
{
    double end = pp_clock_s() + seconds;
    enum pp_status status = PP_OK;
    if (cache->expanded < cache->layers[0].request_count)
        status = expand(cache, err);
    while (status == PP_OK && !pp_cache_grow_done(cache)) {
        status = step(cache, err);
        if (pp_clock_s() >= end)
            break;
    }
    return status;
}

bool pp_cache_grow_done(const struct pp_irradiance_cache *cache)
{
    return cache->expanded == cache->layers[0].request_count
           && depth_at_work(cache) < 0;
}

double pp_cache_grow_progress(const struct pp_irradiance_cache *cache)
{
    /* The first requests lead to most of the records, so progress is not linear. */
    double done = 0.0, all = 0.0;
    for (int i = 0; i < PP_CACHE_DEPTHS; i++) {
        done += sqrt((double)cache->layers[i].next);
        all += sqrt((double)cache->layers[i].request_count);
    }
    return all > 0.0 ? done / all : 1.0;
}
