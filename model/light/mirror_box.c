/* mirror_box.c - evaluates (2) by the midpoint rule over azimuth. */
#include "model/light/mirror_box.h"

#include <math.h>

#include "model/geometry/vec.h"
#include "model/light/sky.h"

enum { AZIMUTHS = 90, ALTITUDES = 900 };

/* g(x) of equation (1). */
static double reflected(double rho, double widths)
{
    double whole = floor(widths);
    return pow(rho, whole) * (1.0 - (widths - whole) * (1.0 - rho));
}

double pp_mirror_box_luminance(const struct pp_mirror_box *box, double altitude_rad)
{
    double sum = 0.0, far = box->height / tan(altitude_rad);
    if (box->height == 0.0 || box->rho == 1.0)
        return 1.0;
    if (!(altitude_rad > 0.0))
        return 0.0;
    for (int i = 0; i < AZIMUTHS; i++) {
        double psi = (i + 0.5) * 0.5 * PP_PI / AZIMUTHS;
        sum +=
            reflected(box->rho, far * cos(psi)) * reflected(box->rho, far * sin(psi));
    }
    return sum / AZIMUTHS;
}

double pp_mirror_box_horizontal(const struct pp_mirror_box *box)
{
    double sum = 0.0;
    for (int i = 0; i < ALTITUDES; i++) {
        double a = (i + 0.5) * 0.5 * PP_PI / ALTITUDES;
        sum += pp_mirror_box_luminance(box, a) * sin(a) * cos(a);
    }
    return sum * 2.0 * PP_PI * 0.5 * PP_PI / ALTITUDES;
}

double pp_mirror_box_correction(const struct pp_mirror_box *box, double altitude_rad)
{
    struct pp_sky overcast = pp_sky_overcast();
    struct pp_vec3 u = pp_vec(cos(altitude_rad), 0.0, sin(altitude_rad));
    return pp_sky_luminance(&overcast, u) * pp_mirror_box_horizontal(box)
           / pp_mirror_box_luminance(box, altitude_rad);
}
