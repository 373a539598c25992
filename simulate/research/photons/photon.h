/* photon.h - a photon, followed from its start at an opening or a lamp until it is
 * absorbed or lost.
 *
 * A photon carries flux over Eh (m2), divided by the density with which its source,
 * place and direction were drawn, and by the probability of each scattering since then.
 * It may leave the room and come back.
 */
#ifndef PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_H
#define PP_SIMULATE_RESEARCH_PHOTONS_PHOTON_H

#include "simulate/research/photons/photon_lobes.h"
#include "simulate/research/photons/photon_sources.h"

/* Component to which a photon's light belongs. The surface that scattered the photon
 * last determines the component. */
enum pp_photon_last {
    PP_PHOTON_FROM_SKY,
    PP_PHOTON_FROM_OUTSIDE, /* a surface outside, or the ground */
    PP_PHOTON_FROM_INSIDE,
};

/* A place that sends light to receivers. */
struct pp_photon_place {
    struct pp_vec3 point, normal; /* on the side from which light leaves */
    enum pp_space space;          /* space on that side */
    struct pp_rgb exitance; /* flux that leaves diffusely; at clear glass pi divided by
                             * the density of the point */
    int clear;              /* index of a clear pane, whose light depends on direction;
                             * else -1 */
    int source;             /* index of the source if the place is the photon's start;
                             * else -1 */
    enum pp_photon_last last;
};

struct pp_photon {
    struct pp_light_ray ray;
    struct pp_rgb flux;
    enum pp_photon_last last;
    bool scattered;          /* scattered since it left the opening; true for a lamp */
    struct pp_light_hit hit; /* present position */
    struct pp_lobes lobes;   /* lobes at that position */
    int vertex;              /* index of its random numbers */
    int turns;
};

/* Starts a photon at one of the first `count` sources. False if there are none. place:
 * start of the photon, with the exitance for direct light at receivers. vertex: index
 * of the photon's first random numbers. */
bool pp_photon_begin(struct pp_photon_state *state, int count, int vertex,
                     struct pp_photon *photon, struct pp_photon_place *place);

/* Samples a place on an opening. chances: probabilities of the openings for one
 * receiver (photon_sources.h), which must not all be 0. */
void pp_photon_enter(struct pp_photon_state *state, const double *chances, int vertex,
                     struct pp_photon_place *place);

/* Moves the photon to the next surface on its way; false if there is none. */
bool pp_photon_arrive(struct pp_photon_state *state, struct pp_photon *photon);

/* Light that the photon causes at the surface: the flux that leaves diffusely, from the
 * side hit (side 0) or from the opposite side (side 1). False if there is none. */
bool pp_photon_leaves(const struct pp_photon_state *state,
                      const struct pp_photon *photon, int side,
                      struct pp_photon_place *place);

/* Scatters the photon by one of the surface's lobes; false if the photon is
 * absorbed. */
bool pp_photon_turn(struct pp_photon_state *state, struct pp_photon *photon);

#endif
