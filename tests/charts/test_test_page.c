/* test_test_page.c - the page for checking a printer has true scale: its rulers are
 * measured in the pixels of its PNG, at ten per millimetre. */
#include "tests/lib/near.h"

#include <stdlib.h>

#include <cairo.h>

#include "charts/test_page.h"

enum { PIXELS_PER_MM = 10 };

struct page_bytes {
    const unsigned char *at;
    size_t left;
};

static cairo_status_t take_bytes(void *closure, unsigned char *bytes,
                                 unsigned int length)
{
    struct page_bytes *file = closure;
    if (file->left < length)
        return CAIRO_STATUS_READ_ERROR;
    memcpy(bytes, file->at, length);
    file->at += length;
    file->left -= length;
    return CAIRO_STATUS_SUCCESS;
}

/* The caller destroys the surface. */
static cairo_surface_t *draw_test_page(void)
{
    const struct pp_sheet sheet = {
        .format = PP_CHART_PNG, .paper = PP_PAPER_A4, .dpi = 25.4 * PIXELS_PER_MM};
    struct pp_canvas *canvas;
    struct pp_error err;
    struct page_bytes file;
    assert_int_equal(pp_canvas_create(&canvas, &sheet, &err), PP_OK);
    assert_int_equal(pp_test_page_draw(canvas, &err), PP_OK);
    assert_int_equal(pp_canvas_finish(canvas, &file.at, &file.left, &err), PP_OK);
    cairo_surface_t *image =
        cairo_image_surface_create_from_png_stream(take_bytes, &file);
    assert_int_equal(cairo_surface_status(image), CAIRO_STATUS_SUCCESS);
    pp_canvas_destroy(canvas);
    return image;
}

static bool is_dark(cairo_surface_t *image, int x, int y)
{
    const unsigned char *row =
        cairo_image_surface_get_data(image)
        + (size_t)y * (size_t)cairo_image_surface_get_stride(image);
    uint32_t pixel;
    memcpy(&pixel, row + 4 * (size_t)x, sizeof pixel);
    return (pixel & 0xFF) < 0x80;
}

/* Longest dark run in row or column `line`, within its first `length` pixels. */
static int longest_run(cairo_surface_t *image, int line, int length, bool down)
{
    int longest = 0, run = 0;
    for (int i = 0; i < length; i++) {
        run = is_dark(image, down ? line : i, down ? i : line) ? run + 1 : 0;
        longest = run > longest ? run : longest;
    }
    return longest;
}

static void the_rulers_are_100_mm_long(void **state)
{
    (void)state;
    cairo_surface_t *image = draw_test_page();
    int width = cairo_image_surface_get_width(image);
    int height = cairo_image_surface_get_height(image);
    assert_int_equal(width, 210 * PIXELS_PER_MM);
    assert_int_equal(height, 297 * PIXELS_PER_MM);
    /* The longest lines of the upper left part are the rulers with their last ticks,
     * which are 0.12 mm wide; the tick at 0 of the other ruler adds 5 mm. */
    int across = 0, down = 0;
    for (int y = 0; y < height / 2; y++)
        across = (int)fmax(across, longest_run(image, y, width * 2 / 3, false));
    for (int x = 0; x < width / 3; x++)
        down = (int)fmax(down, longest_run(image, x, height / 2, true));
    assert_near(across, 105 * PIXELS_PER_MM, 3.0);
    assert_near(down, 105 * PIXELS_PER_MM, 3.0);
    cairo_surface_destroy(image);
}

/* Every shade of the grey wedge is present, from black to white. */
static void the_grey_wedge_goes_from_black_to_white(void **state)
{
    (void)state;
    static const int shares[] = {100, 90, 80, 70, 60, 50, 40, 30, 20, 12, 6, 0};
    cairo_surface_t *image = draw_test_page();
    int width = cairo_image_surface_get_width(image);
    int height = cairo_image_surface_get_height(image);
    int *count = calloc(256, sizeof *count);
    assert_non_null(count);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            const unsigned char *pixel =
                cairo_image_surface_get_data(image)
                + (size_t)y * (size_t)cairo_image_surface_get_stride(image)
                + 4 * (size_t)x;
            count[pixel[0]]++;
        }
    /* A twelfth of the width, 12 mm high, without its edges. */
    int field = width / 13 * 11 * PIXELS_PER_MM;
    for (int i = 0; i < 12; i++) {
        int grey = (int)lround(255.0 * (1.0 - shares[i] / 100.0)), found = 0;
        for (int k = grey - 1; k <= grey + 1; k++)
            found += k >= 0 && k < 256 ? count[k] : 0;
        assert_true(found > 0.9 * field);
    }
    free(count);
    cairo_surface_destroy(image);
}

static void a_machine_with_fonts_has_all_its_letters(void **state)
{
    (void)state;
    char family[128];
    int missing = pp_test_page_font(family, sizeof family);
    assert_true(family[0] != '\0');
    assert_int_equal(missing, 0);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_rulers_are_100_mm_long),
        cmocka_unit_test(the_grey_wedge_goes_from_black_to_white),
        cmocka_unit_test(a_machine_with_fonts_has_all_its_letters),
    };
    add_tests(tests, NULL, NULL);
}
