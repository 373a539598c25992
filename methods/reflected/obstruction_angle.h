/* obstruction_angle.h - the one angle by which the room formulae know what stands
 * outside.
 *
 * They were made for an endless skyline parallel to the window. Facing one at the
 * section angle alpha (so that it droops: tan altitude = tan alpha cos azimuth), a
 * vertical plane gets from the sky alone, as a fraction of Eh,
 *
 *     overcast   VSC(alpha) = 3/14 (1 - sin alpha) + 4/(7 pi) cos^2 alpha
 *     uniform    VSC(alpha) = 1/2 (1 - sin alpha)
 *
 * by integration over the strip above it. Blocks and whatever else hides the sky are
 * taken as the endless skyline that leaves the same VSC at the opening's centre.
 */
#ifndef PP_METHODS_REFLECTED_OBSTRUCTION_ANGLE_H
#define PP_METHODS_REFLECTED_OBSTRUCTION_ANGLE_H

#include "model/room/world.h"

/* VSC(alpha); angle 0 to pi/2. Any ISO sky is answered for as the overcast one: the
 * angle stands for a shape, and that shape has no closed form under those skies. */
double pp_obstruction_angle_to_vsc(enum pp_sky_kind sky, double angle_rad);

/* The angle at which VSC is `share`, in closed form; 0 for any share above that of the
 * open sky, pi/2 for one below 0. */
double pp_obstruction_angle_from_vsc(enum pp_sky_kind sky, double share);

/* alpha of an opening (rad, 0 to pi/2): the angle of its own wall's skyline from the
 * middle of its height; where blocks, loose surfaces outside or other parts of the
 * building stand before it, the angle by VSC of all that hides. A sloping opening is
 * looked out of in the vertical plane that faces the same way; a horizontal one faces
 * no way, and its angle is 90 degrees times the share of the sky's light that is
 * hidden. */
enum pp_status pp_obstruction_angle(double *angle_rad, const struct pp_world *world,
                                    const struct pp_opening *opening,
                                    struct pp_error *err);

#endif
