/* false_colour.h - false colours: a scale, its round levels, and a picture in these
 * colours.
 *
 * Colours are those of [GREEN11]: from black to white through all hues with increasing
 * lightness, so that a black and white copy keeps the order. The darkest and lightest
 * tenth are left out, for lines and paper.
 */
#ifndef PP_MODEL_PICTURES_FALSE_COLOUR_H
#define PP_MODEL_PICTURES_FALSE_COLOUR_H

#include <stdbool.h>

#include "model/pictures/picture.h"
#include "model/pictures/raster.h"

/* Values are in the printed unit (quantity.h). */
struct pp_false_colour_scale {
    double low, high; /* low < high; low > 0 if logarithmic */
    bool logarithmic;
};

/* Fits a scale to the picture; its values are the picture's luminances times `unit`.
 * The range of the scale excludes the darkest and lightest half per cent of the pixels,
 * and is rounded outwards to 1, 2 or 5 times a power of ten. A logarithmic scale has at
 * most four decades; a linear scale begins at 0. Black and NaN pixels do not count. */
enum pp_status pp_false_colour_scale_fit(struct pp_false_colour_scale *scale,
                                         const struct pp_picture *picture, double unit,
                                         bool logarithmic, struct pp_error *err);

enum { PP_FALSE_COLOUR_LEVELS_MOST = 40 };

/* Round values of the scale, ascending from end to end: 1, 2 and 5 times powers of ten,
 * or equal steps. Returns their number. */
int pp_false_colour_scale_levels(const struct pp_false_colour_scale *scale,
                                 double levels[PP_FALSE_COLOUR_LEVELS_MOST]);

/* Position of a value on the scale, 0 to 1; values off the scale are at its ends. */
double pp_false_colour_scale_at(const struct pp_false_colour_scale *scale,
                                double value);

/* sRGB colour for a position on the scale, 0 to 1. */
void pp_false_colour(double at, unsigned char rgb[3]);

/* The picture in the scale's colours; NaN pixels are white. */
enum pp_status pp_false_colour_raster(struct pp_raster *raster,
                                      const struct pp_picture *picture, double unit,
                                      const struct pp_false_colour_scale *scale,
                                      struct pp_error *err);

#endif
