/* irradiance.h - the irradiance at a point, divided by the origin of its light. */
#ifndef PP_SIMULATE_TRANSPORT_IRRADIANCE_H
#define PP_SIMULATE_TRANSPORT_IRRADIANCE_H

#include "model/light/rgb.h"

struct pp_irradiance {
    struct pp_rgb sources; /* concentrated emitters, by next-event estimation */
    struct pp_rgb sky;     /* directly from the sky, through openings by next-event
                            * estimation */
    struct pp_rgb outside; /* directly from ground, skylines and surfaces outside;
                            * sampled like the sky */
    struct pp_rgb rest;    /* all other light: mainly pi times the radiance of
                            * pp_radiance_indirect over the cosine lobe */
};

static inline struct pp_rgb pp_irradiance_sum(const struct pp_irradiance *e)
{
    return pp_rgb_add(pp_rgb_add(e->sources, e->rest), pp_rgb_add(e->sky, e->outside));
}

#endif
