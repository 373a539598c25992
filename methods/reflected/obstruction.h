/* obstruction.h - obstructions outside in the formulae of the internally reflected
 * component and of the average daylight factor: one angle, and the factor C for that
 * angle.
 *
 * The formulae were made for an infinitely long skyline parallel to the window, at the
 * section angle alpha (so that tan altitude = tan alpha cos azimuth). Blocks and other
 * obstructions are replaced by the infinitely long skyline with which a vertical plane
 * at the opening's centre has the same vertical sky component, VSC (graded_sky.h). ISO
 * skies are treated as the overcast sky: the angle represents a shape, and its VSC has
 * no closed form under ISO skies.
 */
#ifndef PP_METHODS_REFLECTED_OBSTRUCTION_H
#define PP_METHODS_REFLECTED_OBSTRUCTION_H

#include "model/light/outside_light.h"
#include "model/room/world.h"

/* Obstruction angle alpha of an opening (rad, 0 to pi/2): the angle of the skyline of
 * the opening's wall, from the mid-height of the opening. If blocks, free-standing
 * surfaces outside or other parts of the building are in front of the opening, the
 * angle follows from the VSC with all obstructions. The wall's own thickness, a reveal
 * or the facade in front of recessed glass, does not count. For a sloping opening the
 * VSC is that of the vertical plane with the same azimuth. The angle of a horizontal
 * opening is 90 degrees times the fraction of the sky's light that is hidden. */
enum pp_status pp_obstruction_angle(double *angle_rad, const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const struct pp_opening *opening,
                                    struct pp_error *err);

/* Factor C of the BRE inter-reflection formula: illuminance of a vertical window from
 * above the horizon over Eh, CIE overcast sky, in front of an infinitely long
 * obstruction of altitude angle_rad (0 to pi/2). A fraction, 0.39 to 0.05, which
 * includes the light that the obstruction reflects. Interpolated linearly in the
 * printed table [BRE310]; constant above the table's last angle. */
double pp_obstruction_factor(double angle_rad);

#endif
