/* shared_light.c - draws sets of points, each with an estimate of the control variate's
 * residual. */
#include "simulate/fast/shared_light.h"

#include <stdlib.h>

#include "model/base/array.h"
#include "simulate/sampling/hash.h"

enum {
    /* The first FIRST_BLOCK points follow paths to their end. Later points get light of
     * more than one reflection from at most MOST_OTHERS earlier, independent points.
     * Chosen by trial. */
    FIRST_BLOCK = 32,
    MOST_OTHERS = 128,
};

/* The points of one randomisation. */
struct shared_set {
    struct pp_shared_light *list;
    int count, capacity;
    double *net; /* points of the path's cells; NULL: none, or not needed yet */
    long rays, leaks;
};

struct pp_shared_lights {
    struct pp_path_state path;    /* initial state of each thread */
    const struct pp_sobol *sobol; /* not owned */
    uint64_t seed;
    struct shared_set *sets;
    int set_count, set_capacity, stage, first;
    long long rays, leaks; /* work for sets that were discarded */
};

enum pp_status pp_shared_light_create(struct pp_shared_lights **result,
                                      const struct pp_path_state *path,
                                      const struct pp_sobol *sobol, uint64_t seed,
                                      struct pp_error *err)
{
    struct pp_shared_lights *lights = calloc(1, sizeof *lights);
    *result = lights;
    if (!lights)
        return pp_fail_memory(err);
    lights->path = *path;
    lights->sobol = sobol;
    lights->seed = seed;
    lights->stage = -1;
    return PP_OK;
}

static void forget(struct pp_shared_lights *lights)
{
    for (int i = 0; i < lights->set_count; i++) {
        lights->rays += lights->sets[i].rays;
        lights->leaks += lights->sets[i].leaks;
        free(lights->sets[i].list);
        free(lights->sets[i].net);
    }
    lights->set_count = 0;
}

void pp_shared_light_destroy(struct pp_shared_lights *lights)
{
    if (!lights)
        return;
    forget(lights);
    free(lights->sets);
    free(lights);
}

/* Draws a point and calculates its light, using the light of `count` earlier points.
 * The light is 0 if the drawn place is not on the surface. */
static struct pp_shared_light draw_point(struct pp_path_state *state,
                                         const struct pp_shared_light *others,
                                         int count)
{
    double u[3]; /* choice of the patch, and position in it (2) */
    pp_sobol_sequence_draw(&state->light.sequence, state->light.index, 0, 3, u);
    struct pp_shared_place place = pp_shared_density_draw(state->shared, u);
    struct pp_light_hit met;
    if (pp_radiance_state_meet(&state->light, &place.sight, &met) != PP_MEETS_PART
        || met.part != place.part)
        return (struct pp_shared_light){.light = 0.0};
    double light = pp_path_residual(state, &met, others, count);
    return (struct pp_shared_light){met.point, met.normal, place.per_density, light};
}

/* Index of the first point of the block that contains point i. Each block is as long as
 * all earlier blocks together. */
static int block_of(int i)
{
    int block = FIRST_BLOCK;
    while (2 * block <= i)
        block *= 2;
    return i < FIRST_BLOCK ? 0 : block;
}

static void draw_net(struct pp_path_state *state, const struct pp_sobol *sobol,
                     uint64_t seed, double *net)
{
    double u[2];
    pp_sobol_sequence_init(&state->light.sequence, sobol, pp_hash(seed, UINT64_MAX));
    pp_sobol_sequence_draw(&state->light.sequence, 0, 0, 2, u);
    pp_gather_cells_draw(state->cells, &state->light, u, net);
}

/* Task shared by the workers of a pool: number of points that each set needs. */
struct extension {
    const struct pp_shared_lights *lights;
    const uint32_t *wanted;
};

static bool extend(void *data, int worker, int set)
{
    (void)worker;
    const struct extension *to = data;
    const struct pp_shared_lights *lights = to->lights;
    const int count = (int)to->wanted[set];
    struct shared_set *shared = &lights->sets[set];
    struct pp_path_state state = lights->path;
    uint64_t seed = pp_hash(pp_hash(lights->seed, (uint64_t)lights->stage),
                            (uint64_t)(lights->first + set));
    int begun = -1;
    if (shared->count == 0 && shared->net)
        draw_net(&state, lights->sobol, seed, shared->net);
    state.net = shared->net;
    for (int i = shared->count; i < count; i++) {
        int block = block_of(i), others = block < MOST_OTHERS ? block : MOST_OTHERS;
        if (block != begun)
            pp_sobol_sequence_init(&state.light.sequence, lights->sobol,
                                   pp_hash(seed, (uint64_t)block));
        begun = block;
        state.light.index = (uint32_t)(i - block);
        int run = others > 0 ? i % (block / others) : 0;
        shared->list[i] = draw_point(&state, shared->list + run * others, others);
    }
    if (count > shared->count)
        shared->count = count;
    shared->rays += state.light.rays;
    shared->leaks += state.light.leaks;
    return true;
}

static enum pp_status reserve_net(struct shared_set *set,
                                  const struct pp_gather_cells *cells,
                                  struct pp_error *err)
{
    if (!cells || set->net)
        return PP_OK;
    set->net = malloc(pp_gather_cells_size(cells) * sizeof *set->net);
    return set->net ? PP_OK : pp_fail_memory(err);
}

enum pp_status pp_shared_light_extend(struct pp_shared_lights *lights, int stage,
                                      int first, int count, const uint32_t *wanted,
                                      struct pp_thread_pool *pool, struct pp_error *err)
{
    if (stage != lights->stage || first != lights->first)
        forget(lights);
    lights->stage = stage;
    lights->first = first;
    enum pp_status status = pp_array_reserve(&lights->sets, &lights->set_capacity,
                                             count, sizeof *lights->sets, err);
    for (; status == PP_OK && lights->set_count < count; lights->set_count++)
        lights->sets[lights->set_count] = (struct shared_set){.list = NULL};
    for (int i = 0; status == PP_OK && i < count; i++) {
        struct shared_set *set = &lights->sets[i];
        int more = (int)wanted[i] - set->count;
        status = pp_array_reserve(&set->list, &set->capacity, (int)wanted[i],
                                  sizeof *set->list, err);
        if (status == PP_OK && more > 0)
            status = reserve_net(set, lights->path.cells, err);
    }
    if (status != PP_OK)
        return status;
    struct extension extension = {lights, wanted};
    pp_thread_pool_run(pool, 0, count, extend, &extension);
    return PP_OK;
}

const struct pp_shared_light *pp_shared_light_list(
    const struct pp_shared_lights *lights, int randomisation)
{
    return lights->sets[randomisation - lights->first].list;
}

const double *pp_shared_light_net(const struct pp_shared_lights *lights,
                                  int randomisation)
{
    return lights->sets[randomisation - lights->first].net;
}

void pp_shared_light_work(const struct pp_shared_lights *lights, long long *rays,
                          long long *leaks)
{
    *rays = lights->rays;
    *leaks = lights->leaks;
    for (int i = 0; i < lights->set_count; i++) {
        *rays += lights->sets[i].rays;
        *leaks += lights->sets[i].leaks;
    }
}
