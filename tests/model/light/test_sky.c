/* test_sky.c - the skies that methods and simulation share. */
#include "model/light/sky.h"

#include "tests/lib/near.h"

/* Midpoint sum over a fine grid of the hemisphere: slow, simple and independent. */
static double sum_on_plane(const struct pp_sky *sky, struct pp_vec3 n)
{
    enum { ALTITUDES = 600, AZIMUTHS = 1200 };
    double sum = 0.0;
    for (int i = 0; i < ALTITUDES; i++) {
        /* equal steps of sin altitude: equal solid angles */
        double z = (i + 0.5) / ALTITUDES, r = sqrt(1.0 - z * z);
        for (int j = 0; j < AZIMUTHS; j++) {
            double azimuth = 2.0 * PP_PI * (j + 0.5) / AZIMUTHS;
            struct pp_vec3 u = pp_vec(r * sin(azimuth), r * cos(azimuth), z);
            double facing = pp_vec_dot(n, u);
            if (facing > 0.0)
                sum += pp_sky_luminance(sky, u) * facing;
        }
    }
    return sum * 2.0 * PP_PI / ((double)ALTITUDES * AZIMUTHS);
}

static struct pp_vec3 sun_at(double altitude_deg, double azimuth_deg)
{
    double altitude = altitude_deg * PP_RAD, azimuth = azimuth_deg * PP_RAD;
    return pp_vec(cos(altitude) * sin(azimuth), cos(altitude) * cos(azimuth),
                  sin(altitude));
}

static void open_sky_gives_the_horizontal_plane_its_all(void **state)
{
    (void)state;
    struct pp_vec3 up = pp_vec(0.0, 0.0, 1.0);
    struct pp_sky overcast = pp_sky_overcast(), uniform = pp_sky_uniform();
    assert_near(pp_sky_on_plane(&overcast, up), 1.0, 1e-14);
    assert_near(pp_sky_on_plane(&uniform, up), 1.0, 1e-14);
    for (int type = 1; type <= 15; type++) {
        struct pp_sky sky;
        assert_int_equal(pp_sky_iso(&sky, type, sun_at(37.0, 211.0), NULL), PP_OK);
        assert_near(pp_sky_on_plane(&sky, up), 1.0, 1e-12);
        assert_near(sum_on_plane(&sky, up), 1.0, 2e-4);
    }
}

static void overcast_zenith_is_nine_sevenths_of_mean_and_thrice_the_horizon(
    void **state)
{
    (void)state;
    struct pp_sky sky = pp_sky_overcast();
    assert_near(pp_sky_luminance(&sky, pp_vec(0, 0, 1)), 9.0 / (7.0 * PP_PI), 1e-15);
    assert_near(pp_sky_luminance(&sky, pp_vec(1, 0, 1e-300)), 3.0 / (7.0 * PP_PI),
                1e-15);
    assert_near(pp_sky_luminance(&sky, pp_vec(1, 0, -1e-300)), 0.0, 0.0);
}

static void vertical_sky_component_is_39_6_overcast_and_50_uniform(void **state)
{
    (void)state;
    struct pp_sky overcast = pp_sky_overcast(), uniform = pp_sky_uniform();
    assert_near(pp_sky_on_plane(&overcast, pp_vec(0.6, 0.8, 0.0)), 0.396177, 5e-7);
    assert_near(pp_sky_on_plane(&uniform, pp_vec(0.6, 0.8, 0.0)), 0.5, 1e-15);
}

/* Ev/Eh with the sun at 60 degrees, for a façade facing away from the sun and facing
 * it, as calculated for the CIE 171 test cases by another program; three printed
 * digits. */
static void vertical_to_horizontal_ratios_of_the_iso_skies(void **state)
{
    (void)state;
    static const double away[] = {.379, .266, .447, .311, .500, .349, .284, .227,
                                  .448, .372, .302, .346, .276, .336, .246};
    static const double facing[] = {.379, .420, .447, .482, .500, .534, .547, .557,
                                    .671, .675, .677, .742, .742, .840, .842};
    for (int type = 1; type <= 15; type++) {
        struct pp_sky sky;
        assert_int_equal(pp_sky_iso(&sky, type, sun_at(60.0, 0.0), NULL), PP_OK);
        assert_near(pp_sky_on_plane(&sky, pp_vec(0, 1, 0)), facing[type - 1], 6e-4);
        assert_near(pp_sky_on_plane(&sky, pp_vec(0, -1, 0)), away[type - 1], 6e-4);
    }
}

