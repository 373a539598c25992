/* photon_receiver.h - the contribution of a light-emitting place to a receiver: a
 * connection, (1) of photon_sources.h, with a shadow ray.
 *
 * cos cos'/d^2 is clamped to the place's limit. The fraction of light that remains,
 *
 *     w = min(1, limit d^2 / (cos cos'))
 *
 * depends on the two places alone, not on how they were drawn. A ray from the receiver
 * that reaches the same place directly, or through clear glass, gets the fraction 1 - w
 * of the place's light (photon_gather.h), as in [KK06]. The sum of both estimates is
 * unbiased, and both are bounded.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_RECEIVER_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_RECEIVER_H

#include "simulate/research/photons/photon.h"

struct pp_photon_receiver {
    struct pp_vec3 point, normal;
    enum pp_space space;
    const double *chances; /* probability of each opening if drawn for this receiver;
                            * NULL: by power; not owned */
};

/* The limit of cos cos'/d^2 for source `source`, or for a surface (-1). */
double pp_photon_receiver_limit(const struct pp_photon_state *state,
                                const struct pp_photon_receiver *receiver, int source);

/* Irradiance at the receiver; *last: its component. vertex: index of the random numbers
 * for a path outside. */
struct pp_rgb pp_photon_receiver_takes(struct pp_photon_state *state,
                                       const struct pp_photon_receiver *receiver,
                                       const struct pp_photon_place *place, int vertex,
                                       enum pp_photon_last *last);

#endif
