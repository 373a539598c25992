/* photon_store.h - the photons of each randomisation, stored as the places that they
 * hit, and shared by all receivers.
 *
 * A photon depends on the room, the light, the seed, the stage, the randomisation and
 * its own number, so that a receiver's value does not depend on the other receivers;
 * the errors of receivers of one run are correlated.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_STORE_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_STORE_H

#include "model/base/thread_pool.h"
#include "simulate/research/photons/photon.h"

struct pp_photon_store;

/* Makes a store for photons that follow this state. Its scene, light and sources must
 * outlive *store. On success *store is the caller's. */
enum pp_status pp_photon_store_create(struct pp_photon_store **store,
                                      const struct pp_photon_state *state,
                                      uint64_t seed, struct pp_error *err);
void pp_photon_store_destroy(struct pp_photon_store *store); /* NULL is allowed */

/* Extends randomisations `first` to first + count - 1 of a stage to `wanted` photons
 * each; photons of other stages, or of calls with another `first`, are discarded. */
enum pp_status pp_photon_store_extend(struct pp_photon_store *store, int stage,
                                      int first, int count, const uint32_t *wanted,
                                      struct pp_thread_pool *pool,
                                      struct pp_error *err);

/* The places hit by one photon, and their number. The start of a photon at an opening
 * is not one of them, since direct light has its own estimator. */
const struct pp_photon_place *pp_photon_store_places(
    const struct pp_photon_store *store, int randomisation, uint32_t photon,
    int *count);

/* Rays traced for photons so far, and leaks among them. */
void pp_photon_store_work(const struct pp_photon_store *store, long long *rays,
                          long long *leaks);

#endif
