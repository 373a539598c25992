/* test_picture.c - pictures as files: written files read back, and other files are
 * rejected. */
#include "tests/lib/near.h"

#include <stdio.h>
#include <stdlib.h>

#include "model/pictures/picture_hdr.h"
#include "model/pictures/picture_pfm.h"

/* A file in memory, with its length. */
struct file {
    char *bytes;
    size_t length;
};

static struct file hdr_of(const struct pp_picture *picture,
                          const struct pp_hdr_notes *notes)
{
    struct file file;
    FILE *out = open_memstream(&file.bytes, &file.length);
    assert_non_null(out);
    assert_int_equal(pp_picture_hdr_write(out, picture, notes, NULL), PP_OK);
    assert_int_equal(fclose(out), 0);
    return file;
}

static enum pp_status read_hdr(struct pp_picture *picture, struct pp_hdr_notes *notes,
                               const char *bytes, size_t length, struct pp_error *err)
{
    /* A copy of exactly this length, so that a read beyond its end is detected. */
    unsigned char *copy = malloc(length ? length : 1);
    assert_non_null(copy);
    memcpy(copy, bytes, length);
    enum pp_status status = pp_picture_hdr_read(picture, notes, copy, length, err);
    free(copy);
    return status;
}

/* Pseudo-random numbers from 0 to 1. */
static double chance(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0;
}

/* Smooth parts, uniform parts and noise, over twelve orders of magnitude. */
static void paint(struct pp_picture *picture)
{
    uint32_t state = 7;
    for (int y = 0; y < picture->height; y++)
        for (int x = 0; x < picture->width; x++) {
            float *rgb = pp_picture_at(picture, x, y);
            double scale = pow(10.0, 12.0 * y / picture->height - 6.0);
            for (int i = 0; i < 3; i++)
                rgb[i] = (float)(scale
                                 * (x % 40 < 20   ? 0.7
                                    : x % 40 < 30 ? 0.1 + 0.02 * (x % 40)
                                                  : chance(&state)));
        }
}

/* Eight bits for the brightest channel, including its leading bit: half a step is at
 * most 1/256 of the value. */
static void a_pixel_keeps_to_half_a_per_cent_of_its_brightest_channel(void **state)
{
    (void)state;
    static const int widths[] = {1, 7, 8, 9, 127, 128, 129, 300, 40000};
    for (size_t i = 0; i < sizeof widths / sizeof *widths; i++) {
        struct pp_picture picture, back;
        struct pp_hdr_notes notes;
        struct pp_error err = {0};
        assert_int_equal(pp_picture_init(&picture, widths[i], 11, NULL), PP_OK);
        paint(&picture);
        struct file file = hdr_of(&picture, NULL);
        if (read_hdr(&back, &notes, file.bytes, file.length, &err) != PP_OK)
            fail_msg("%s", err.message);
        assert_int_equal(back.width, widths[i]);
        assert_int_equal(back.height, 11);
        assert_near(notes.exposure, 1.0, 0.0);
        for (int y = 0; y < 11; y++)
            for (int x = 0; x < widths[i]; x++) {
                struct pp_rgb was = pp_picture_rgb(&picture, x, y);
                struct pp_rgb is = pp_picture_rgb(&back, x, y);
                double half_step = pp_rgb_most(was) / 256.0 * (1.0 + 1e-6);
                assert_near(is.r, was.r, half_step);
                assert_near(is.g, was.g, half_step);
                assert_near(is.b, was.b, half_step);
            }
        free(file.bytes);
        pp_picture_clear(&back);
        pp_picture_clear(&picture);
    }
}