static void tilted_planes_agree_with_a_plain_sum(void **state)
{
    (void)state;
    struct pp_vec3 normals[] = {pp_vec_unit(pp_vec(0.3, -0.7, 0.4)),
                                pp_vec_unit(pp_vec(-0.9, 0.2, -0.3)),
                                pp_vec_unit(pp_vec(0.1, 0.05, -0.9))};
    struct pp_sky skies[4] = {pp_sky_overcast(), pp_sky_uniform()};
    assert_int_equal(pp_sky_iso(&skies[2], 12, sun_at(23.0, 140.0), NULL), PP_OK);
    assert_int_equal(pp_sky_iso(&skies[3], 7, sun_at(51.0, 300.0), NULL), PP_OK);
    for (int s = 0; s < 4; s++)
        for (int n = 0; n < 3; n++)
            assert_near(pp_sky_on_plane(&skies[s], normals[n]),
                        sum_on_plane(&skies[s], normals[n]), 3e-4);
}

/* Published test values of two public programs: L/Lz at an altitude of 45 degrees
 * opposite a sun at a zenith distance of 30 degrees. */
static void iso_luminance_over_the_zeniths_as_published(void **state)
{
    (void)state;
    struct pp_vec3 u = sun_at(45.0, 180.0), zenith = pp_vec(0, 0, 1);
    struct pp_sky sky;
    assert_int_equal(pp_sky_iso(&sky, 1, sun_at(60.0, 0.0), NULL), PP_OK);
    assert_near(pp_sky_luminance(&sky, u) / pp_sky_luminance(&sky, zenith), 0.8325846,
                1e-6);
    assert_int_equal(pp_sky_iso(&sky, 12, sun_at(60.0, 0.0), NULL), PP_OK);
    assert_near(pp_sky_luminance(&sky, u) / pp_sky_luminance(&sky, zenith), 0.4544524,
                1e-6);
}

static void a_sky_that_is_not_one_is_refused(void **state)
{
    (void)state;
    struct pp_sky sky;
    struct pp_error err;
    assert_int_equal(pp_sky_iso(&sky, 16, sun_at(60.0, 0.0), &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "iso-16"));
    assert_int_equal(pp_sky_iso(&sky, 12, sun_at(-1.0, 0.0), &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "horizon"));
}

/* By gensky's formula, by hand: w = 1.01^10 = 1.104622 at the horizon, where the sky
 * has a third of the zenith's luminance and a ground of 0.2 has 0.155556 of it:
 * (1.104622/3 + 0.155556/1.104622)/(1.104622 + 1/1.104622) = 0.253260. */
static void a_faded_sky_is_half_ground_at_the_horizon(void **state)
{
    (void)state;
    struct pp_sky sky = pp_sky_faded(0.2), overcast = pp_sky_overcast();
    struct pp_vec3 zenith = pp_vec(0.0, 0.0, 1.0);
    double horizon = pp_sky_luminance(&sky, pp_vec(0.6, 0.8, 1e-9));
    assert_relative(horizon / pp_sky_luminance(&sky, zenith), 0.253260, 1e-5);
    /* The loss near the horizon is a small part of the light on horizontal ground. */
    assert_near(pp_sky_on_plane(&sky, zenith), 1.0, 1e-8);
    assert_near(sum_on_plane(&sky, zenith), 1.0, 1e-4);
    double more = pp_sky_luminance(&sky, zenith) / pp_sky_luminance(&overcast, zenith);
    assert_true(more > 1.0 && more < 1.01);
    /* Walls lose more. */
    struct pp_vec3 wall = pp_vec(0.0, 1.0, 0.0);
    assert_relative(pp_sky_on_plane(&sky, wall), sum_on_plane(&sky, wall), 1e-3);
    assert_true(pp_sky_on_plane(&sky, wall) < 0.99 * pp_sky_on_plane(&overcast, wall));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(open_sky_gives_the_horizontal_plane_its_all),
        cmocka_unit_test(
            overcast_zenith_is_nine_sevenths_of_mean_and_thrice_the_horizon),
        cmocka_unit_test(vertical_sky_component_is_39_6_overcast_and_50_uniform),
        cmocka_unit_test(vertical_to_horizontal_ratios_of_the_iso_skies),
        cmocka_unit_test(tilted_planes_agree_with_a_plain_sum),
        cmocka_unit_test(iso_luminance_over_the_zeniths_as_published),
        cmocka_unit_test(a_sky_that_is_not_one_is_refused),
        cmocka_unit_test(a_faded_sky_is_half_ground_at_the_horizon),
    };
    add_tests(tests, NULL, NULL);
}
