/* pane_luminance.c - see pane_luminance.h. */
#include "methods/exact/pane_luminance.h"

#include <float.h>
#include <math.h>

static double through_glass(const struct pp_pane_luminance *lights, struct pp_vec3 u)
{
    return pp_glass_transmittance(lights->glass, pp_vec_dot(lights->toward, u));
}

double pp_pane_luminance_sky(const void *context, struct pp_vec3 u)
{
    const struct pp_pane_luminance *lights = context;
    return pp_sky_luminance(lights->sky, u) * through_glass(lights, u);
}

double pp_pane_luminance_unity(const void *context, struct pp_vec3 u)
{
    return through_glass(context, u);
}

double pp_pane_luminance_at_horizon(const struct pp_sky *sky, struct pp_vec3 u)
{
    double across = hypot(u.x, u.y);
    if (!(across > 0.0))
        return pp_sky_luminance(sky, pp_vec(1.0, 0.0, DBL_MIN));
    return pp_sky_luminance(sky, pp_vec(u.x / across, u.y / across, DBL_MIN));
}

double pp_pane_luminance_horizon(const void *context, struct pp_vec3 u)
{
    const struct pp_pane_luminance *lights = context;
    return pp_pane_luminance_at_horizon(lights->sky, u) * through_glass(lights, u);
}
