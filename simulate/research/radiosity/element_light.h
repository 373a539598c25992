/* element_light.h - what a place in the room takes of the room's elements, by closed form
 * factors.
 *
 * The trees are gone down only as far as it takes: an element stands for all its parts
 * where its form factor times what its radiosity may differ by is below a tolerance, as in
 * hierarchical radiosity [HSA91]. An undivided element above the tolerance is asked to
 * be divided. Where something may stand between, rays to the element's corners and middle
 * tell; a part that is seen in part is divided for this place alone.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_ELEMENT_LIGHT_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_ELEMENT_LIGHT_H

#include "simulate/research/radiosity/opening_light.h"

struct pp_element_light_accuracy {
    double
        tolerance;  /* of illuminance over Eh, for an element to stand for its parts */
    double divided; /* the same, for an undivided one to stay so */
    double
        most_factor; /* of an element that something may hide: larger ones are divided */
    double least_factor; /* smaller ones are seen, or not, by their middle */
};

/* Elements that are to be divided; the caller's to free. */
struct pp_wanted {
    int *list;
    int count, room;
};

void pp_element_light_add(const struct pp_light_room *room,
                          const struct pp_taker *taker,
                          const struct pp_element_light_accuracy *accuracy,
                          struct pp_light_sum *sum, struct pp_wanted *wanted);

#endif
