/* test_pepper_pot_dots.c - dots of equal value on the perspective view of a window. */
#include "methods/pepper_pot/pepper_pot_dots.h"
#include "methods/waldram/waldram_scale.h"

#include "tests/lib/near.h"
#include "tests/lib/sized.h"

static struct pp_pepper_pot *made(struct pp_sky sky, bool glazed, bool upright,
                                  double facing_rad, double worth)
{
    struct pp_pepper_pot *pot;
    assert_int_equal(
        pp_pepper_pot_dots_create(&pot, &sky, glazed, upright, facing_rad, worth, NULL),
        PP_OK);
    return pot;
}

/* Pseudo-random number in [0, 1), the same on all machines. */
static double next(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) * 0x1p-53;
}

/* Light of a rectangle of the drawing, by the midpoints of equal steps in a and b,
 * independent of the altitudes and azimuths used for the dots. */
static double rectangle_share(const struct pp_pepper_pot *pot, double a0, double a1,
                              double b0, double b1)
{
    enum { STEPS = 24 };
    double sum = 0.0;
    for (int i = 0; i < STEPS; i++)
        for (int j = 0; j < STEPS; j++) {
            double a = a0 + (a1 - a0) * (i + 0.5) / STEPS;
            double b = b0 + (b1 - b0) * (j + 0.5) / STEPS;
            double r = sqrt(1.0 + a * a + b * b);
            double facing = pot->upright
                                ? (cos(pot->facing_rad) + a * sin(pot->facing_rad)) / r
                                : b / r;
            if (facing > 0.0 && b > 0.0)
                sum += pp_sky_luminance(&pot->sky, pp_vec(a / r, 1 / r, b / r))
                       * pp_glass_transmittance(&pot->glass, 1.0 / r) * facing
                       / (r * r * r);
        }
    return sum * (a1 - a0) * (b1 - b0) / (STEPS * STEPS);
}

static void a_boundless_window_holds_all_dots(void **state)
{
    (void)state;
    static const struct {
        bool overcast, glazed, upright;
        double whole;
        int dots;
    } pots[] = {{true, false, false, 0.5, 500},     {false, false, false, 0.5, 500},
                {true, true, false, 0.31628, 316},  {false, true, false, 0.32652, 327},
                {true, false, true, 0.396177, 396}, {false, false, true, 0.5, 500}};
    for (int i = 0; i < 6; i++) {
        struct pp_pepper_pot *pot =
            made(pots[i].overcast ? pp_sky_overcast() : pp_sky_uniform(),
                 pots[i].glazed, pots[i].upright, 0.0, PP_PEPPER_POT_WORTH);
        assert_near(pot->whole, pots[i].whole, 1e-5);
        assert_int_equal(pot->count, pots[i].dots);
        double xy[4][2] = {{-1e9, 0}, {1e9, 0}, {1e9, 1e9}, {-1e9, 1e9}};
        struct pp_ring ring = {4, xy};
        struct pp_region all = {1, &ring};
        assert_int_equal(pp_pepper_pot_dots_count(pot, &all), pots[i].dots);
        pp_pepper_pot_dots_destroy(pot);
    }
}

/* Mapped to a square of equal light, dot i has the height (i + 1/2) worth/whole and,
 * across, the fractional part of (i + 1/2) times the golden ratio. */
static void every_dot_is_where_its_lattice_has_it(void **state)
{
    (void)state;
    for (int kind = 0; kind < 8; kind++) {
        struct pp_pepper_pot *pot =
            made(kind & 1 ? pp_sky_overcast() : pp_sky_uniform(), kind & 2, kind & 4,
                 0.6, PP_PEPPER_POT_WORTH);
        for (int i = 0; i < pot->count; i += 7) {
            double s, t, whole;
            assert_true(pp_pepper_pot_dots_to_square(pot, pot->dots[i][0],
                                                     pot->dots[i][1], &s, &t));
            assert_near(t, (i + 0.5) * pot->worth / pot->whole, 1e-7);
            assert_near(s, modf((i + 0.5) * 0.61803398874989484820, &whole), 2e-6);
        }
        pp_pepper_pot_dots_destroy(pot);
    }
}

/* Counts for 5,000 windows (fewer in short runs) on each of four charts: no bias beyond
 * three standard errors, and a spread of at most half the square root of the outline's
 * length, in sides of a dot's cell. */
