/* rad_gensky.h - Radiance's sky generator: sky and sun from the options of gensky
 * [WS98]. */
#ifndef PP_FORMATS_RADIANCE_READ_RAD_GENSKY_H
#define PP_FORMATS_RADIANCE_READ_RAD_GENSKY_H

#include <stdbool.h>
#include <stddef.h>

#include "model/light/scene_description.h"

struct pp_gensky {
    struct pp_pattern pattern;
    bool has_sun;
    double sun_radiance; /* uniform over its disc, W/sr/m2 */
    double sun_half_rad; /* radius of the disc */
};

/* Evaluates "gensky month day hour" or "gensky -ang altitude azimuth", with options;
 * words[0] is "gensky". Values are rounded as gensky prints them, so that the scene
 * equals a scene with the output of gensky. Returns false, with a sentence in `wrong`,
 * for unknown or invalid words. */
bool pp_rad_gensky_evaluate(struct pp_gensky *sky, char *const *words, int count,
                            char *wrong, size_t room);

/* Sun (rad; azimuth west of south) and day of the year from the first four words of
 * gensky or gendaylit and their options -y, -a, -o and -m. *day is 0 with -ang.
 * interval_min: as gendaylit's -i; the time is the middle of an interval of this length
 * (minutes), and if the sun rises or sets in it, the middle of its sunlit part counts
 * instead; 0: the time itself. Otherwise as pp_rad_gensky_evaluate. */
bool pp_rad_gensky_place(double *altitude, double *azimuth, int *day,
                         double interval_min, char *const *words, int count,
                         char *wrong, size_t room);

/* Horizontal illuminance over pi times the zenith luminance, by gensky's formulae for a
 * type of sky (enum pp_gensky_kind). */
double pp_rad_gensky_level(int type, double altitude);

#endif
