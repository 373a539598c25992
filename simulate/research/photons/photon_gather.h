/* photon_gather.h - rays from the receiver that find the light not covered by
 * connections: the part cut off for near places (photon_receiver.h), and light
 * reflected by a mirror, a mirroring pane or a gloss.
 *
 * A ray of the receiver's cosine lobe is followed past clear glass, mirrors and glosses
 * to a surface that scatters diffusely. If the ray arrived there directly, the receiver
 * gets the share 1 - w of that surface's light; otherwise all of it. The surface's
 * light is found by a photon for this surface alone, and by a further ray from there.
 * Russian roulette limits the number of further rays.
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
