/* picture_png.c - converts a raster to a cairo image, and encodes the image as a PNG
 * file. */
#include "charts/picture_png.h"

#include <stdint.h>

#include "charts/sheet/png_file.h"

cairo_surface_t *pp_picture_png_surface(const struct pp_raster *raster)
{
    cairo_surface_t *image =
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, raster->width, raster->height);
    if (cairo_surface_status(image) != CAIRO_STATUS_SUCCESS) {
        cairo_surface_destroy(image);
        return NULL;
    }
    unsigned char *data = cairo_image_surface_get_data(image);
    size_t stride = (size_t)cairo_image_surface_get_stride(image);
    for (int y = 0; y < raster->height; y++) {
        uint32_t *row = (uint32_t *)(void *)(data + (size_t)y * stride);
        for (int x = 0; x < raster->width; x++) {
            const unsigned char *rgb = pp_raster_at(raster, x, y);
            row[x] = (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2];
        }
    }
    cairo_surface_mark_dirty(image);
    return image;
}

enum pp_status pp_picture_png(unsigned char **bytes, size_t *length,
                              const struct pp_raster *raster, struct pp_error *err)
{
    struct pp_bytes file = {0};
    cairo_surface_t *image = pp_picture_png_surface(raster);
    if (!image)
        return pp_fail(err, PP_SYSTEM,
                       "cannot write a picture of %d x %d pixels: it is too large, or "
                       "memory is exhausted",
                       raster->width, raster->height);
    cairo_status_t status = pp_png_file_of_image(&file, image, 0.0);
    cairo_surface_destroy(image);
    if (status != CAIRO_STATUS_SUCCESS)
        pp_bytes_clear(&file);
    if (status == CAIRO_STATUS_NO_MEMORY)
        return pp_fail_memory(err);
    if (status != CAIRO_STATUS_SUCCESS)
        return pp_fail(err, PP_SYSTEM, "cannot write the picture: %s",
                       cairo_status_to_string(status));
    *bytes = file.list;
    *length = file.count;
    return PP_OK;
}
