/* iso_lines.h - lines of equal value in a picture, within each surface.
 *
 * The picture is first smoothed slightly within each surface, so that noise does not
 * break the lines. Lines end where two surfaces meet, and pixels that show both
 * surfaces are left out. If the surfaces are not known, large differences between
 * neighbouring pixels are treated as edges.
 */
#ifndef PP_MODEL_PICTURES_ISO_LINES_H
#define PP_MODEL_PICTURES_ISO_LINES_H

#include "model/geometry/curve.h"
#include "model/pictures/picture.h"

/* Adds the lines on which unit x luminance equals one of the levels (ascending, above
 * 0). Points are in pixels from the upper left corner; the centre of the first pixel is
 * (0.5, 0.5). tags: surface of each pixel, row by row; NULL: not known. smooth:
 * standard deviation of the smoothing, in pixels. Lines shorter than `shortest` pixels
 * are left out. */
enum pp_status pp_iso_lines(struct pp_curve_list *lines,
                            const struct pp_picture *picture, const int *tags,
                            double unit, const double *levels, int count, double smooth,
                            double shortest, struct pp_error *err);

#endif
