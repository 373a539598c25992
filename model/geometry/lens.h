/* lens.h - projections of fisheye lenses: distance from the picture's centre by the
 * angle theta from the lens axis, relative to the distance at 90 degrees.
 *
 *     equidistant     theta / (pi/2)
 *     equisolid       sin(theta/2) / sin(pi/4)     equal areas for equal solid angles
 *     stereographic   tan(theta/2)                 conformal: keeps small shapes
 *     orthographic    sin(theta)                   the horizontal configuration factor
 */
#ifndef PP_MODEL_GEOMETRY_LENS_H
#define PP_MODEL_GEOMETRY_LENS_H

#include <math.h>

#include "model/geometry/vec.h"

enum pp_lens {
    PP_LENS_EQUIDISTANT,
    PP_LENS_EQUISOLID,
    PP_LENS_STEREOGRAPHIC,
    PP_LENS_ORTHOGRAPHIC,
    PP_LENS_COUNT
};

/* Relative distance, 0 to 1, for theta from 0 to pi/2. */
static inline double pp_lens_radius(enum pp_lens lens, double theta_rad)
{
    switch (lens) {
    case PP_LENS_EQUISOLID:
        return sin(0.5 * theta_rad) / sin(0.25 * PP_PI);
    case PP_LENS_STEREOGRAPHIC:
        return tan(0.5 * theta_rad);
    case PP_LENS_ORTHOGRAPHIC:
        return sin(theta_rad);
    default:
        return theta_rad / (0.5 * PP_PI);
    }
}

#endif
