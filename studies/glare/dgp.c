/* dgp.c - see dgp.h. */
#include "studies/glare/dgp.h"

#include <math.h>

static const double MOST_INDEX = 16.0;

double pp_dgp_position_index(const struct pp_frame *view, struct pp_vec3 u)
{
    struct pp_vec3 own = pp_frame_in(view, u);
    double across = hypot(own.x, own.y);
    if (!(own.z > 0.0))
        return MOST_INDEX;
    double s = atan2(across, own.z) / PP_RAD;
    double t = across > 0.0 ? atan2(fabs(own.x), fabs(own.y)) / PP_RAD : 0.0;
    double exponent;
    if (own.y >= 0.0) {
        exponent = (35.2 - 0.31889 * t - 1.22 * exp(-2.0 * t / 9.0)) * 1e-3 * s
                   + (21.0 + 0.26667 * t - 0.002963 * t * t) * 1e-5 * s * s;
    } else {
        double cosine = cos(t * PP_RAD);
        double B = atan(across / own.z * sqrt(1.0 + 0.3225 * cosine * cosine)) / PP_RAD;
        exponent = 6.49e-3 * B + 21e-5 * B * B;
    }
    return fmin(exp(exponent), MOST_INDEX);
}

double pp_dgp(double eye_lx, double sum)
{
    static const double LOW_LIGHT_LX = 1000.0;
    if (!(eye_lx > 0.0))
        return 0.0;
    double dgp =
        5.87e-5 * eye_lx + 0.0918 * log10(1.0 + sum / pow(eye_lx, 1.87)) + 0.16;
    if (eye_lx < LOW_LIGHT_LX)
        dgp *= 1.0 / (1.0 + exp(4.0 - 0.024 * eye_lx));
    return fmin(dgp, 1.0);
}