/* A grey of 1 has the mantissa 128 = 0.5 x 256 and the exponent 1 + 128. */
static void the_bytes_are_those_of_the_format(void **state)
{
    (void)state;
    struct pp_picture picture;
    assert_int_equal(pp_picture_init(&picture, 9, 2, NULL), PP_OK);
    for (int i = 0; i < 27; i++)
        picture.rgb[i] = 1.0f;
    float *second = pp_picture_at(&picture, 4, 1);
    second[1] = 0.75f;
    second[2] = -3.0f;
    struct pp_hdr_notes notes = {.exposure = 0.25, .software = "pepperpot"};
    strcpy(notes.view, "-vtv -vp 1 2 3");
    struct file file = hdr_of(&picture, &notes);
    static const char header[] = "#?RADIANCE\nSOFTWARE= pepperpot\n"
                                 "VIEW= -vtv -vp 1 2 3\nEXPOSURE= 2.500000000e-01\n"
                                 "FORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 9\n";
    /* Two compressed rows: 2, 2, the width; then runs of 9 for each channel. The second
     * row has one pixel with a green of 0.75 of 0.5 x 2, so 96; blue and the other
     * pixels are black. */
    static const unsigned char first_row[] = {2,       2,   0,       9,   128 + 9, 128,
                                              128 + 9, 128, 128 + 9, 128, 128 + 9, 129};
    assert_memory_equal(file.bytes, header, sizeof header - 1);
    assert_memory_equal(file.bytes + sizeof header - 1, first_row, sizeof first_row);

    struct pp_picture back;
    struct pp_hdr_notes said;
    assert_int_equal(read_hdr(&back, &said, file.bytes, file.length, NULL), PP_OK);
    assert_near(said.exposure, 0.25, 0.0);
    assert_string_equal(said.view, "-vtv -vp 1 2 3");
    struct pp_rgb odd = pp_picture_rgb(&back, 4, 1);
    assert_near(odd.r, 0.0, 0.75 / 128.0);
    assert_near(odd.g, 0.75, 0.75 / 128.0);
    assert_near(odd.b, 0.0, 0.75 / 128.0);
    pp_picture_clear(&back);
    free(file.bytes);

    /* Unscaled values, with an explicit exposure of 1. */
    static const char plain[] = "#?RADIANCE\nEXPOSURE= 1.000000000e+00\n"
                                "FORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 9\n";
    file = hdr_of(&picture, NULL);
    assert_memory_equal(file.bytes, plain, sizeof plain - 1);
    assert_int_equal(read_hdr(&back, &said, file.bytes, file.length, NULL), PP_OK);
    assert_near(said.exposure, 1.0, 0.0);
    pp_picture_clear(&back);
    free(file.bytes);
    pp_picture_clear(&picture);
}

static void invalid_light_is_black_and_excessive_light_is_clipped(void **state)
{
    (void)state;
    static const float odd[][3] = {{0.0f, 0.0f, 0.0f},     {NAN, 1.0f, 1.0f},
                                   {INFINITY, 1.0f, 1.0f}, {-1.0f, -2.0f, -3.0f},
                                   {1e-44f, 0.0f, 0.0f},   {3e38f, 1.0f, 1.0f}};
    struct pp_picture picture, back;
    struct pp_hdr_notes notes;
    assert_int_equal(pp_picture_init(&picture, 6, 1, NULL), PP_OK);
    memcpy(picture.rgb, odd, sizeof odd);
    struct file file = hdr_of(&picture, NULL);
    assert_int_equal(read_hdr(&back, &notes, file.bytes, file.length, NULL), PP_OK);
    for (int x = 0; x < 5; x++)
        assert_near(pp_rgb_most(pp_picture_rgb(&back, x, 0)), 0.0, 0.0);
    assert_true(pp_picture_rgb(&back, 5, 0).r > 1.6e38);
    free(file.bytes);
    pp_picture_clear(&back);
    pp_picture_clear(&picture);
}

#define HEAD(size) "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" size "\n"
#define A "\x80\x40\x20\x81" /* (1, 0.5, 0.25), and half a step */
#define B "\x20\x40\x80\x81"

