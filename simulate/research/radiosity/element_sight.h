/* element_sight.h - visibility between two places in the room.
 *
 * Most pairs of places see each other. A facet cannot be between two places if some
 * plane has both places on one side and the facet on the other. Precomputed signs
 * exclude most facets in this way. Each of the few remaining facets is tested by one
 * intersection.
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
        *below; /* one bit for each of the first 64 planes: the facet is entirely
                 * above or below the plane; both if it lies in the plane */
};

enum pp_status pp_element_sight_create(struct pp_element_sight **sight,
                                       const struct pp_facets *facets,
                                       struct pp_error *err);
void pp_element_sight_destroy(struct pp_element_sight *sight); /* NULL is allowed */

/* Viewpoint for tests of visibility, with one target facet at a time. */
struct pp_element_view {
    const struct pp_element_sight *sight; /* not owned */
    struct pp_vec3 point;
    uint64_t above, below; /* planes that the point is above or below */
    int *blockers;         /* facets that may be between the point and the target */
    int blocker_count;
};

/* Sets the viewpoint; false if memory runs out. */
bool pp_element_sight_view_init(struct pp_element_view *view,
                                const struct pp_element_sight *sight,
                                struct pp_vec3 point);
void pp_element_sight_view_clear(struct pp_element_view *view);

/* Sets the target to inside[target], and lists its possible blockers. */
void pp_element_sight_look_at(struct pp_element_view *view, int target);

/* True if no blocker hides this point of the target. */
bool pp_element_sight_shows(const struct pp_element_view *view, struct pp_vec3 point);

#endif
