/* standard_sky.h - standard skies. Some methods for the year represent all weather by
 * mixtures of these skies.
 *
 * Overcast is the sky of Moon and Spencer [MS42]; clear, turbid and type 1 are the
 * types 12, 13 and 1 of ISO 15469 [ISO15469]; intermediate is the sky of EnergyPlus
 * (perez_sky.h). Each is scaled to a horizontal illuminance of 1 lx.
 */
#ifndef PP_STUDIES_YEAR_HAND_STANDARD_SKY_H
#define PP_STUDIES_YEAR_HAND_STANDARD_SKY_H

#include "model/light/perez_sky.h"

enum pp_standard_sky {
    PP_STANDARD_OVERCAST,
    PP_STANDARD_INTERMEDIATE,
    PP_STANDARD_TURBID,
    PP_STANDARD_CLEAR,
    PP_STANDARD_ISO_1,
    PP_STANDARD_COUNT
};

/* The sky of that kind with the sun in unit direction `sun`, above the horizon; the sun
 * itself gives no light. */
struct pp_perez_sky pp_standard_sky_of(enum pp_standard_sky kind, struct pp_vec3 sun);

/* Horizontal illuminance (lx) of such a sky for a luminance of 1 cd/m2 at the zenith. */
double pp_standard_sky_per_zenith(const struct pp_perez_sky *sky);

#endif
