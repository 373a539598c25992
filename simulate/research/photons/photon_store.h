/* photon_store.h - the photons of each randomisation, which all receivers share: the
 * places that they come to.
 *
 * A photon depends on the room, the light, the seed, the stage, the randomisation and its
 * own number, so that a receiver's value does not depend on which others there are;
 * receivers of one run go wrong together.
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

/* Randomisations `first` to first + count - 1 of a stage get as many photons as `wanted`
 * says; those of other stages, or from another `first`, are forgotten. */
enum pp_status pp_photon_store_extend(struct pp_photon_store *store, int stage,
                                      int first, int count, const uint32_t *wanted,
                                      struct pp_thread_pool *pool,
                                      struct pp_error *err);

/* The places of one of these photons but for what openings send straight, and how
 * many. */
const struct pp_photon_place *pp_photon_store_places(
    const struct pp_photon_store *store, int randomisation, uint32_t photon,
    int *count);

/* Rays traced for photons so far, and leaks among them. */
void pp_photon_store_work(const struct pp_photon_store *store, long long *rays,
                          long long *leaks);

#endif
