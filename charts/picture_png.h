/* picture_png.h - a picture as a PNG file, pixel for pixel. */
#ifndef PP_CHARTS_PICTURE_PNG_H
#define PP_CHARTS_PICTURE_PNG_H

#include <cairo.h>

#include "model/pictures/raster.h"

/* A cairo image of the raster; NULL: out of memory, or too large. */
cairo_surface_t *pp_picture_png_surface(const struct pp_raster *raster);

/* The whole file: *length bytes, the caller's to free. */
enum pp_status pp_picture_png(unsigned char **bytes, size_t *length,
                              const struct pp_raster *raster, struct pp_error *err);

#endif
