/* picture_png.h - a picture as a PNG file, with the pixels of the raster. */
#ifndef PP_CHARTS_PICTURE_PNG_H
#define PP_CHARTS_PICTURE_PNG_H

#include <cairo.h>

#include "model/pictures/raster.h"

/* Converts the raster to a cairo image. NULL: out of memory, or the raster is too
 * large. */
cairo_surface_t *pp_picture_png_surface(const struct pp_raster *raster);

/* Makes a complete PNG file of *length bytes, which the caller frees. */
enum pp_status pp_picture_png(unsigned char **bytes, size_t *length,
                              const struct pp_raster *raster, struct pp_error *err);

#endif
