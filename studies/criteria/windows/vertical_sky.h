/* vertical_sky.h - the vertical sky component of a window. */
#ifndef PP_STUDIES_CRITERIA_WINDOWS_VERTICAL_SKY_H
#define PP_STUDIES_CRITERIA_WINDOWS_VERTICAL_SKY_H

#include "model/room/world.h"

/* Is the glass upright, to a degree? It has a component then. */
bool pp_vertical_sky_is_upright(const struct pp_opening *opening);

/* The illuminance of the wall's plane at the middle of the opening's outside from the
 * overcast sky alone, over Eh: 0 to 0.3962. */
enum pp_status pp_vertical_sky_component(double *share, const struct pp_world *world,
                                         const struct pp_opening *opening,
                                         struct pp_error *err);

#endif
