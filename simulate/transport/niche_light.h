/* niche_light.h - the exitance of the sides of niches.
 *
 * If the exitance is known, next-event estimation at the points of an empty convex room
 * (convex_room.h) aims at the mouths of niches instead of the panes in them. It
 * includes all light seen through the mouths. Rays that reach a side directly from the
 * room must then exclude the light of the side. */
#ifndef PP_SIMULATE_TRANSPORT_NICHE_LIGHT_H
#define PP_SIMULATE_TRANSPORT_NICHE_LIGHT_H

#include "simulate/scene/light_scene.h"

struct pp_niche_light {
    /* Exitance, over Eh, at the place where a direction ends on a side. `worth` is the
     * weight of this exitance in the irradiance of the point from which the direction
     * starts. */
    double (*exitance)(void *of, const struct pp_light_hit *side, double worth);
    void *of; /* not owned */
};

#endif
