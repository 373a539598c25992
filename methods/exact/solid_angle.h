/* solid_angle.h - the light of a plane polygon at a receiver, in closed form.
 *
 * A polygon is seen from a point (the eye, at the origin of its vertices) as a patch of
 * the unit sphere bounded by arcs of great circles. With unit directions r_i to its
 * vertices, Theta_i the arc from r_i to r_i+1, Gamma_i = r_i x r_i+1 / |...|, n the
 * receiver's normal and z the zenith:
 *
 *     omega = solid angle of the patch, triangle by triangle              [VOS83]
 *     E0 = integral n.u domega = 1/2 sum Theta_i (n.Gamma_i)              Lambert
 *     E1 = integral (n.u)(z.u) domega                                     [ARVO95]
 *        = 1/3 [ (n.z) omega
 *                + sum (z.Gamma_i) n.(r_i sin Theta_i
 *                                     + (Gamma_i x r_i)(1 - cos Theta_i)) ]
 *
 * A sky of gradation b (graded_sky.h) is (E0 + b E1)/(1 + b) times the luminance of its
 * zenith. The polygon need not be convex; it and the receiver may have any tilt.
 */
#ifndef PP_METHODS_EXACT_SOLID_ANGLE_H
#define PP_METHODS_EXACT_SOLID_ANGLE_H

#include "methods/exact/half_space_clip.h"
#include "model/light/sky.h"
#include "model/geometry/vec.h"

struct pp_moments {
    double omega;       /* solid angle, sr */
    double cosine;      /* E0: integral of n.u */
    double cosine_sine; /* E1: integral of (n.u)(z.u) */
};

/* Adds to *sum the moments of the part of a ring within all the half-spaces h.u > 0.
 *
 * vertices are relative to the eye and counter-clockwise as seen from the eye (the
 * moments of a clockwise ring, a hole, are negative). They lie in one plane that does
 * not pass through the eye. normal need not be among the half-spaces: otherwise the
 * contribution of the part behind the receiver is negative. Errors are some units in
 * the last place of the largest term; for a polygon of angular size s the relative
 * error is about 1e-16/s. Allocates nothing. */
void pp_solid_angle_add_moments(struct pp_moments *sum, const struct pp_vec3 *vertices,
                                int count, struct pp_vec3 normal,
                                const struct pp_vec3 *half_spaces,
                                int half_space_count);

/* True if the light of the sky follows from the moments. */
bool pp_solid_angle_has_closed_form(const struct pp_sky *sky);

/* Illuminance, over Eh, from a patch of such a sky with these moments. */
double pp_solid_angle_sky_component(const struct pp_moments *moments,
                                    const struct pp_sky *sky);

#endif
