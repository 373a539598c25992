/* element_sight.h - do two places in the room see each other?
 *
 * Most pairs do, and most facets cannot stand between a given two: one can't if some plane
 * has both of them on its one side and the facet on the other. That is known from signs
 * worked out beforehand; only the few facets that are left are looked at, one crossing
 * each.
 */
#ifndef PP_SIMULATE_ELEMENTS_ELEMENT_SIGHT_H
#define PP_SIMULATE_ELEMENTS_ELEMENT_SIGHT_H

#include <stdint.h>

#include "simulate/elements/facets.h"

struct pp_element_sight {
    const struct pp_facets *facets; /* not owned */
    int *inside;                    /* the facets with a side in the room */
    int count;
    bool all_seen; /* the room is convex: nothing in it hides anything */
    uint64_t *above,
        *below; /* of each of these: the planes (of the first of them) that it
                              * is wholly above or below; one that it lies in, both */
};

enum pp_status pp_element_sight_create(struct pp_element_sight **sight,
                                       const struct pp_facets *facets,
                                       struct pp_error *err);
void pp_element_sight_destroy(struct pp_element_sight *sight); /* NULL is allowed */

/* A place to look from. */
struct pp_element_sight_place {
    struct pp_vec3 point;
    uint64_t above, below;
};

struct pp_element_sight_place pp_element_sight_from(
    const struct pp_element_sight *sight, struct pp_vec3 point);

/* The facets that may stand between the place and inside[target], into blockers[], which
 * has room for as many as there are inside; returns how many. */
int pp_element_sight_blockers(const struct pp_element_sight *sight,
                              const struct pp_element_sight_place *from, int target,
                              int *blockers);

/* Is none of the blockers between a and b? */
bool pp_element_sight_is_clear(const struct pp_element_sight *sight,
                               const int *blockers, int count, struct pp_vec3 a,
                               struct pp_vec3 b);

#endif
