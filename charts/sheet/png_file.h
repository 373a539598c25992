/* png_file.h - a drawing as a PNG file, with its resolution.
 *
 * The file is written by libpng, because cairo cannot store the resolution or write row
 * by row.
 */
#ifndef PP_CHARTS_SHEET_PNG_FILE_H
#define PP_CHARTS_SHEET_PNG_FILE_H

#include <cairo.h>

#include "charts/sheet/bytes.h"

/* Appends the PNG file of an image surface to *png. Formats: CAIRO_FORMAT_RGB24, or
 * ARGB32 for a file with transparency. dots_per_mm: 0 for a picture without a size on
 * paper. */
cairo_status_t pp_png_file_of_image(struct pp_bytes *png, cairo_surface_t *image,
                                    double dots_per_mm);

/* Writes a drawing that is too large for an image in memory. The drawing is a recording
 * surface of one unit per pixel with a painted background; it is rendered again for
 * each band of rows. Width, height and rows: 1 to 32767. */
cairo_status_t pp_png_file_in_bands(struct pp_bytes *png, cairo_surface_t *drawing,
                                    int width, int height, int rows,
                                    double dots_per_mm);

#endif
