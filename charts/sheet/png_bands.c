/* png_bands.c - draws band by band, and hands libpng the rows. */
#include "charts/sheet/png_bands.h"

#include <png.h>
#include <stdint.h>
#include <stdlib.h>

/* A file in the making. libpng leaves a function that fails by a long jump, so that
 * whatever is to be freed is here. */
struct band_writer {
    struct pp_bytes *file;
    cairo_surface_t *drawing, *band;
    int width, height;
    png_structp png;
    png_infop info;
    unsigned char *row; /* red, green, blue */
    cairo_status_t status;
};

static void append(png_structp png, png_bytep bytes, size_t count)
{
    if (!pp_bytes_add(png_get_io_ptr(png), bytes, count))
        png_error(png, "memory is out");
}

static void flush_nothing(png_structp png)
{
    (void)png;
}

/* libpng's own would print. */
static void leave(png_structp png, png_const_charp message)
{
    (void)message;
    longjmp(png_jmpbuf(png), 1);
}

static void pass_over(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

static void draw_band(struct band_writer *writer, int first)
{
    cairo_t *cr = cairo_create(writer->band);
    cairo_set_source_surface(cr, writer->drawing, 0, -first);
    cairo_paint(cr);
    writer->status = cairo_status(cr);
    cairo_destroy(cr);
    cairo_surface_flush(writer->band);
}

static void write_rows(struct band_writer *writer, int count)
{
    const unsigned char *data = cairo_image_surface_get_data(writer->band);
    size_t stride = (size_t)cairo_image_surface_get_stride(writer->band);
    for (int y = 0; y < count; y++) {
        const uint32_t *pixels =
            (const uint32_t *)(const void *)(data + (size_t)y * stride);
        unsigned char *to = writer->row;
        for (int x = 0; x < writer->width; x++)
            for (int shift = 16; shift >= 0; shift -= 8)
                *to++ = (unsigned char)(pixels[x] >> shift);
        png_write_row(writer->png, writer->row);
    }
}

/* A row differs little from the one above: that filter alone is tried. */
static void write_picture(struct band_writer *writer)
{
    int most = cairo_image_surface_get_height(writer->band);
    if (setjmp(png_jmpbuf(writer->png))) {
        writer->status = CAIRO_STATUS_NO_MEMORY;
        return;
    }
    png_set_write_fn(writer->png, writer->file, append, flush_nothing);
    png_set_IHDR(writer->png, writer->info, (png_uint_32)writer->width,
                 (png_uint_32)writer->height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_filter(writer->png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_write_info(writer->png, writer->info);
    for (int first = 0; first < writer->height; first += most) {
        draw_band(writer, first);
        if (writer->status != CAIRO_STATUS_SUCCESS)
            return;
        int left = writer->height - first;
        write_rows(writer, left < most ? left : most);
    }
    png_write_end(writer->png, NULL);
}

cairo_status_t pp_png_bands_write(struct pp_bytes *png, cairo_surface_t *drawing,
                                  int width, int height, int rows)
{
    struct band_writer writer = {
        .file = png,
        .drawing = drawing,
        .band = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width,
                                           rows < height ? rows : height),
        .width = width,
        .height = height,
        .png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, leave, pass_over),
        .row = malloc(3 * (size_t)width)};
    if (writer.png)
        writer.info = png_create_info_struct(writer.png);
    writer.status = cairo_surface_status(writer.band);
    if (!writer.info || !writer.row)
        writer.status = CAIRO_STATUS_NO_MEMORY;
    if (writer.status == CAIRO_STATUS_SUCCESS)
        write_picture(&writer);
    png_destroy_write_struct(&writer.png, &writer.info);
    cairo_surface_destroy(writer.band);
    free(writer.row);
    return writer.status;
}
