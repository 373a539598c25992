/* pane_luminance.h - luminance over Eh seen through clear glass, as a function of
 * direction (pp_luminance_function of quadrature.h). */
#ifndef PP_METHODS_EXACT_PANE_LUMINANCE_H
#define PP_METHODS_EXACT_PANE_LUMINANCE_H

#include "model/geometry/vec.h"
#include "model/light/glass.h"
#include "model/light/sky.h"

/* The context of the functions. The pointers are not owned. */
struct pp_pane_luminance {
    const struct pp_sky *sky;
    const struct pp_glass *glass; /* no panes: unglazed */
    struct pp_vec3 toward;        /* unit normal of the pane, pointing out */
};

/* Luminance of the sky in direction u, of a surface of luminance 1, and of the sky at
 * the horizon below or above u, each times the transmittance for u. */
double pp_pane_luminance_sky(const void *context, struct pp_vec3 u);
double pp_pane_luminance_unity(const void *context, struct pp_vec3 u);
double pp_pane_luminance_horizon(const void *context, struct pp_vec3 u);

/* Luminance of the sky at the horizon in the azimuth of u, without glass. */
double pp_pane_luminance_at_horizon(const struct pp_sky *sky, struct pp_vec3 u);

#endif
