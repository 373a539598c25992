/* lobe.h - frames about a normal, and cosine-weighted directions in them.
 *
 * Sine and cosine are calculated here, only for the small range needed. This arithmetic
 * gives bit-identical results with any compiler, and is faster than the library.
 */
#ifndef PP_SIMULATE_SAMPLING_LOBE_H
#define PP_SIMULATE_SAMPLING_LOBE_H

#include <math.h>

#include "model/geometry/vec.h"

/* Two unit vectors that make a right-handed frame with the unit vector n [DBC17]. */
static inline void pp_lobe_frame(struct pp_vec3 n, struct pp_vec3 *a, struct pp_vec3 *b)
{
    double sign = copysign(1.0, n.z);
    double p = -1.0 / (sign + n.z), q = n.x * n.y * p;
    *a = pp_vec(1.0 + sign * n.x * n.x * p, sign * q, -sign * n.x);
    *b = pp_vec(q, sign + n.y * n.y * p, -n.y);
}

/* Sine and cosine of x in [-pi/4, pi/4], to 3e-14: their Taylor series. */
static inline void pp_lobe_small_sincos(double x, double *sine, double *cosine)
{
    double y = x * x, s = 1.0 / 6227020800.0, c = 1.0 / 87178291200.0;
    s = s * y - 1.0 / 39916800.0;
    s = s * y + 1.0 / 362880.0;
    s = s * y - 1.0 / 5040.0;
    s = s * y + 1.0 / 120.0;
    s = s * y - 1.0 / 6.0;
    *sine = x + x * y * s;
    c = 1.0 / 479001600.0 - c * y;
    c = c * y - 1.0 / 3628800.0;
    c = c * y + 1.0 / 40320.0;
    c = c * y - 1.0 / 720.0;
    c = c * y + 1.0 / 24.0;
    c = c * y - 1.0 / 2.0;
    *cosine = 1.0 + y * c;
}

/* Cosine-weighted direction about +z from two uniform numbers in (0, 1), by the
 * concentric map of the square to the disc [SC97]; density cos(theta)/pi per
 * steradian. */
static inline struct pp_vec3 pp_lobe_sample_cosine(double u1, double u2)
{
    double a = 2.0 * u1 - 1.0, b = 2.0 * u2 - 1.0;
    double r, x, y;
    if (fabs(a) > fabs(b)) {
        r = a;
        pp_lobe_small_sincos(PP_PI / 4.0 * (b / a), &y, &x);
    } else {
        r = b;
        pp_lobe_small_sincos(PP_PI / 4.0 * (b != 0.0 ? a / b : 0.0), &x, &y);
    }
    double z2 = 1.0 - r * r;
    return pp_vec(r * x, r * y, z2 > 0.0 ? sqrt(z2) : 0.0);
}

/* A cosine-weighted direction about n, in the frame (a, b, n). */
static inline struct pp_vec3 pp_lobe_sample_in_frame(struct pp_vec3 a, struct pp_vec3 b,
                                                     struct pp_vec3 n, double u1,
                                                     double u2)
{
    struct pp_vec3 s = pp_lobe_sample_cosine(u1, u2);
    return pp_vec(a.x * s.x + b.x * s.y + n.x * s.z, a.y * s.x + b.y * s.y + n.y * s.z,
                  a.z * s.x + b.z * s.y + n.z * s.z);
}

#endif