static void counts_are_unbiased_and_close(void **state)
{
    (void)state;
    const int windows = PP_SIZED(5000, 2000, 500);
    for (int kind = 0; kind < 4; kind++) {
        bool glazed = kind & 1, upright = kind & 2;
        struct pp_pepper_pot *pot = made(pp_sky_overcast(), glazed, upright,
                                         upright ? 0.3 : 0.0, PP_PEPPER_POT_WORTH);
        uint64_t seed = 5 + kind;
        double sum = 0.0, sum2 = 0.0, spread = 0.0,
               side = sqrt(pot->worth / pot->whole);
        for (int i = 0; i < windows; i++) {
            double a0 = 4.0 * next(&seed) - 2.5, a1 = a0 + 0.2 + 2.0 * next(&seed);
            double b0 = next(&seed), b1 = b0 + 0.1 + 1.9 * next(&seed);
            double xy[4][2] = {{a0, b0}, {a1, b0}, {a1, b1}, {a0, b1}};
            struct pp_ring ring = {4, xy};
            struct pp_region region = {1, &ring};
            double exact = rectangle_share(pot, a0, a1, b0, b1) / pot->worth;
            double error = pp_pepper_pot_dots_count(pot, &region) - exact;
            double outline = 0.0, last_s = 0.0, last_t = 0.0;
            for (int k = 0; k <= 32; k++) {
                const double *p = xy[k / 8 % 4], *q = xy[(k / 8 + 1) % 4];
                double f = k % 8 / 8.0, s, t;
                if (!pp_pepper_pot_dots_to_square(pot, p[0] + f * (q[0] - p[0]),
                                                  p[1] + f * (q[1] - p[1]), &s, &t))
                    continue;
                if (k > 0)
                    outline += hypot(s - last_s, t - last_t) / side;
                last_s = s, last_t = t;
            }
            sum += error;
            sum2 += error * error;
            spread += error * error / outline;
        }
        double mean = sum / windows;
        double of_mean = sqrt((sum2 / windows - mean * mean) / windows);
        assert_true(fabs(mean) <= 3.0 * of_mean);
        assert_true(sqrt(spread / windows) <= 0.5);
        pp_pepper_pot_dots_destroy(pot);
    }
}

/* 20,000 windows (fewer in short runs) behind a house with a gable, on the chart
 * without glass, compared with the exact visible area on Waldram's diagram. */
static void counts_with_obstructions_are_unbiased_and_close(void **state)
{
    (void)state;
    const int windows = PP_SIZED(20000, 5000, 2000);
    static const struct pp_window_axes axes = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    struct pp_sky sky = pp_sky_overcast();
    struct pp_waldram waldram;
    assert_int_equal(pp_waldram_scale_init(&waldram, &sky, false, NULL), PP_OK);
    struct pp_pepper_pot *pot = made(sky, false, false, 0.0, PP_PEPPER_POT_WORTH);
    uint64_t seed = 41;
    double sum = 0.0, sum2 = 0.0, most = 0.0;
    for (int i = 0; i < windows; i++) {
        double x0 = 4.0 * next(&seed) - 2.5, x1 = x0 + 0.3 + 2.0 * next(&seed);
        double y0 = next(&seed), y1 = y0 + 0.2 + 1.8 * next(&seed);
        double left = x0 + (x1 - x0) * 0.5 * next(&seed);
        double right = x1 - (x1 - x0) * 0.45 * next(&seed);
        double eaves = y0 + (y1 - y0) * 0.6 * next(&seed);
        double ridge = eaves + (y1 - eaves) * 0.9 * next(&seed);
        double xy[9][2] = {
            {x0, y0},       {left, y0},  {left, eaves}, {(left + right) / 2, ridge},
            {right, eaves}, {right, y0}, {x1, y0},      {x1, y1},
            {x0, y1}};
        struct pp_ring ring = {9, xy};
        struct pp_region region = {1, &ring};
        double exact =
            pp_waldram_scale_area(&waldram, &axes, &region) / PP_PEPPER_POT_WORTH;
        double error = pp_pepper_pot_dots_count(pot, &region) - exact;
        sum += error;
        sum2 += error * error;
        most = fmax(most, fabs(error));
    }
    double mean = sum / windows, rms = sqrt(sum2 / windows);
    assert_true(fabs(mean) <= 3.0 * rms / sqrt(windows));
    /* Outlines have the length of 20 to 60 sides of a dot's cell: half the square root
     * of 20. */
    assert_true(rms <= 0.5 * sqrt(20.0));
    assert_true(most < 12.0);
    pp_pepper_pot_dots_destroy(pot);
}

static void the_fine_chart_has_ten_dots_for_one(void **state)
{
    (void)state;
    struct pp_pepper_pot *fine =
        made(pp_sky_overcast(), true, false, 0.0, PP_PEPPER_POT_FINE_WORTH);
    assert_int_equal(fine->count, 3163);
    pp_pepper_pot_dots_destroy(fine);
}

static void other_skies_and_senseless_dots_are_refused(void **state)
{
    (void)state;
    struct pp_sky sky, overcast = pp_sky_overcast();
    struct pp_pepper_pot *pot;
    struct pp_error err;
    assert_int_equal(pp_sky_iso(&sky, 3, pp_vec(0, 0, 1), NULL), PP_OK);
    assert_int_equal(
        pp_pepper_pot_dots_create(&pot, &sky, true, false, 0.0, 0.001, &err),
        PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "iso-3"));
    assert_null(pot);
    assert_int_equal(
        pp_pepper_pot_dots_create(&pot, &overcast, true, false, 0.0, NAN, &err),
        PP_BAD_INPUT);
    /* A receiver that faces away from the window receives nothing from it. */
    pot = made(overcast, true, true, PP_PI, 0.001);
    assert_int_equal(pot->count, 0);
    pp_pepper_pot_dots_destroy(pot);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_boundless_window_holds_all_dots),
        cmocka_unit_test(every_dot_is_where_its_lattice_has_it),
        cmocka_unit_test(counts_are_unbiased_and_close),
        cmocka_unit_test(counts_with_obstructions_are_unbiased_and_close),
        cmocka_unit_test(the_fine_chart_has_ten_dots_for_one),
        cmocka_unit_test(other_skies_and_senseless_dots_are_refused),
    };
    add_tests(tests, NULL, NULL);
}
