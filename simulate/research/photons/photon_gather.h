/* photon_gather.h - the light that connections leave out, by rays from the receiver: what
 * is cut off of near places (photon_receiver.h), and what comes by a mirror, a pane that
 * mirrors, or a gloss.
 *
 * A ray of the receiver's cosine lobe is followed past clear glass, mirrors and glosses
 * to a surface that scatters diffusely. As long as it has come straight, it has 1 - w of
 * the light there, else all. That light is what a photon of its own brings the surface, and
 * what a ray from there finds in its turn; by Russian roulette few come so far.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_GATHER_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_GATHER_H

#include "simulate/research/photons/photon_receiver.h"

/* Adds irradiance at the receiver by one ray, by whose light it is. Where the scene has no
 * room, all that comes there. */
void pp_photon_gather(struct pp_photon_state *state,
                      const struct pp_photon_receiver *receiver, int vertex,
                      double sums[3]);

#endif
