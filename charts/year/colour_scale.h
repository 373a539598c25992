/* colour_scale.h - seven colours from dark to light for classes of a value. */
#ifndef PP_CHARTS_YEAR_COLOUR_SCALE_H
#define PP_CHARTS_YEAR_COLOUR_SCALE_H

#include <cairo.h>

#include "charts/sheet/lettering.h"

enum { PP_COLOUR_CLASSES = 7 };

/* Lower limits of the classes. The first class has no lower limit. */
struct pp_colour_scale {
    double limits[PP_COLOUR_CLASSES]; /* limits[0] is not used */
    const char *unit;
};

/* Index of the class of a value, from 0. */
int pp_colour_scale_class(const struct pp_colour_scale *scale, double value);

/* Sets the colour of the class of a value. */
void pp_colour_scale_set(cairo_t *cr, const struct pp_colour_scale *scale,
                         double value);

/* Draws the legend in a row, width_mm long, from the upper left corner x, y: patches
 * with the limits between them. Returns the height. */
double pp_colour_scale_legend(cairo_t *cr, const struct pp_style *style,
                              const struct pp_colour_scale *scale, double x, double y,
                              double width_mm);

#endif
