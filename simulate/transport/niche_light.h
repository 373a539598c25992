/* niche_light.h - what the sides of niches give off.
 *
 * Where that is known, next-event estimation at the points of an empty convex room
 * (convex_room.h) aims at the mouths of niches instead of the panes in them, and has the
 * light of all that is seen through these. Rays that come to a side straight from the room
 * are to leave it out.
 */
#ifndef PP_SIMULATE_TRANSPORT_NICHE_LIGHT_H
#define PP_SIMULATE_TRANSPORT_NICHE_LIGHT_H

#include "simulate/scene/light_scene.h"

struct pp_niche_light {
    /* The exitance, over Eh, where a direction has come to a side. By that direction the
     * irradiance of the point that it is from has `worth` of it. */
    double (*exitance)(void *of, const struct pp_light_hit *side, double worth);
    void *of; /* not owned */
};

#endif
