/* element_light.h - light at a place in the room from the room's elements, by form
 * factors in closed form.
 *
 * The trees are descended only as far as needed: an element represents all its parts if
 * its form factor times the possible variation of its radiosity is below a tolerance,
 * as in hierarchical radiosity [HSA91]. An undivided element above a second tolerance
 * is listed for division. Possible obstructions are tested by rays to the element's
 * corners and middle; a partly visible element is divided for this place alone.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_ELEMENT_LIGHT_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_ELEMENT_LIGHT_H

#include "simulate/research/radiosity/opening_light.h"

struct pp_element_light_accuracy {
    double
        tolerance;  /* greatest uncertainty of illuminance over Eh with which an element
                     * represents its parts */
    double divided; /* an undivided element with a greater uncertainty is to be
                     * divided */
    double most_factor; /* greatest form factor of an element that may be partly hidden;
                         * above it, its parts are used */
    double least_factor; /* below this form factor, visibility is only tested at the
                          * middle */
};

/* Elements to divide; freed by the caller. */
struct pp_wanted {
    int *list;
    int count, room;
};

void pp_element_light_add(const struct pp_light_room *room,
                          const struct pp_taker *taker,
                          const struct pp_element_light_accuracy *accuracy,
                          struct pp_light_sum *sum, struct pp_wanted *wanted);

#endif
