/* slats.h - a blind of equal slats, and the light that passes straight between them.
 *
 * Section through the blind: a points into the room, b up (for vertical slats: to the
 * left, seen from outside). A slat is flat or a circular arc. Its chord of width w is
 * tilted by t; t > 0 lowers the inner edge. Its neighbours stand at the spacing s along
 * b. The profile angle p is the angle of the light in this section; p > 0 travels down
 * into the room.
 *
 *     flat:  straight = max(0, 1 - w/s |cos t tan p - sin t|)                       (1)
 *     arc:   straight = max(0, 1 - e(p) / (s |cos p|))                              (2)
 *
 * e(p) is the extent of the slat across the light. For an arc of radius R that turns by
 * an angle of A either side of its crown, it is R times the range of cos(q - p + t) for
 * |q| <= A. Both formulae are exact for endless slats without thickness.
 */
#ifndef PP_MODEL_LIGHT_SLATS_SLATS_H
#define PP_MODEL_LIGHT_SLATS_SLATS_H

#include "model/geometry/vec.h"

struct pp_slats {
    double width;    /* w: chord of a slat (m), greater than 0 */
    double spacing;  /* s (m), greater than 0 */
    double tilt_rad; /* t, -pi/2 to pi/2; 0: slats normal to the window */
    double rise;     /* height of the arc over the middle of its chord (m), at most w/2;
                      * greater than 0: the upper side is convex */
    double upper;    /* diffuse reflectance of the upper side, 0 to 1 */
    double lower;    /* diffuse reflectance of the lower side, 0 to 1 */
};

/* Share of light that passes straight between the slats. profile_rad: profile angle of
 * the direction of travel, -pi to pi; light beyond pi/2 (either sign) leaves the
 * room. */
double pp_slats_straight(const struct pp_slats *slats, double profile_rad);

/* Cut-off tilt: the tilt nearest to 0 at which no light of this profile angle passes
 * straight. If there is none, the tilt at which the least light passes. Slats turn
 * against the light: the inner edge rises for light from above. */
double pp_slats_cut_off(const struct pp_slats *slats, double profile_rad);

/* Point of the slat at a fraction of its arc, 0 at the outer edge and 1 at the inner
 * edge. *a and *b are relative to the middle of the chord (m). */
void pp_slats_point(const struct pp_slats *slats, double fraction, double *a,
                    double *b);

/* Profile angle of a direction of travel; inwards: unit normal of the window into the
 * room; along: unit vector along b. */
double pp_slats_profile(struct pp_vec3 travel, struct pp_vec3 inwards,
                        struct pp_vec3 along);

#endif
