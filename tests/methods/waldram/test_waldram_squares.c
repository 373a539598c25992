/* test_waldram_squares.c - squares counted on the diagram, compared with its exact
 * areas. */
#include "methods/waldram/waldram_squares.h"

#include "tests/lib/near.h"
#include "tests/lib/sized.h"

static const struct pp_window_axes upright = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};

/* Pseudo-random number in [0, 1), the same on all machines. */
static double next(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) * 0x1p-53;
}

struct tally {
    double exact, parts, squares, outline; /* outline: length in sides of a square */
};

static struct tally count_ring(const struct pp_waldram *waldram,
                               const struct pp_window_axes *axes, double (*xy)[2],
                               int count_of_corners)
{
    struct pp_ring ring = {count_of_corners, xy};
    struct pp_region region = {1, &ring}, outline;
    struct pp_waldram_count count;
    struct tally tally = {.exact = pp_waldram_scale_area(waldram, axes, &region)
                                   / PP_WALDRAM_WORTH};
    double width, height;
    pp_waldram_squares_size(waldram, &width, &height);
    assert_int_equal(pp_waldram_squares_count(&count, waldram, axes, &region, NULL),
                     PP_OK);
    tally.squares = count.squares;
    for (int i = 0; i < count.count; i++)
        tally.parts += count.list[i].part;
    pp_waldram_squares_clear(&count);
    assert_int_equal(pp_waldram_squares_outline(&outline, waldram, axes, &region, NULL),
                     PP_OK);
    for (int i = 0; i < outline.rings[0].count; i++) {
        const double *p = outline.rings[0].xy[i];
        const double *q = outline.rings[0].xy[(i + 1) % outline.rings[0].count];
        tally.outline += hypot((q[0] - p[0]) / width, (q[1] - p[1]) / height);
    }
    pp_region_clear(&outline);
    return tally;
}

static struct tally count_rectangle(const struct pp_waldram *waldram,
                                    const struct pp_window_axes *axes, double x0,
                                    double x1, double y0, double y1)
{
    double xy[4][2] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    return count_ring(waldram, axes, xy, 4);
}

/* Rest of a rectangle behind a house with a gable. The outline of the house is given in
 * fractions of the width and height. */
static struct tally count_obstructed(const struct pp_waldram *waldram, double x0,
                                     double x1, double y0, double y1,
                                     const double at[4])
{
    double left = x0 + (x1 - x0) * 0.5 * at[0], right = x1 - (x1 - x0) * 0.45 * at[1];
    double eaves = y0 + (y1 - y0) * 0.6 * at[2],
           ridge = eaves + (y1 - eaves) * 0.9 * at[3];
    double xy[9][2] = {
        {x0, y0},       {left, y0},  {left, eaves}, {(left + right) / 2, ridge},
        {right, eaves}, {right, y0}, {x1, y0},      {x1, y1},
        {x0, y1}};
    return count_ring(waldram, &upright, xy, 9);
}

/* Droop lines are drawn to a thousandth of a square's side; curved parts have their
 * exact area. */
static void parts_of_squares_add_up_to_the_exact_area(void **state)
{
    (void)state;
    struct pp_waldram waldram;
    struct pp_sky sky = pp_sky_overcast();
    assert_int_equal(pp_waldram_scale_init(&waldram, &sky, true, NULL), PP_OK);
    uint64_t seed = 3;
    for (int i = 0; i < 300; i++) {
        double x = 4.0 * next(&seed) - 2.0, y = 1.5 * next(&seed) - 0.3;
        double width = 3.0 * next(&seed), height = 2.0 * next(&seed);
        struct tally tally =
            count_rectangle(&waldram, &upright, x, x + width, y, y + height);
        assert_near(tally.parts, tally.exact, 1e-5 * tally.outline + 1e-9);
    }
}

/* 20,000 windows (fewer in short runs), every other one obstructed: no bias beyond
 * three standard errors of the mean, and a spread of at most 0.05 of the square root of
 * the outline's length. */
static void counts_are_unbiased_and_close(void **state)
{
    (void)state;
    const int windows = PP_SIZED(20000, 5000, 2000);
    for (int glazed = 0; glazed < 2; glazed++) {
        struct pp_waldram waldram;
        struct pp_sky sky = glazed ? pp_sky_overcast() : pp_sky_uniform();
        assert_int_equal(pp_waldram_scale_init(&waldram, &sky, glazed, NULL), PP_OK);
        uint64_t seed = 11 + glazed;
        double sum = 0.0, sum2 = 0.0, spread = 0.0;
        for (int i = 0; i < windows; i++) {
            double x = 5.0 * next(&seed) - 3.0, y = 1.2 * next(&seed);
            double width = 2.5 * next(&seed), height = 2.5 * next(&seed);
            double at[4];
            for (int k = 0; k < 4; k++)
                at[k] = next(&seed);
            struct tally tally =
                i % 2
                    ? count_obstructed(&waldram, x, x + width, y, y + height, at)
                    : count_rectangle(&waldram, &upright, x, x + width, y, y + height);
            double error = tally.squares - tally.exact;
            sum += error;
            sum2 += error * error;
            spread += error * error / tally.outline;
        }
        double mean = sum / windows;
        double of_mean = sqrt((sum2 / windows - mean * mean) / windows);
        assert_true(fabs(mean) <= 3.0 * of_mean);
        assert_true(sqrt(spread / windows) <= 0.05);
    }
}

/* A rooflight around the zenith: all azimuths, and more than half of the squares of the
 * sky. */
static void a_rooflight_overhead_is_counted_all_round(void **state)
{
    (void)state;
    struct pp_window_axes flat = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
    struct pp_waldram waldram;
    struct pp_sky sky = pp_sky_overcast();
    assert_int_equal(pp_waldram_scale_init(&waldram, &sky, false, NULL), PP_OK);
    struct tally tally = count_rectangle(&waldram, &flat, -1.0, 1.0, -1.0, 1.0);
    assert_near(tally.exact, 4 * 159.497, 0.002);
    assert_near(tally.parts, tally.exact, 1e-5 * tally.outline);
    assert_near(tally.squares, tally.exact, 1.0);
    /* To one side, and behind the point: the outline crosses 180 degrees. */
    tally = count_rectangle(&waldram, &flat, -0.7, 0.4, 0.3, 1.9);
    assert_near(tally.parts, tally.exact, 1e-5 * tally.outline);
}

static void nothing_is_counted_where_nothing_is_seen(void **state)
{
    (void)state;
    struct pp_waldram waldram;
    struct pp_sky sky = pp_sky_overcast();
    struct pp_waldram_count count;
    struct pp_region none = {0, NULL};
    assert_int_equal(pp_waldram_scale_init(&waldram, &sky, true, NULL), PP_OK);
    assert_int_equal(pp_waldram_squares_count(&count, &waldram, &upright, &none, NULL),
                     PP_OK);
    assert_int_equal(count.count, 0);
    assert_near(count.squares, 0.0, 0.0);
    pp_waldram_squares_clear(&count);
    struct tally below = count_rectangle(&waldram, &upright, -1.0, 1.3, -2.0, -0.4);
    assert_near(below.squares, 0.0, 0.0);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_of_squares_add_up_to_the_exact_area),
        cmocka_unit_test(counts_are_unbiased_and_close),
        cmocka_unit_test(a_rooflight_overhead_is_counted_all_round),
        cmocka_unit_test(nothing_is_counted_where_nothing_is_seen),
    };
    add_tests(tests, NULL, NULL);
}
