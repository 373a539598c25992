/* rad_gendaylit.h - Perez's skies from the options of Radiance's gendaylit [PSM93]. */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_GENDAYLIT_H
#define PP_FORMATS_RADIANCE_READ_RAD_GENDAYLIT_H

#include "formats/radiance/read/rad_gensky.h"

/* Evaluates "gendaylit month day hour" or "gendaylit -ang altitude azimuth" with one of
 *
 *     -W, -G  direct normal (-G: horizontal) and diffuse horizontal irradiance, W/m2
 *     -L      direct normal and diffuse horizontal illuminance, lx
 *     -P      clearness eps and brightness D of Perez's model (perez_sky.h)
 *     -E      global horizontal irradiance, divided as by Erbs and others [EKD82]
 *
 * as pp_rad_gensky_evaluate. False also for a sky for which gendaylit prints zeros. */
bool pp_rad_gendaylit_evaluate(struct pp_gensky *sky, char *const *words, int count,
                               char *wrong, size_t room);

#endif