/* Older formats: uncompressed pixels, and (1, 1, 1, n) for n repetitions of the last
 * pixel. Other orders of rows and columns. */
static void old_pictures_and_those_that_run_another_way_are_read(void **state)
{
    (void)state;
    static const struct {
        const char *bytes;
        size_t length;
        int blue[4]; /* for each of 2 x 2 pixels: is it B? */
    } files[] = {
#define FILE_OF(text) text, sizeof text - 1
        {FILE_OF(HEAD("-Y 2 +X 2") A B B A), {0, 1, 1, 0}},
        {FILE_OF(HEAD("-Y 2 +X 2") A "\1\1\1\1" B B), {0, 0, 1, 1}},
        {FILE_OF(HEAD("+Y 2 +X 2") A B A A), {0, 0, 0, 1}},
        {FILE_OF(HEAD("-Y 2 -X 2") A B A A), {1, 0, 0, 0}},
        {FILE_OF("#?RGBE\r\nEXPOSURE=2\nEXPOSURE=3\nNOTE=no matter\n\r\n"
                 "-Y 2 +X 2\n" A A A B "and more"),
         {0, 0, 0, 1}},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct pp_picture picture;
        struct pp_hdr_notes notes;
        struct pp_error err = {0};
        if (read_hdr(&picture, &notes, files[i].bytes, files[i].length, &err) != PP_OK)
            fail_msg("%zu: %s", i, err.message);
        for (int k = 0; k < 4; k++) {
            struct pp_rgb rgb = pp_picture_rgb(&picture, k % 2, k / 2);
            assert_near(rgb.b, (files[i].blue[k] ? 128.5 : 32.5) / 128.0, 0.0);
        }
        assert_near(notes.exposure, i == 4 ? 6.0 : 1.0, 0.0);
        pp_picture_clear(&picture);
    }
}

static void files_that_are_no_pictures_are_rejected_by_line_or_row(void **state)
{
    (void)state;
    static const struct {
        const char *bytes;
        size_t length;
        const char *says;
    } files[] = {
        {FILE_OF(""), "line 1"},
        {FILE_OF("P6\n2 2\n255\n"), "line 1: this is not a Radiance picture"},
        {FILE_OF("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n"),
         "line 3: the header is incomplete"},
        {FILE_OF("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 2 +X 2\n" A A A A),
         "line 2: the format"},
        {FILE_OF("#?RADIANCE\nEXPOSURE=-1\n\n-Y 2 +X 2\n" A A A A),
         "line 2: the expos"},
        {FILE_OF("#?RADIANCE\nEXPOSURE=1e300\nEXPOSURE=1e300\n\n"),
         "line 3: the expos"},
        {FILE_OF(HEAD("+X 2 -Y 2") A A A A), "line 4: the size is missing"},
        {FILE_OF(HEAD("-Y 0 +X 2") A A A A), "line 4: the size is missing"},
        {FILE_OF(HEAD("-Y 2 +X 2 here") A A A A), "line 4: the size is missing"},
        {FILE_OF(HEAD("-Y 65536 +X 2") A A A A), "cut off"},
        {FILE_OF(HEAD("-Y 2 +X 999999") A A A A), "999999 x 2 pixels"},
        {FILE_OF(HEAD("-Y 2 +X 2") A A A), "row 2 of 2"},
        {FILE_OF(HEAD("-Y 2 +X 2") A "\1\1\1\2" A A), "row 1 of 2"},
        {FILE_OF(HEAD("-Y 1 +X 2") "\1\1\1\1" A), "row 1 of 1"},
        {FILE_OF(HEAD("-Y 1 +X 9") "\2\2\0\10\x89\1\x89\1\x89\1\x89\1"), "row 1 of 1"},
        {FILE_OF(HEAD("-Y 1 +X 9") "\2\2\0\11\x8a\1\x89\1\x89\1\x89\1"), "row 1 of 1"},
        {FILE_OF(HEAD("-Y 1 +X 9") "\2\2\0\11\0\1\x89\1\x89\1\x89\1"), "row 1 of 1"},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct pp_picture picture;
        struct pp_hdr_notes notes;
        struct pp_error err = {0};
        assert_int_equal(
            read_hdr(&picture, &notes, files[i].bytes, files[i].length, &err),
            PP_BAD_INPUT);
        assert_null(picture.rgb);
        if (!strstr(err.message, files[i].says))
            fail_msg("%zu: \"%s\", expected \"%s\"", i, err.message, files[i].says);
    }
}

