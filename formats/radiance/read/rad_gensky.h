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
    double sun_radiance; /* uniform over a disc of half a degree, W/sr/m2 */
};

/* Evaluates "gensky month day hour" or "gensky -ang altitude azimuth", with options;
 * words[0] is "gensky". Values are rounded as gensky prints them, so that the scene
 * equals the one from its output. Returns false, with a sentence in `wrong`, for
 * unknown words. */
bool pp_rad_gensky_evaluate(struct pp_gensky *sky, char *const *words, int count,
                            char *wrong, size_t room);

#endif
