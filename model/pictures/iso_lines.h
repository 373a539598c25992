/* iso_lines.h - lines of equal value in a picture, within each of the surfaces shown.
 *
 * The picture is smoothed a little within each surface first, so that its noise does
 * not tear the lines; where two surfaces meet lines end, as they do in the room, and
 * pixels that show something of both are left out. Where the surfaces are not known, an
 * edge is taken to be where neighbours differ by much.
 */
#ifndef PP_MODEL_PICTURES_ISO_LINES_H
#define PP_MODEL_PICTURES_ISO_LINES_H

#include "model/geometry/curve.h"
#include "model/pictures/picture.h"

/* Adds the lines of `count` levels (above 0, ascending, in the unit of pixels'
 * luminance times `unit`). Points are in pixels, from the upper left corner; the middle
 * of the first pixel is (0.5, 0.5). `tags` (may be NULL) identifies the surface in each
 * pixel, row by row. `smooth` is the standard deviation of the smoothing, in pixels;
 * lines shorter than `shortest` pixels are left out. */
enum pp_status pp_iso_lines(struct pp_curve_list *lines,
                            const struct pp_picture *picture, const int *tags,
                            double unit, const double *levels, int count, double smooth,
                            double shortest, struct pp_error *err);

#endif
