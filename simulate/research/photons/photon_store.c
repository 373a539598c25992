/* photon_store.c - see photon_store.h. */
#include "simulate/research/photons/photon_store.h"

#include <stdlib.h>

#include "model/base/array.h"

/* The photons of one randomisation, with the places of all photons in one array. */
struct photon_set {
    struct pp_photon_place *places;
    int place_count, place_capacity;
    int *ends; /* end index of each photon's places */
    int count, capacity;
    long rays, leaks;
    enum pp_status status; /* PP_OK unless memory is exhausted */
};

struct pp_photon_store {
    struct pp_photon_state state; /* initial state of each thread */
    struct pp_sobol sobol;
    uint64_t seed;
    struct photon_set *sets;
    int set_count, set_capacity, stage, first;
    long long rays, leaks; /* work for sets that were discarded */
};

enum pp_status pp_photon_store_create(struct pp_photon_store **result,
                                      const struct pp_photon_state *state,
                                      uint64_t seed, struct pp_error *err)
{
    struct pp_photon_store *store = calloc(1, sizeof *store);
    *result = store;
    if (!store)
        return pp_fail_memory(err);
    store->state = *state;
    store->seed = seed;
    store->stage = -1;
    pp_sobol_init(&store->sobol);
    return PP_OK;
}

static void forget(struct pp_photon_store *store)
{
    for (int i = 0; i < store->set_count; i++) {
        struct photon_set *set = &store->sets[i];
        store->rays += set->rays;
        store->leaks += set->leaks;
        free(set->places);
        free(set->ends);
    }
    store->set_count = 0;
}

void pp_photon_store_destroy(struct pp_photon_store *store)
{
    if (!store)
        return;
    forget(store);
    free(store->sets);
    free(store);
}

static void keep_photon(struct photon_set *set, const struct pp_photon_place *place)
{
    if (set->status == PP_OK)
        set->status = pp_array_reserve(&set->places, &set->place_capacity,
                                       set->place_count + 1, sizeof *set->places, NULL);
    if (set->status == PP_OK)
        set->places[set->place_count++] = *place;
}

static void follow_photon_set(struct pp_photon_state *state, struct photon_set *set)
{
    struct pp_photon photon;
    struct pp_photon_place place;
    if (!pp_photon_begin(state, state->sources->count, 0, &photon, &place))
        return;
    if (photon.scattered)
        keep_photon(set, &place);
    while (pp_photon_arrive(state, &photon)) {
        for (int side = 0; side < 2; side++)
            if (pp_photon_leaves(state, &photon, side, &place))
                keep_photon(set, &place);
        if (!pp_photon_turn(state, &photon))
            return;
    }
}

/* Task shared by the workers of a pool: number of photons that each set needs. */
struct photon_extension {
    const struct pp_photon_store *store;
    const uint32_t *wanted;
};

static bool extend(void *data, int worker, int index)
{
    (void)worker;
    const struct photon_extension *to = data;
    const struct pp_photon_store *store = to->store;
    struct photon_set *set = &store->sets[index];
    struct pp_photon_state state = store->state;
    uint64_t seed = pp_hash(pp_hash(store->seed, (uint64_t)store->stage),
                            (uint64_t)(store->first + index));
    pp_sobol_sequence_init(&state.sequence, &store->sobol, seed);
    for (; set->count < (int)to->wanted[index]; set->count++) {
        state.index = (uint32_t)set->count;
        follow_photon_set(&state, set);
        set->ends[set->count] = set->place_count;
    }
    set->rays += state.rays;
    set->leaks += state.leaks;
    return true;
}

enum pp_status pp_photon_store_extend(struct pp_photon_store *store, int stage,
                                      int first, int count, const uint32_t *wanted,
                                      struct pp_thread_pool *pool, struct pp_error *err)
{
    if (stage != store->stage || first != store->first)
        forget(store);
    store->stage = stage;
    store->first = first;
    enum pp_status status = pp_array_reserve(&store->sets, &store->set_capacity, count,
                                             sizeof *store->sets, err);
    for (; status == PP_OK && store->set_count < count; store->set_count++)
        store->sets[store->set_count] = (struct photon_set){.status = PP_OK};
    for (int i = 0; status == PP_OK && i < count; i++) {
        struct photon_set *set = &store->sets[i];
        status = pp_array_reserve(&set->ends, &set->capacity, (int)wanted[i],
                                  sizeof *set->ends, err);
    }
    if (status != PP_OK)
        return status;
    struct photon_extension extension = {store, wanted};
    pp_thread_pool_run(pool, 0, count, extend, &extension);
    for (int i = 0; i < count; i++)
        if (store->sets[i].status != PP_OK)
            return pp_fail_memory(err);
    return PP_OK;
}

const struct pp_photon_place *pp_photon_store_places(
    const struct pp_photon_store *store, int randomisation, uint32_t photon, int *count)
{
    const struct photon_set *set = &store->sets[randomisation - store->first];
    int start = photon > 0 ? set->ends[photon - 1] : 0;
    *count = set->ends[photon] - start;
    return *count > 0 ? set->places + start : NULL;
}

void pp_photon_store_work(const struct pp_photon_store *store, long long *rays,
                          long long *leaks)
{
    *rays = store->rays;
    *leaks = store->leaks;
    for (int i = 0; i < store->set_count; i++) {
        *rays += store->sets[i].rays;
        *leaks += store->sets[i].leaks;
    }
}
