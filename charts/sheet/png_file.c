/* png_file.c - passes the rows of an image to libpng. A large drawing is rendered and
 * passed band by band. */
#include "charts/sheet/png_file.h"

#include <math.h>
#include <png.h>
#include <stdint.h>
#include <stdlib.h>

/* State of a file while it is written. If libpng fails, its functions end in longjmp,
 * so everything to be freed is stored here. */
struct png_writer {
    struct pp_bytes *file;
    cairo_surface_t *drawing; /* NULL: the image is the whole drawing */
    cairo_surface_t *image;   /* whole drawing, or a band of it; not owned */
    int width, height;
    bool has_alpha;
    double dots_per_mm;
    png_structp png;
    png_infop info;
    unsigned char *row; /* red, green, blue, and alpha if the file has transparency */
    cairo_status_t status;
};

static void append_png_bytes(png_structp png, png_bytep bytes, size_t count)
{
    if (!pp_bytes_add(png_get_io_ptr(png), bytes, count))
        png_error(png, "memory is exhausted");
}

static void flush_nothing(png_structp png)
{
    (void)png;
}

/* Error handler that replaces libpng's own, which prints a message. */
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

static void draw_band(struct png_writer *writer, int first)
{
    cairo_t *cr = cairo_create(writer->image);
    cairo_set_source_surface(cr, writer->drawing, 0, -first);
    cairo_paint(cr);
    writer->status = cairo_status(cr);
    cairo_destroy(cr);
    cairo_surface_flush(writer->image);
}

/* One colour component of a pixel as PNG stores it. In cairo, colours are premultiplied
 * by alpha; in PNG they are not. */
static unsigned char colour(uint32_t pixel, int shift, uint32_t alpha)
{
    uint32_t value = pixel >> shift & 0xff;
    if (alpha == 255)
        return (unsigned char)value;
    return (unsigned char)(alpha ? (value * 255 + alpha / 2) / alpha : 0);
}

static void write_rows(struct png_writer *writer, int count)
{
    const unsigned char *data = cairo_image_surface_get_data(writer->image);
    size_t stride = (size_t)cairo_image_surface_get_stride(writer->image);
    for (int y = 0; y < count; y++) {
        const uint32_t *pixels =
            (const uint32_t *)(const void *)(data + (size_t)y * stride);
        unsigned char *to = writer->row;
        for (int x = 0; x < writer->width; x++) {
            uint32_t alpha = writer->has_alpha ? pixels[x] >> 24 : 255;
            for (int shift = 16; shift >= 0; shift -= 8)
                *to++ = colour(pixels[x], shift, alpha);
            if (writer->has_alpha)
                *to++ = (unsigned char)alpha;
        }
        png_write_row(writer->png, writer->row);
    }
}

static void write_png_head(struct png_writer *writer)
{
    png_set_IHDR(writer->png, writer->info, (png_uint_32)writer->width,
                 (png_uint_32)writer->height, 8,
                 writer->has_alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_color_16 white = {.red = 255, .green = 255, .blue = 255};
    if (writer->has_alpha)
        png_set_bKGD(writer->png, writer->info, &white);
    png_uint_32 dots_per_m = (png_uint_32)lrint(1000.0 * writer->dots_per_mm);
    if (dots_per_m > 0)
        png_set_pHYs(writer->png, writer->info, dots_per_m, dots_per_m,
                     PNG_RESOLUTION_METER);
    png_write_info(writer->png, writer->info);
}

static void write_picture(struct png_writer *writer)
{
    int most = cairo_image_surface_get_height(writer->image);
    if (setjmp(png_jmpbuf(writer->png))) {
        writer->status = CAIRO_STATUS_NO_MEMORY;
        return;
    }
    png_set_write_fn(writer->png, writer->file, append_png_bytes, flush_nothing);
    write_png_head(writer);
    for (int first = 0; first < writer->height; first += most) {
        if (writer->drawing)
            draw_band(writer, first);
        if (writer->status != CAIRO_STATUS_SUCCESS)
            return;
        int left = writer->height - first;
        write_rows(writer, left < most ? left : most);
    }
    png_write_end(writer->png, NULL);
}

static cairo_status_t write_png_file(struct png_writer *writer)
{
    writer->status = cairo_surface_status(writer->image);
    if (writer->status != CAIRO_STATUS_SUCCESS)
        return writer->status;
    writer->png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, leave, pass_over);
    if (writer->png)
        writer->info = png_create_info_struct(writer->png);
    writer->row = malloc((writer->has_alpha ? 4 : 3) * (size_t)writer->width);
    if (writer->info && writer->row)
        write_picture(writer);
    else
        writer->status = CAIRO_STATUS_NO_MEMORY;
    png_destroy_write_struct(&writer->png, &writer->info);
    free(writer->row);
    return writer->status;
}

cairo_status_t pp_png_file_of_image(struct pp_bytes *png, cairo_surface_t *image,
                                    double dots_per_mm)
{
    cairo_surface_flush(image);
    return write_png_file(&(struct png_writer){
        .file = png,
        .image = image,
        .width = cairo_image_surface_get_width(image),
        .height = cairo_image_surface_get_height(image),
        .has_alpha = cairo_image_surface_get_format(image) == CAIRO_FORMAT_ARGB32,
        .dots_per_mm = dots_per_mm});
}

cairo_status_t pp_png_file_in_bands(struct pp_bytes *png, cairo_surface_t *drawing,
                                    int width, int height, int rows, double dots_per_mm)
{
    cairo_surface_t *band = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width,
                                                       rows < height ? rows : height);
    cairo_status_t status =
        write_png_file(&(struct png_writer){.file = png,
                                            .drawing = drawing,
                                            .image = band,
                                            .width = width,
                                            .height = height,
                                            .dots_per_mm = dots_per_mm});
    cairo_surface_destroy(band);
    return status;
}
