/* test_false_colour.c - numbers as colours, and lines of equal value. */
#include "model/pictures/false_colour.h"

#include "model/pictures/iso_lines.h"
#include "tests/lib/near.h"

static struct pp_picture picture_of(int width, int height,
                                    double value(double x, double y))
{
    struct pp_picture picture;
    assert_int_equal(pp_picture_init(&picture, width, height, NULL), PP_OK);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            for (int i = 0; i < 3; i++)
                pp_picture_at(&picture, x, y)[i] = (float)value(x + 0.5, y + 0.5);
    return picture;
}

/* Relative luminance of an sRGB colour [IEC61966]. */
static double light_of(const unsigned char rgb[3])
{
    static const double weights[3] = {0.2126, 0.7152, 0.0722};
    double sum = 0.0;
    for (int i = 0; i < 3; i++) {
        double v = rgb[i] / 255.0;
        sum += weights[i] * (v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4));
    }
    return sum;
}

static void colours_grow_lighter_all_the_way(void **state)
{
    (void)state;
    unsigned char before[3], rgb[3];
    pp_false_colour(0.0, before);
    for (int i = 1; i <= 40; i++) {
        pp_false_colour(i / 40.0, rgb);
        assert_true(light_of(rgb) > light_of(before));
        memcpy(before, rgb, 3);
    }
    pp_false_colour(0.0, rgb);
    assert_true(light_of(rgb) < 0.03);
    pp_false_colour(1.0, rgb);
    assert_true(light_of(rgb) > 0.7 && light_of(rgb) < 0.97);
}

/* [GREEN11] eq. 2 by hand in the middle, lambda 0.5: phi = 2 pi (1/6 + 1 - 0.75) = 150
 * degrees, a = 1/8; red = 0.5 + 0.125 (0.14861 * 0.8660 + 1.78277 * 0.5) = 0.6275,
 * green = 0.5 + 0.125 (0.29227 * 0.8660 - 0.90649 * 0.5) = 0.4750, blue = 0.5 - 0.125 *
 * 1.97294 * 0.8660 = 0.2864. */
static void the_middle_has_the_published_colour(void **state)
{
    (void)state;
    unsigned char rgb[3];
    pp_false_colour(0.5, rgb);
    assert_int_equal(rgb[0], 160);
    assert_int_equal(rgb[1], 121);
    assert_int_equal(rgb[2], 73);
}

static double ramp(double x, double y)
{
    (void)y;
    return 0.3 * pow(10.0, 3.0 * x / 200.0); /* 0.3 to 300 */
}

static void a_scale_ends_at_round_numbers(void **state)
{
    (void)state;
    struct pp_picture picture = picture_of(200, 5, ramp);
    pp_picture_at(&picture, 7, 1)[0] = pp_picture_at(&picture, 7, 1)[1] = NAN;
    pp_picture_at(&picture, 9, 1)[1] = 1e9f; /* one very bright pixel of 1000 */
    struct pp_false_colour_scale scale;
    assert_int_equal(pp_false_colour_scale_fit(&scale, &picture, 2.0, true, NULL),
                     PP_OK);
    assert_near(scale.low, 0.5, 1e-12);
    assert_near(scale.high, 1000.0, 1e-9);
    double levels[PP_FALSE_COLOUR_LEVELS_MOST];
    assert_int_equal(pp_false_colour_scale_levels(&scale, levels), 11);
    static const double round[] = {0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};
    for (int i = 0; i < 11; i++)
        assert_near(levels[i], round[i], 1e-12 * round[i]);
    assert_near(pp_false_colour_scale_at(&scale, sqrt(500.0)), 0.5, 1e-12);
    assert_near(pp_false_colour_scale_at(&scale, 0.0), 0.0, 0.0);
    assert_near(pp_false_colour_scale_at(&scale, 1e5), 1.0, 0.0);

    assert_int_equal(pp_false_colour_scale_fit(&scale, &picture, 2.0, false, NULL),
                     PP_OK);
    assert_near(scale.low, 0.0, 0.0);
    assert_near(pp_false_colour_scale_at(&scale, 250.0), 0.25, 1e-12);
    assert_int_equal(pp_false_colour_scale_levels(&scale, levels), 11);
    assert_near(levels[3], 300.0, 1e-9);
    pp_picture_clear(&picture);
}

