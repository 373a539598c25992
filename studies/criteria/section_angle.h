/* section_angle.h - the obstruction angle before a window, in vertical section.
 */
#ifndef PP_STUDIES_CRITERIA_SECTION_ANGLE_H
#define PP_STUDIES_CRITERIA_SECTION_ANGLE_H

#include "model/room/world.h"

/* Angle above the horizontal (rad, 0 to pi/2) of the highest obstruction in the
 * vertical section through the middle of an opening's outside, perpendicular to its
 * wall. Obstructions are skylines of that wall, blocks, free-standing surfaces, other
 * parts of the building, and overhangs over the window; obstructions beside the section
 * do not count. The angle of a skyline in a room file is measured from the outside, as
 * in [BR209], whatever the depth of the reveal. The opening must be vertical.
 * with_shades: false leaves out the surfaces marked is_shade (world.h), such as
 * overhangs and balconies. */
double pp_section_angle(const struct pp_world *world, const struct pp_opening *opening,
                        bool with_shades);

#endif
