/* outside_light.c - illuminances from sky, ground and sun, and a list of those from the
 * sky. */
#include "model/light/outside_light.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"

static const struct pp_outside_plane *find_plane(const struct pp_outside_planes *planes,
                                                 struct pp_vec3 n)
{
    for (int i = 0; i < planes->count; i++) {
        struct pp_vec3 own = planes->list[i].normal;
        if (own.x == n.x && own.y == n.y && own.z == n.z)
            return &planes->list[i];
    }
    return NULL;
}

enum pp_status pp_outside_light_add_plane(struct pp_outside_planes *planes,
                                          const struct pp_sky *sky, struct pp_vec3 n,
                                          struct pp_error *err)
{
    if (find_plane(planes, n))
        return PP_OK;
    enum pp_status status = pp_array_reserve(
        &planes->list, &planes->capacity, planes->count + 1, sizeof *planes->list, err);
    if (status == PP_OK)
        planes->list[planes->count++] =
            (struct pp_outside_plane){n, pp_sky_on_plane(sky, n)};
    return status;
}

void pp_outside_light_clear_planes(struct pp_outside_planes *planes)
{
    free(planes->list);
    *planes = (struct pp_outside_planes){0};
}

double pp_outside_light_sky_on_plane(const struct pp_outside_light *light,
                                     struct pp_vec3 n)
{
    const struct pp_outside_plane *known =
        light->planes ? find_plane(light->planes, n) : NULL;
    return known ? known->sky : pp_sky_on_plane(&light->sky, n);
}

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
