/* sky_projection.c - see sky_projection.h. */
#include "model/light/photographs/sky_projection.h"

#include <math.h>
#include <stddef.h>

const char *const pp_sky_projection_names[PP_SKY_PROJECTION_COUNT + 1] = {
    "equidistant", "equisolid", "hemispherical", "latitude-longitude", NULL};

double pp_sky_projection_widest(enum pp_sky_projection projection)
{
    return projection == PP_SKY_HEMISPHERICAL ? PP_PI / 2.0 : PP_PI;
}

void pp_sky_projection_place(enum pp_sky_projection projection, double half_angle_rad,
                             struct pp_vec3 u, double place[2])
{
    if (projection == PP_SKY_LATITUDE_LONGITUDE) {
        place[0] = atan2(u.x, u.z) / PP_PI;
        place[1] = atan2(u.y, hypot(u.x, u.z)) / (PP_PI / 2.0);
        return;
    }
    double sine = hypot(u.x, u.y), t = atan2(sine, u.z), r;
    if (projection == PP_SKY_EQUIDISTANT)
        r = t / half_angle_rad;
    else if (projection == PP_SKY_EQUISOLID)
        r = sin(t / 2.0) / sin(half_angle_rad / 2.0);
    else
        r = (u.z > 0.0 ? sine : 1.0) / sin(half_angle_rad);
    double scale = sine > 0.0 ? r / sine : 0.0;
    place[0] = scale * u.x;
    place[1] = scale * u.y;
}

bool pp_sky_projection_direction(enum pp_sky_projection projection,
                                 double half_angle_rad, const double place[2],
                                 struct pp_vec3 *u)
{
    if (projection == PP_SKY_LATITUDE_LONGITUDE) {
        double along = place[0] * PP_PI, up = place[1] * PP_PI / 2.0;
        *u = pp_vec(cos(up) * sin(along), sin(up), cos(up) * cos(along));
        return fabs(place[0]) <= 1.0 && fabs(place[1]) <= 1.0;
    }
    double r = hypot(place[0], place[1]), t;
    if (r > 1.0)
        return false;
    if (projection == PP_SKY_EQUIDISTANT)
        t = r * half_angle_rad;
    else if (projection == PP_SKY_EQUISOLID)
        t = 2.0 * asin(r * sin(half_angle_rad / 2.0));
    else
        t = asin(r * sin(half_angle_rad));
    double scale = r > 0.0 ? sin(t) / r : 0.0;
    *u = pp_vec(scale * place[0], scale * place[1], cos(t));
    return true;
}
