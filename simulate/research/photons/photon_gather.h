/* photon_gather.h - rays from the receiver that find the light not covered by
 * connections: the part cut off for near places (photon_receiver.h), and light
 * reflected by a mirror, a mirroring pane or a gloss.
 *
 * A ray of the receiver's cosine lobe is followed past clear glass, mirrors and glosses
 * to a surface that scatters diffusely. If the ray arrived directly, the receiver gets
 * the fraction 1 - w of the surface's light; otherwise all of the light. A photon for
 * this surface alone, and a further ray from the surface, find this light. Russian
 * roulette limits the number of further rays.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_GATHER_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_GATHER_H

#include "simulate/research/photons/photon_receiver.h"

/* Adds the irradiance at the receiver from one ray, by component. If the scene has no
 * room, all light is included. */
void pp_photon_gather(struct pp_photon_state *state,
                      const struct pp_photon_receiver *receiver, int vertex,
                      double sums[3]);

#endif
