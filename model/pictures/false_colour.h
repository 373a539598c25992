/* false_colour.h - false colours: a scale, its round levels, a picture in it.
 *
 * Colours are those of [GREEN11]: from black to white by way of all hues, ever lighter
 * to the eye, so that a black and white copy keeps the order; the darkest and the
 * lightest tenth are left out, for lines and paper.
 */
#ifndef PP_MODEL_PICTURES_FALSE_COLOUR_H
#define PP_MODEL_PICTURES_FALSE_COLOUR_H

#include <stdbool.h>

#include "model/pictures/picture.h"
#include "model/pictures/raster.h"

/* Values are in the unit that people read (quantity.h). */
struct pp_false_colour_scale {
    double low, high; /* low < high; where logarithmic low > 0 */
    bool logarithmic;
};

/* Fits a scale to the picture, whose values are luminances times `unit`. Its ends are
 * rounded outwards to 1, 2, 5 and their decades from the range of all but the darkest
 * and lightest half per cent of the pixels. It has at most four decades, and begins at
 * 0 if it is linear. Pixels that are black or NaN do not count. */
enum pp_status pp_false_colour_scale_fit(struct pp_false_colour_scale *scale,
                                         const struct pp_picture *picture, double unit,
                                         bool logarithmic, struct pp_error *err);

enum { PP_FALSE_COLOUR_LEVELS_MOST = 40 };

/* The round values of the scale from end to end, ascending: 1, 2, 5 and their decades,
 * or equal steps. Returns how many. */
int pp_false_colour_scale_levels(const struct pp_false_colour_scale *scale,
                                 double levels[PP_FALSE_COLOUR_LEVELS_MOST]);

/* Position of a value on the scale, 0 to 1; values off the scale are at its end. */
double pp_false_colour_scale_at(const struct pp_false_colour_scale *scale,
                                double value);

/* sRGB of a place on the scale, 0 to 1. */
void pp_false_colour(double at, unsigned char rgb[3]);

/* The picture in the scale's colours; pixels that are no number are white. */
enum pp_status pp_false_colour_raster(struct pp_raster *raster,
                                      const struct pp_picture *picture, double unit,
                                      const struct pp_false_colour_scale *scale,
                                      struct pp_error *err);

#endif
