/* photon.h - a photon followed from where it enters the room, or from a lamp, to where
 * it is absorbed or lost.
 *
 * It carries flux over Eh (m2), divided by the density with which its source, place and
 * direction were drawn and by the probability of each scattering since. It may leave
 * the room and come back.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_H

#include "simulate/research/photons/photon_lobes.h"
#include "simulate/research/photons/photon_sources.h"

/* Component to which a photon's light belongs, by the last surface that scattered
 * it. */
enum pp_photon_last {
    PP_PHOTON_FROM_SKY,
    PP_PHOTON_FROM_OUTSIDE, /* a surface there, or the ground */
    PP_PHOTON_FROM_INSIDE,
};

/* A place from which light goes to receivers. */
struct pp_photon_place {
    struct pp_vec3 point, normal; /* of the side that it leaves */
    enum pp_space space;          /* on that side */
    struct pp_rgb exitance; /* flux that leaves diffusely, or at clear glass 1 over
                                   * the density of the point times pi */
    int clear;              /* the pane, where the light hangs on the direction; -1 */
    int source;             /* of a photon's first place; -1: any other place */
    enum pp_photon_last last;
};

struct pp_photon {
    struct pp_light_ray ray;
    struct pp_rgb flux;
    enum pp_photon_last last;
    bool scattered;          /* scattered at least once since it left the opening */
    struct pp_light_hit hit; /* its present position */
    struct pp_lobes lobes;   /* there */
    int vertex;              /* of its random numbers */
    int turns;
};

/* Begins a photon on its ray, from one of the first `count` sources. False if there are
 * none. place: its start, whose exitance is that of direct light to receivers. vertex:
 * the first of its random numbers. */
bool pp_photon_begin(struct pp_photon_state *state, int count, int vertex,
                     struct pp_photon *photon, struct pp_photon_place *place);

/* A place on an opening, drawn by a receiver's own chances (photon_sources.h), not all
 * 0. */
void pp_photon_enter(struct pp_photon_state *state, const double *chances, int vertex,
                     struct pp_photon_place *place);

/* Moves the photon to the next surface that it meets; false: none. */
bool pp_photon_arrive(struct pp_photon_state *state, struct pp_photon *photon);

/* Power left there by the photon: the light that leaves its own side (0) or the far one
 * (1) diffusely. False where that is none. */
bool pp_photon_leaves(const struct pp_photon_state *state,
                      const struct pp_photon *photon, int side,
                      struct pp_photon_place *place);

/* Scatters the photon by one of the surface's lobes; false if it is absorbed. */
bool pp_photon_turn(struct pp_photon_state *state, struct pp_photon *photon);

#endif
