/* photon_store.h - the photons of each randomisation, stored as the places that they
 * hit, and shared by all receivers.
 *
 * A photon depends on the room, the light, the seed, the stage, the randomisation and
 * its own number. A receiver's value therefore does not depend on the other receivers.
 * The errors of receivers of one run are correlated.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_STORE_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_STORE_H

#include "model/base/thread_pool.h"
#include "simulate/research/photons/photon.h"

struct pp_photon_store;

/* Makes a store for photons with the scene, light and sources of this state, which must
 * outlive *store. On success the caller owns *store. */
enum pp_status pp_photon_store_create(struct pp_photon_store **store,
                                      const struct pp_photon_state *state,
                                      uint64_t seed, struct pp_error *err);
void pp_photon_store_destroy(struct pp_photon_store *store); /* NULL is allowed */

/* Extends randomisations `first` to first + count - 1 of a stage to `wanted` photons
 * each. Discards photons of other stages, and of calls with another `first`. */
enum pp_status pp_photon_store_extend(struct pp_photon_store *store, int stage,
                                      int first, int count, const uint32_t *wanted,
                                      struct pp_thread_pool *pool,
                                      struct pp_error *err);

/* The places hit by one photon, and their number. They do not include the start of a
 * photon at an opening, since direct light has its own estimator. */
const struct pp_photon_place *pp_photon_store_places(
    const struct pp_photon_store *store, int randomisation, uint32_t photon,
    int *count);

/* Rays traced for photons so far, and the number of these rays that leaked. */
void pp_photon_store_work(const struct pp_photon_store *store, long long *rays,
                          long long *leaks);

#endif
