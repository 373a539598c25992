/* opening_light.h - what a place in the room takes by way of its clear panes: light from
 * outside through them, and the room's own that they mirror.
 *
 * A pane is divided until, cell by cell, the closed form factor of the cell times the
 * light along the ray to its middle (light_ray.h) agrees with the sum over its parts: near
 * the pane the form factors, in view of a roof line the light asks for small cells.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_OPENING_LIGHT_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_OPENING_LIGHT_H

#include "simulate/research/radiosity/light_ray.h"
#include "simulate/research/radiosity/element_sight.h"

struct pp_opening_light_accuracy {
    double error;       /* of the light that comes in, relative, per opening's cell */
    double most_factor; /* a cell's form factor is no more */
    int least_depth;    /* divisions of every pane at least */
    double stricter;    /* the tolerance of a part, over its cell's: 0.5 to 1 */
};

/* A place that takes light. */
struct pp_taker {
    struct pp_vec3 point, normal; /* unit */
    int facet;                    /* that it lies on; -1: none */
};

/* Adds to the sum what the taker takes; PP_SC and PP_ERC are straight from outside. */
void pp_opening_light_add(const struct pp_light_room *room,
                          const struct pp_taker *taker,
                          const struct pp_opening_light_accuracy *accuracy,
                          struct pp_light_sum *sum);

#endif
