/* test_waldram_scale.c - equal areas of the diagram are equal sky components. */
#include "methods/waldram/waldram_scale.h"

#include "tests/lib/near.h"

static const struct pp_window_axes upright = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};

static struct pp_waldram made(struct pp_sky sky, bool glazed)
{
    struct pp_waldram waldram;
    assert_int_equal(pp_waldram_scale_init(&waldram, &sky, glazed, NULL), PP_OK);
    return waldram;
}

static double rectangle(const struct pp_waldram *waldram,
                        const struct pp_window_axes *axes, double x0, double x1,
                        double y0, double y1)
{
    double xy[4][2] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    struct pp_ring ring = {4, xy};
    struct pp_region region = {1, &ring};
    return pp_waldram_scale_area(waldram, axes, &region);
}

static void the_whole_diagram_is_half_the_sky(void **state)
{
    (void)state;
    struct pp_sky darker;
    assert_int_equal(pp_sky_iso(&darker, 3, pp_vec(0, 0, 1), NULL), PP_OK);
    struct pp_sky skies[] = {pp_sky_overcast(), pp_sky_uniform(), darker};
    for (int i = 0; i < 3; i++) {
        struct pp_waldram waldram = made(skies[i], false);
        assert_near(pp_waldram_scale_total_area(&waldram), 0.5, 1e-9);
    }
    /* With glass the product of losses gives 34.58 %, the integral 31.63 %. */
    struct pp_waldram glazed = made(pp_sky_overcast(), true);
    assert_near(pp_waldram_scale_total_area(&glazed), 0.3458, 5e-5);
}

/* Ordinates at 10 to 90 degrees divided by that of the zenith, four printed digits. */
static void ordinates_as_published(void **state)
{
    (void)state;
    static const double overcast[] = {.0159, .0730, .1786, .3288, .5084,
                                      .6926, .8526, .9614, 1};
    static const double uniform[] = {.0302, .1170, .25,   .4132, .5868,
                                     .75,   .8830, .9698, 1};
    struct pp_waldram o = made(pp_sky_overcast(), false);
    struct pp_waldram u = made(pp_sky_uniform(), false);
    for (int i = 0; i < 9; i++) {
        double altitude = (i + 1) * 10.0 * PP_RAD;
        assert_near(pp_waldram_scale_y(&o, altitude)
                        / pp_waldram_scale_y(&o, PP_PI / 2.0),
                    overcast[i], 5.1e-5);
        assert_near(pp_waldram_scale_y(&u, altitude)
                        / pp_waldram_scale_y(&u, PP_PI / 2.0),
                    uniform[i], 5.1e-5);
    }
}

/* The ordinate of a direction vector of any length, with and without glass; zero below
 * the horizon. */
static void the_ordinate_of_a_direction_is_that_of_its_altitude(void **state)
{
    (void)state;
    const struct pp_waldram diagrams[] = {made(pp_sky_overcast(), false),
                                          made(pp_sky_overcast(), true),
                                          made(pp_sky_uniform(), false)};
    for (int k = 0; k < 3; k++)
        for (int i = -9; i <= 90; i++) {
            double altitude = i * PP_RAD, r = cos(altitude) * (i + 20);
            struct pp_vec3 u = {r * cos(0.3 * i), r * sin(0.3 * i),
                                (i + 20) * sin(altitude)};
            assert_near(pp_waldram_scale_y_toward(&diagrams[k], u),
                        pp_waldram_scale_y(&diagrams[k], altitude), 1e-14);
            assert_true((pp_waldram_scale_y_toward(&diagrams[k], u) > 0.0) == (i > 0));
        }
}

/* Sky component of a rectangle with its sill in the plane of the point and one jamb on
 * the normal, in closed form [TS93]. */
static double corner(double w, double h, bool overcast)
{
    double r = sqrt(1.0 + h * h + w * w), s = sqrt(1.0 + h * h);
    double factor = atan(w) - atan(w / s) / s;
    if (!overcast)
        return factor / (2.0 * PP_PI);
    return 3.0 / (14.0 * PP_PI) * factor
           + 2.0 / (7.0 * PP_PI) * (atan(h * w / r) - h * w / ((1.0 + h * h) * r));
}

