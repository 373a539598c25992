/* test_png_file.c - PNG files have the pixels of the drawing, and its resolution. */
#include "tests/lib/near.h"

#include <stdlib.h>

#include "charts/sheet/png_file.h"

enum { WIDTH = 301, HEIGHT = 203 };

/* Lines, text, a fill without edges on pixel borders, and one fill of every colour. */
static void draw(cairo_surface_t *surface)
{
    cairo_t *cr = cairo_create(surface);
    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_paint(cr);
    cairo_pattern_t *shades = cairo_pattern_create_linear(0, 0, WIDTH, 90);
    cairo_pattern_add_color_stop_rgb(shades, 0, 0.9, 0.1, 0.3);
    cairo_pattern_add_color_stop_rgb(shades, 1, 0.2, 0.8, 1.0);
    cairo_set_source(cr, shades);
    cairo_rectangle(cr, 20.3, 30.7, 180.2, 90.4);
    cairo_fill(cr);
    cairo_pattern_destroy(shades);
    cairo_set_source_rgb(cr, 0, 0, 0);
    cairo_arc(cr, 150.5, 101.3, 88.8, 0.0, 5.5);
    cairo_stroke(cr);
    cairo_set_font_size(cr, 23.0);
    cairo_move_to(cr, 31.4, 141.7);
    cairo_show_text(cr, "Working plane");
    assert_int_equal(cairo_status(cr), CAIRO_STATUS_SUCCESS);
    cairo_destroy(cr);
}

struct png_reader {
    const struct pp_bytes *file;
    size_t at;
};

static cairo_status_t take(void *closure, unsigned char *bytes, unsigned int length)
{
    struct png_reader *reader = closure;
    if (reader->file->count - reader->at < length)
        return CAIRO_STATUS_READ_ERROR;
    memcpy(bytes, reader->file->list + reader->at, length);
    reader->at += length;
    return CAIRO_STATUS_SUCCESS;
}

static void the_bands_have_the_pixels_of_the_whole(void **state)
{
    (void)state;
    cairo_surface_t *whole =
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, WIDTH, HEIGHT);
    draw(whole);
    cairo_surface_flush(whole);
    const int rows[] = {1, 37, HEIGHT - 1, HEIGHT, 1000};
    for (int i = 0; i < 5; i++) {
        cairo_rectangle_t all = {0.0, 0.0, WIDTH, HEIGHT};
        cairo_surface_t *recorded =
            cairo_recording_surface_create(CAIRO_CONTENT_COLOR, &all);
        draw(recorded);
        struct pp_bytes png = {0};
        assert_int_equal(
            pp_png_file_in_bands(&png, recorded, WIDTH, HEIGHT, rows[i], 7.87),
            CAIRO_STATUS_SUCCESS);
        struct png_reader reader = {&png, 0};
        cairo_surface_t *back =
            cairo_image_surface_create_from_png_stream(take, &reader);
        assert_int_equal(cairo_surface_status(back), CAIRO_STATUS_SUCCESS);
        assert_int_equal(cairo_image_surface_get_width(back), WIDTH);
        assert_int_equal(cairo_image_surface_get_height(back), HEIGHT);
        int stride = cairo_image_surface_get_stride(whole);
        for (int y = 0; y < HEIGHT; y++) {
            const uint32_t *a =
                (const void *)(cairo_image_surface_get_data(whole) + y * stride);
            const uint32_t *b =
                (const void *)(cairo_image_surface_get_data(back)
                               + y * cairo_image_surface_get_stride(back));
            for (int x = 0; x < WIDTH; x++)
                assert_int_equal(a[x] & 0xFFFFFF, b[x] & 0xFFFFFF);
        }
        cairo_surface_destroy(back);
        cairo_surface_destroy(recorded);
        pp_bytes_clear(&png);
    }
    cairo_surface_destroy(whole);
}

/* 40 million white pixels need 160 MB of memory. */
static void a_blank_sheet_is_a_small_file(void **state)
{
    (void)state;
    cairo_rectangle_t all = {0.0, 0.0, 8000.0, 5000.0};
    cairo_surface_t *recorded =
        cairo_recording_surface_create(CAIRO_CONTENT_COLOR, &all);
    cairo_t *cr = cairo_create(recorded);
    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_paint(cr);
    cairo_destroy(cr);
    struct pp_bytes png = {0};
    assert_int_equal(pp_png_file_in_bands(&png, recorded, 8000, 5000, 100, 7.87),
                     CAIRO_STATUS_SUCCESS);
    assert_true(png.count < 160000000 / 200);
    cairo_surface_destroy(recorded);
    pp_bytes_clear(&png);
}

/* The pixels of an image with transparency are unchanged, and the file has the
 * resolution in dots per metre. */
static void transparency_and_resolution_are_in_the_file(void **state)
{
    (void)state;
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, 61, 47);
    cairo_t *cr = cairo_create(image);
    cairo_set_source_rgba(cr, 0.9, 0.2, 0.6, 0.37);
    cairo_rectangle(cr, 5.3, 7.7, 40.2, 30.4);
    cairo_fill(cr);
    cairo_destroy(cr);
    struct pp_bytes png = {0};
    assert_int_equal(pp_png_file_of_image(&png, image, 11.811), CAIRO_STATUS_SUCCESS);
    const unsigned char *phys = memmem(png.list, png.count, "pHYs", 4);
    assert_non_null(phys);
    const unsigned char dots[9] = {0, 0, 0x2e, 0x23, 0, 0, 0x2e, 0x23, 1}; /* 11811 */
    assert_memory_equal(phys + 4, dots, sizeof dots);
    struct png_reader reader = {&png, 0};
    cairo_surface_t *back = cairo_image_surface_create_from_png_stream(take, &reader);
    assert_int_equal(cairo_image_surface_get_format(back), CAIRO_FORMAT_ARGB32);
    int stride = cairo_image_surface_get_stride(image);
    assert_memory_equal(cairo_image_surface_get_data(back),
                        cairo_image_surface_get_data(image), stride * 47);
    cairo_surface_destroy(back);
    pp_bytes_clear(&png);

    assert_int_equal(pp_png_file_of_image(&png, image, 0.0), CAIRO_STATUS_SUCCESS);
    assert_null(
        memmem(png.list, png.count, "pHYs", 4)); /* a picture without a physical size */
    pp_bytes_clear(&png);
    cairo_surface_destroy(image);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_bands_have_the_pixels_of_the_whole),
        cmocka_unit_test(a_blank_sheet_is_a_small_file),
        cmocka_unit_test(transparency_and_resolution_are_in_the_file),
    };
    add_tests(tests, NULL, NULL);
}