static double black(double x, double y)
{
    return 0.0 * x * y;
}

static void a_black_picture_has_a_scale_all_the_same(void **state)
{
    (void)state;
    struct pp_picture picture = picture_of(4, 3, black);
    struct pp_false_colour_scale scale;
    for (int logarithmic = 0; logarithmic < 2; logarithmic++) {
        assert_int_equal(
            pp_false_colour_scale_fit(&scale, &picture, 1.0, logarithmic, NULL), PP_OK);
        assert_true(scale.low < scale.high);
        double levels[PP_FALSE_COLOUR_LEVELS_MOST];
        assert_true(pp_false_colour_scale_levels(&scale, levels) >= 2);
    }
    pp_picture_clear(&picture);
}

/* ---- lines ---- */

/* A hill whose level 1 is the circle of radius 31.7 about (60.2, 50.9). */
static double hill(double x, double y)
{
    double d = ((x - 60.2) * (x - 60.2) + (y - 50.9) * (y - 50.9)) / (31.7 * 31.7);
    return exp(1.0 - d);
}

static void lines_of_a_hill_are_circles(void **state)
{
    (void)state;
    struct pp_picture picture = picture_of(120, 100, hill);
    struct pp_curve_list lines = {0};
    const double level = 1.0;
    /* A chord across a pixel deviates from the curve by 1/8 of its curvature: below
     * 0.02 pixels. */
    assert_int_equal(
        pp_iso_lines(&lines, &picture, NULL, 1.0, &level, 1, 0.0, 3.0, NULL), PP_OK);
    assert_int_equal(lines.count, 1);
    assert_true(lines.list[0].closed);
    assert_near(lines.list[0].level, 1.0, 0.0);
    for (int i = 0; i < lines.list[0].count; i++)
        assert_near(hypot(lines.list[0].xy[i][0] - 60.2, lines.list[0].xy[i][1] - 50.9),
                    31.7, 0.02);
    assert_relative(pp_curve_length(&lines.list[0]), 2.0 * M_PI * 31.7, 0.002);
    /* The brighter side is on the left as seen, with y down: clockwise in the usual
     * orientation. */
    assert_relative(pp_curve_list_area(&lines), -M_PI * 31.7 * 31.7, 0.003);
    pp_curve_list_clear(&lines);

    /* In another unit the line is the same. */
    const double per_cent = 100.0;
    struct pp_curve_list again = {0};
    assert_int_equal(
        pp_iso_lines(&lines, &picture, NULL, 1.0, &level, 1, 0.0, 3.0, NULL), PP_OK);
    assert_int_equal(
        pp_iso_lines(&again, &picture, NULL, 100.0, &per_cent, 1, 0.0, 3.0, NULL),
        PP_OK);
    assert_int_equal(again.count, 1);
    assert_int_equal(again.list[0].count, lines.list[0].count);
    assert_near(again.list[0].xy[7][0], lines.list[0].xy[7][0], 1e-9);
    pp_curve_list_clear(&again);
    pp_curve_list_clear(&lines);

    /* A line that the picture's edge cuts is open and stays inside. */
    const double low = exp(1.0 - 4.0);
    assert_int_equal(pp_iso_lines(&lines, &picture, NULL, 1.0, &low, 1, 0.0, 3.0, NULL),
                     PP_OK);
    assert_true(lines.count >= 2);
    for (int k = 0; k < lines.count; k++) {
        assert_false(lines.list[k].closed);
        for (int i = 0; i < lines.list[k].count; i++) {
            const double *at = lines.list[k].xy[i];
            assert_true(at[0] >= 0.0 && at[0] <= 120.0 && at[1] >= 0.0
                        && at[1] <= 100.0);
            assert_near(hypot(at[0] - 60.2, at[1] - 50.9), 2.0 * 31.7, 0.02);
        }
    }
    pp_curve_list_clear(&lines);
    pp_picture_clear(&picture);
}

