/* section_angle.h - how high what stands outside rises before a window, in section.
 */
#ifndef PP_STUDIES_CRITERIA_SECTION_ANGLE_H
#define PP_STUDIES_CRITERIA_SECTION_ANGLE_H

#include "model/room/world.h"

/* Angle above the horizontal (rad, 0 to pi/2) of the highest thing outside in the
 * vertical section through the middle of an opening's outside, square to its wall:
 * skylines of that wall, blocks, loose surfaces and other parts of the building, what
 * hangs over the window too. Of what stands beside the section nothing shows. The
 * opening must be upright. */
double pp_section_angle(const struct pp_world *world, const struct pp_opening *opening);

#endif
