/* sun_path.h - the path of the sun on a day, by solar time.
 *
 *     sin a = sin phi sin delta + cos phi cos delta cos h
 *
 *   a      altitude, phi latitude, delta declination
 *   h      hour angle: 15 degrees for each hour after solar noon
 */
#ifndef PP_MODEL_LIGHT_SUN_PATH_H
#define PP_MODEL_LIGHT_SUN_PATH_H

#include "model/geometry/vec.h"

/* Unit vector to the sun: x east, y north, z up. Angles in rad. */
struct pp_vec3 pp_sun_path_direction(double latitude, double declination,
                                     double hour_angle);

/* Hour angle of sunset, 0 to pi: 0 if the sun does not rise, pi if it does not set. */
double pp_sun_path_sunset(double latitude, double declination);

/* The sun's declination (rad) at noon of that day in 2025. */
double pp_sun_path_declination(int month, int day);

#endif