/* Two walls, one twice as bright: a level between them is in neither. */
static double step(double x, double y)
{
    return (x < 30.0 ? 1.0 : 2.0) * (1.0 + 0.001 * y);
}

static void lines_end_where_surfaces_meet(void **state)
{
    (void)state;
    struct pp_picture picture = picture_of(60, 40, step);
    int tags[60 * 40];
    for (int i = 0; i < 60 * 40; i++)
        tags[i] = i % 60 < 30 ? 7 : 8;
    const double levels[] = {1.02, 1.5};
    for (int known = 0; known < 2; known++) {
        struct pp_curve_list lines = {0};
        assert_int_equal(pp_iso_lines(&lines, &picture, known ? tags : NULL, 1.0,
                                      levels, 2, 1.0, 3.0, NULL),
                         PP_OK);
        /* 1.02 crosses the darker wall at y = 20; there is no line for 1.5. */
        assert_int_equal(lines.count, 1);
        assert_near(lines.list[0].level, 1.02, 0.0);
        for (int i = 0; i < lines.list[0].count; i++) {
            assert_near(lines.list[0].xy[i][1], 20.0, 0.05);
            assert_true(lines.list[0].xy[i][0] < 30.0);
        }
        pp_curve_list_clear(&lines);
    }
    pp_picture_clear(&picture);
}

/* Lines end where there is no value (outside a fisheye, on glass). */
static double nothing_right(double x, double y)
{
    return x < 30.0 ? 1.0 + 0.001 * y : NAN;
}

static void lines_end_where_there_is_nothing(void **state)
{
    (void)state;
    struct pp_picture picture = picture_of(60, 40, nothing_right);
    struct pp_curve_list lines = {0};
    const double level = 1.02;
    assert_int_equal(
        pp_iso_lines(&lines, &picture, NULL, 1.0, &level, 1, 1.0, 3.0, NULL), PP_OK);
    assert_int_equal(lines.count, 1);
    assert_true(pp_curve_length(&lines.list[0])
                > 27.0); /* up to the last pixels with values */
    for (int i = 0; i < lines.list[0].count; i++) {
        assert_near(lines.list[0].xy[i][1], 20.0, 0.05);
        assert_true(lines.list[0].xy[i][0] < 30.0);
    }
    pp_curve_list_clear(&lines);
    pp_picture_clear(&picture);
}

/* Four pixels with the diagonals 1.2 and 1.0: on a logarithmic scale their middle is
 * sqrt(1.2) = 1.0954. A region brighter than 1.09 includes the middle, and its lines
 * surround the dark pixels. A region brighter than 1.10 does not, and its lines
 * surround the bright pixels. */
static double saddle(double x, double y)
{
    return (x < 1.0) == (y < 1.0) ? 1.2 : 1.0;
}

static double other_saddle(double x, double y)
{
    return (x < 1.0) == (y < 1.0) ? 1.0 : 1.2;
}