static void a_file_that_is_cut_off_anywhere_is_refused(void **state)
{
    (void)state;
    struct pp_picture picture, back;
    struct pp_hdr_notes notes = {.view = "-vth"};
    assert_int_equal(pp_picture_init(&picture, 61, 7, NULL), PP_OK);
    paint(&picture);
    struct file file = hdr_of(&picture, &notes);
    for (size_t length = 0; length < file.length; length++) {
        struct pp_error err = {0};
        assert_int_equal(read_hdr(&back, &notes, file.bytes, length, &err),
                         PP_BAD_INPUT);
        assert_true(err.message[0] != '\0');
    }
    free(file.bytes);
    pp_picture_clear(&picture);
}

static void float_maps_are_numbers_from_the_bottom_up(void **state)
{
    (void)state;
    struct pp_picture picture;
    assert_int_equal(pp_picture_init(&picture, 1, 2, NULL), PP_OK);
    static const float rgb[] = {1.0f, 0.5f, -2.0f, 0.0f, 1e-40f, 0.15625f};
    memcpy(picture.rgb, rgb, sizeof rgb);
    struct file file;
    FILE *out = open_memstream(&file.bytes, &file.length);
    assert_int_equal(pp_picture_pfm_write(out, &picture, NULL), PP_OK);
    fclose(out);
    /* 1e-40 is 71362 x 2^-149; 0.15625 is 1.25 x 2^-3: exponent 124, mantissa 2^21. */
    static const char expected[] = "PF\n1 2\n-1.0\n"
                                   "\0\0\0\0"
                                   "\xc2\x16\x01\0"
                                   "\0\0\x20\x3e"
                                   "\0\0\x80\x3f"
                                   "\0\0\0\x3f"
                                   "\0\0\0\xc0";
    assert_int_equal(file.length, sizeof expected - 1);
    assert_memory_equal(file.bytes, expected, file.length);
    free(file.bytes);
    pp_picture_clear(&picture);
}

static void a_full_disk_is_reported(void **state)
{
    (void)state;
    struct pp_picture picture;
    struct pp_error err = {0};
    FILE *full = fopen("/dev/full", "w");
    if (!full)
        skip();
    assert_int_equal(pp_picture_init(&picture, 300, 200, NULL), PP_OK);
    paint(&picture);
    assert_int_equal(pp_picture_hdr_write(full, &picture, NULL, &err), PP_SYSTEM);
    assert_int_equal(pp_picture_pfm_write(full, &picture, &err), PP_SYSTEM);
    fclose(full);
    pp_picture_clear(&picture);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pixel_keeps_to_half_a_per_cent_of_its_brightest_channel),
        cmocka_unit_test(the_bytes_are_those_of_the_format),
        cmocka_unit_test(invalid_light_is_black_and_excessive_light_is_clipped),
        cmocka_unit_test(old_pictures_and_those_that_run_another_way_are_read),
        cmocka_unit_test(files_that_are_no_pictures_are_rejected_by_line_or_row),
        cmocka_unit_test(a_file_that_is_cut_off_anywhere_is_refused),
        cmocka_unit_test(float_maps_are_numbers_from_the_bottom_up),
        cmocka_unit_test(a_full_disk_is_reported),
    };
    add_tests(tests, NULL, NULL);
}
