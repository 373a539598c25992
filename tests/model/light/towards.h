/* towards.h - directions by angles, for tests. */
#ifndef PP_TESTS_MODEL_LIGHT_TOWARDS_H
#define PP_TESTS_MODEL_LIGHT_TOWARDS_H

#include "model/geometry/vec.h"

/* Unit direction at this tilt from +z and azimuth from +x, in degrees. */
static inline struct pp_vec3 pp_test_towards(double tilt_deg, double azimuth_deg)
{
    double t = tilt_deg * PP_RAD, a = azimuth_deg * PP_RAD;
    return pp_vec(sin(t) * cos(a), sin(t) * sin(a), cos(t));
}

#endif