static void a_saddle_is_parted_as_its_middle_lies(void **state)
{
    (void)state;
    for (int k = 0; k < 4; k++) {
        bool across = k % 2;
        struct pp_picture picture = picture_of(2, 2, across ? other_saddle : saddle);
        struct pp_curve_list lines = {0};
        const double level = k < 2 ? 1.09 : 1.10;
        double log_share = log(level) / log(1.2);
        assert_int_equal(
            pp_iso_lines(&lines, &picture, NULL, 1.0, &level, 1, 0.0, 0.0, NULL),
            PP_OK);
        assert_int_equal(lines.count, 2);
        /* Each line surrounds one pixel, at the same distance in both directions. */
        double off = k < 2 ? log_share : 1.0 - log_share;
        bool on_first_diagonal = across == (k < 2);
        for (int i = 0; i < 2; i++) {
            const struct pp_curve *line = &lines.list[i];
            assert_int_equal(line->count, 2);
            assert_near(pp_curve_length(line), sqrt(2.0) * off, 1e-6); /* floats */
            double x = (line->xy[0][0] + line->xy[1][0]) / 2.0 - 1.0;
            double y = (line->xy[0][1] + line->xy[1][1]) / 2.0 - 1.0;
            assert_int_equal(x * y > 0.0, on_first_diagonal);
        }
        pp_curve_list_clear(&lines);
        pp_picture_clear(&picture);
    }
}

/* A dark wall beside a window: the last pixels of the wall contain a part of the
 * window, but must not cause a line along the edge of the window. */
static double mixture(double x, double y)
{
    return x < 29.0 ? 1.0 + 0.001 * y : x < 30.0 ? 3.0 + 2.0 * cos(0.3 * y) : 9.0;
}

static void pixels_of_two_surfaces_draw_no_line(void **state)
{
    (void)state;
    struct pp_picture picture = picture_of(60, 40, mixture);
    int tags[60 * 40];
    for (int i = 0; i < 60 * 40; i++)
        tags[i] = i % 60 < 30 ? 7 : 8;
    const double levels[] = {1.02, 2.0, 4.0};
    struct pp_curve_list lines = {0};
    assert_int_equal(
        pp_iso_lines(&lines, &picture, tags, 1.0, levels, 3, 1.0, 3.0, NULL), PP_OK);
    assert_int_equal(lines.count, 1);
    assert_near(lines.list[0].level, 1.02, 0.0);
    for (int i = 0; i < lines.list[0].count; i++)
        assert_near(lines.list[0].xy[i][1], 20.0, 0.05);
    pp_curve_list_clear(&lines);
    pp_picture_clear(&picture);
}

/* Noise of 5 % on a slope: with smoothing a line is not broken up. */
static double noisy(double x, double y)
{
    double noise = sin(12.9898 * x + 78.233 * y) * 43758.5453;
    return exp(0.02 * (x - 50.0)) * (1.0 + 0.1 * (noise - floor(noise) - 0.5));
}

static void smoothing_keeps_noise_from_tearing_lines(void **state)
{
    (void)state;
    struct pp_picture picture = picture_of(100, 80, noisy);
    int tags[100 * 80] = {0};
    struct pp_curve_list lines = {0};
    const double level = 1.0;
    assert_int_equal(
        pp_iso_lines(&lines, &picture, tags, 1.0, &level, 1, 3.0, 10.0, NULL), PP_OK);
    assert_int_equal(lines.count, 1);
    for (int i = 0; i < lines.list[0].count; i++)
        assert_near(lines.list[0].xy[i][0], 50.0, 2.5);
    pp_curve_list_clear(&lines);
    pp_picture_clear(&picture);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(colours_grow_lighter_all_the_way),
        cmocka_unit_test(the_middle_has_the_published_colour),
        cmocka_unit_test(a_scale_ends_at_round_numbers),
        cmocka_unit_test(a_black_picture_has_a_scale_all_the_same),
        cmocka_unit_test(lines_of_a_hill_are_circles),
        cmocka_unit_test(lines_end_where_surfaces_meet),
        cmocka_unit_test(lines_end_where_there_is_nothing),
        cmocka_unit_test(a_saddle_is_parted_as_its_middle_lies),
        cmocka_unit_test(pixels_of_two_surfaces_draw_no_line),
        cmocka_unit_test(smoothing_keeps_noise_from_tearing_lines),
    };
    add_tests(tests, NULL, NULL);
}