static void areas_of_windows_are_their_sky_components(void **state)
{
    (void)state;
    for (int overcast = 0; overcast < 2; overcast++) {
        struct pp_waldram waldram =
            made(overcast ? pp_sky_overcast() : pp_sky_uniform(), false);
        for (double w = 0.13; w < 9.0; w *= 2.3)
            for (double h = 0.07; h < 9.0; h *= 2.9) {
                assert_relative(rectangle(&waldram, &upright, 0.0, w, 0.0, h),
                                corner(w, h, overcast), 1e-9);
                assert_relative(rectangle(&waldram, &upright, -w, 0.0, 0.0, h),
                                corner(w, h, overcast), 1e-9);
            }
    }
}

static void what_lies_below_the_horizon_has_no_area(void **state)
{
    (void)state;
    struct pp_waldram waldram = made(pp_sky_overcast(), false);
    assert_relative(rectangle(&waldram, &upright, -0.3, 1.1, -0.8, 0.9),
                    corner(0.3, 0.9, true) + corner(1.1, 0.9, true), 1e-9);
    assert_near(rectangle(&waldram, &upright, -0.3, 1.1, -0.8, -0.1), 0.0, 1e-15);
}

/* A rooflight one unit above the point with one corner overhead, 15.9497 % under the
 * overcast sky, and a rooflight around the zenith with four such quarters. */
static void rooflights_overhead_count_as_they_should(void **state)
{
    (void)state;
    struct pp_window_axes flat = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
    struct pp_waldram waldram = made(pp_sky_overcast(), false);
    assert_near(rectangle(&waldram, &flat, 1e-9, 1.0, 1e-9, 1.0), 0.159497, 5e-7);
    assert_near(rectangle(&waldram, &flat, -1.0, 1.0, -1.0, 1.0), 4 * 0.159497, 2e-6);
    assert_near(rectangle(&waldram, &flat, 1e-9, 0.5, -2.0, -1e-9), 0.122905, 5e-7);
}

/* On its axes the glazed diagram is exact: thin slits directly ahead. */
static void losses_of_glass_are_right_straight_ahead(void **state)
{
    (void)state;
    struct pp_waldram bare = made(pp_sky_overcast(), false);
    struct pp_waldram glazed = made(pp_sky_overcast(), true);
    struct pp_glass glass = pp_glass_clear_single();
    for (double b = 0.1; b < 5.0; b *= 2.1) {
        double tau = pp_glass_transmittance(&glass, cos(atan(b)));
        double slit = rectangle(&glazed, &upright, -1e-4, 1e-4, b, b + 1e-4)
                      / rectangle(&bare, &upright, -1e-4, 1e-4, b, b + 1e-4);
        assert_near(slit, tau, 1e-4);
    }
}

static void a_sky_that_changes_with_azimuth_is_refused(void **state)
{
    (void)state;
    struct pp_sky clear;
    struct pp_waldram waldram;
    struct pp_error err;
    assert_int_equal(pp_sky_iso(&clear, 12, pp_vec_unit(pp_vec(1, 2, 3)), NULL), PP_OK);
    assert_int_equal(pp_waldram_scale_init(&waldram, &clear, false, &err),
                     PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "iso-12"));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_whole_diagram_is_half_the_sky),
        cmocka_unit_test(ordinates_as_published),
        cmocka_unit_test(the_ordinate_of_a_direction_is_that_of_its_altitude),
        cmocka_unit_test(areas_of_windows_are_their_sky_components),
        cmocka_unit_test(what_lies_below_the_horizon_has_no_area),
        cmocka_unit_test(rooflights_overhead_count_as_they_should),
        cmocka_unit_test(losses_of_glass_are_right_straight_ahead),
        cmocka_unit_test(a_sky_that_changes_with_azimuth_is_refused),
    };
    add_tests(tests, NULL, NULL);
}
