/* photon_gather.h - the light not covered by connections, by rays from the receiver:
 * the part cut off for near places (photon_receiver.h), and light by a mirror, a
 * mirroring pane, or a gloss.
 *
 * A ray of the receiver's cosine lobe is followed past clear glass, mirrors and glosses
 * to a surface that scatters diffusely. It gets 1 - w of the light there if it arrived
 * directly, else all. That light is found by a photon for this surface alone, and by a
 * further ray from there; Russian roulette leaves few of these.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_GATHER_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_GATHER_H

#include "simulate/research/photons/photon_receiver.h"

/* Adds the irradiance at the receiver by one ray, by component. Without a room in the
 * scene it adds all light there. */
void pp_photon_gather(struct pp_photon_state *state,
                      const struct pp_photon_receiver *receiver, int vertex,
                      double sums[3]);

#endif
