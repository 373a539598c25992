/* angle.h - an angle by its sine and cosine, calculated once for many uses. */
#ifndef PP_MODEL_GEOMETRY_ANGLE_H
#define PP_MODEL_GEOMETRY_ANGLE_H

#include <math.h>

struct pp_angle {
    double sine, cosine;
};

static inline struct pp_angle pp_angle_of(double rad)
{
    return (struct pp_angle){sin(rad), cos(rad)};
}

#endif
