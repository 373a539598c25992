/* light_ray.h - the light along a ray, followed to all sources through clear panes and
 * their reflections.
 *
 * The ray is not random. At a pane it continues as a transmitted and a reflected ray,
 * each with its own weight, until the weight is negligible.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_LIGHT_RAY_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_LIGHT_RAY_H

#include "simulate/research/radiosity/light_sum.h"
#include "simulate/research/radiosity/outdoors.h"

struct pp_element_sight;

/* Data needed to follow rays and gather light; not owned. */
struct pp_light_room {
    const struct pp_facets *facets;
    const struct pp_element_tree *tree;
    const struct pp_outdoors *outdoors;
    const struct pp_element_sight *sight;
};

struct pp_light_ray_start {
    struct pp_vec3 from, to; /* to: unit */
    int but;                 /* index of the facet that the ray leaves; -1: none */
    bool indoors;            /* the ray starts in the room */
};

/* Adds `weight` times pi times the radiance along the ray to the sum. part: component
 * of all the light. With PP_DF, the first object met determines the component (PP_SC
 * for the sky, PP_ERC for anything else outdoors, PP_IRC for objects in the room). */
void pp_light_ray_follow(const struct pp_light_room *room,
                         const struct pp_light_ray_start *ray, double weight,
                         enum pp_component part, struct pp_light_sum *sum);

/* Light that has been added to the sum since `from`, with the present radiosities of
 * elements, and an estimate for the radiosities of places outside. */
double pp_light_ray_guess(const struct pp_light_room *room,
                          const struct pp_light_sum *sum,
                          const struct pp_light_mark *from);

#endif
