/* png_bands.h - a drawing that is too large for a picture in memory, as a PNG file.
 *
 * The drawing is recorded and drawn again for each band of rows, so that only one band is
 * there at a time. cairo writes no PNG by rows; libpng, which cairo's own stands on,
 * does.
 */
#ifndef PP_CHARTS_SHEET_PNG_BANDS_H
#define PP_CHARTS_SHEET_PNG_BANDS_H

#include <cairo.h>

#include "charts/sheet/bytes.h"

/* Adds the whole file to png. The drawing is a recording surface of one unit a pixel, whose
 * ground is painted; width, height and the rows of a band are at least 1, at most
 * 32767. */
cairo_status_t pp_png_bands_write(struct pp_bytes *png, cairo_surface_t *drawing,
                                  int width, int height, int rows);

#endif
