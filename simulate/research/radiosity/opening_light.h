/* opening_light.h - the light that a place in the room receives through clear panes,
 * and the room's own light mirrored in them.
 *
 * A pane is divided into cells. The light of a cell is its form factor (in closed form)
 * times the light along the ray to its middle (light_ray.h). A cell is divided until
 * its light agrees with the sum over its parts. Small cells are needed near the pane,
 * where form factors vary, and at a roof line, where the light varies.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_OPENING_LIGHT_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_OPENING_LIGHT_H

#include "simulate/research/radiosity/light_ray.h"
#include "simulate/research/radiosity/element_sight.h"

struct pp_opening_light_accuracy {
    double error;       /* relative error of light through openings, per cell */
    double most_factor; /* greatest form factor of a cell */
    int least_depth;    /* least number of divisions of every pane */
    double stricter;    /* tolerance of a part divided by that of its cell: 0.5 to 1 */
};

/* A place that receives light. */
struct pp_taker {
    struct pp_vec3 point, normal; /* unit */
    int facet;                    /* index of the facet of the place; -1: none */
};

/* Adds the light received by the taker to the sum. PP_SC and PP_ERC are light directly
 * from outside. */
void pp_opening_light_add(const struct pp_light_room *room,
                          const struct pp_taker *taker,
                          const struct pp_opening_light_accuracy *accuracy,
                          struct pp_light_sum *sum);

#endif
