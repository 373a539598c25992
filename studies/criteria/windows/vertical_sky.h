/* vertical_sky.h - the vertical sky component of a window. */
#ifndef PP_STUDIES_CRITERIA_WINDOWS_VERTICAL_SKY_H
#define PP_STUDIES_CRITERIA_WINDOWS_VERTICAL_SKY_H

#include "model/room/world.h"

/* Is the glass upright, to a degree? It has a component then. */
bool pp_vertical_sky_is_upright(const struct pp_opening *opening);

/* Where a window's component is taken, on its outside: at its middle; but of one that begins
 * within 0.2 m of the room's floor (chosen) and ends above french_m (m over that floor,
 * greater than 0), at that height in its middle. Where 0, all are taken at their middle.
 * Recalled from practice with [BR209], of which no text is at hand: 1.6 m for French
 * windows and patio doors. */
struct pp_vec3 pp_vertical_sky_point(const struct pp_opening *opening, double french_m);

/* The illuminance of the wall's plane there from the overcast sky alone, over Eh: 0 to
 * 0.3962. */
enum pp_status pp_vertical_sky_at_point(double *share, const struct pp_world *world,
                                        const struct pp_opening *opening,
                                        double french_m, struct pp_error *err);

#endif
