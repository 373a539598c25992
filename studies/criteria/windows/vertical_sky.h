/* vertical_sky.h - the vertical sky component of a window. */
#ifndef PP_STUDIES_CRITERIA_WINDOWS_VERTICAL_SKY_H
#define PP_STUDIES_CRITERIA_WINDOWS_VERTICAL_SKY_H

#include "model/room/world.h"

/* True if the glass is within one degree of vertical, and so has a vertical sky
 * component. */
bool pp_vertical_sky_is_upright(const struct pp_opening *opening);

/* Point on a window's outside at which its component is calculated: its centre. If the
 * window begins within 0.2 m of the room's floor (chosen) and ends above french_m (m
 * over that floor), the point is at that height instead, midway across. french_m 0:
 * always the centre. The height of 1.6 m for French windows and patio doors is from
 * memory of practice with [BR209]; its text was not available. */
struct pp_vec3 pp_vertical_sky_point(const struct pp_opening *opening, double french_m);

/* The illuminance of the wall's plane at that point from the overcast sky alone, over
 * Eh: 0 to 0.3962. */
enum pp_status pp_vertical_sky_at_point(double *share, const struct pp_world *world,
                                        const struct pp_opening *opening,
                                        double french_m, struct pp_error *err);

#endif
