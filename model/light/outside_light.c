/* outside_light.c - see outside_light.h. */
#include "model/light/outside_light.h"

#include <math.h>

double pp_outside_light_sun_on_plane(const struct pp_outside_light *light,
                                     struct pp_vec3 n)
{
    return light->sun.per_sky > 0.0
               ? light->sun.per_sky * fmax(0.0, pp_vec_dot(light->sun.to, n))
               : 0.0;
}

double pp_outside_light_ground(const struct pp_outside_light *light)
{
    return light->ground_reflectance;
}

double pp_outside_light_sunlit_ground(const struct pp_outside_light *light)
{
    return light->ground_reflectance
           * (1.0 + pp_outside_light_sun_on_plane(light, pp_vec(0.0, 0.0, 1.0)));
}

double pp_outside_light_ground_on_plane(const struct pp_outside_light *light,
                                        struct pp_vec3 n)
{
    return pp_outside_light_sunlit_ground(light) * (1.0 - n.z) / 2.0;
}

double pp_outside_light_exitance(const struct pp_outside_light *light,
                                 double reflectance, struct pp_vec3 n)
{
    return reflectance
           * (pp_sky_on_plane(&light->sky, n) + pp_outside_light_sun_on_plane(light, n)
              + pp_outside_light_ground_on_plane(light, n));
}
