/* element_sight.h - do two places in the room see each other?
 *
 * Most pairs do, and most facets cannot stand between a given two: one can't if some plane
 * has both of them on its one side and the facet on the other. That is known from signs
 * worked out beforehand; only the few facets that are left are looked at, one crossing
 * each.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_ELEMENT_SIGHT_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_ELEMENT_SIGHT_H

#include <stdint.h>

#include "simulate/research/radiosity/facets.h"

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

/* A place to look from, at one facet after another. */
struct pp_element_view {
    const struct pp_element_sight *sight; /* not owned */
    struct pp_vec3 point;
    uint64_t above, below; /* the planes that it is above or below */
    int *blockers; /* the facets that may stand between it and the one looked at */
    int blocker_count;
};

/* False: no memory. */
bool pp_element_sight_view_init(struct pp_element_view *view,
                                const struct pp_element_sight *sight,
                                struct pp_vec3 point);
void pp_element_sight_view_clear(struct pp_element_view *view);

/* Turns to inside[target]. */
void pp_element_sight_look_at(struct pp_element_view *view, int target);

/* Is none of the blockers before that point? */
bool pp_element_sight_shows(const struct pp_element_view *view, struct pp_vec3 point);

#endif
