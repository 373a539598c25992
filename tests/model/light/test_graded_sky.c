/* test_graded_sky.c - graded skies compared with sums over the sky, also for gradations
 * that room files do not have. */
#include "model/light/graded_sky.h"
#include "model/light/sky.h"

#include "tests/lib/near.h"

static const double gradations[] = {0.0, 1.0, 2.0, 5.0};
enum { GRADATIONS = 4, STEPS = 500 };

/* Luminance divided by Lz, in units of 1/(1 + b), as at the top of the header. */
static double brightness(double b, double sine)
{
    return 1.0 + b * sine;
}

/* Sum of luminance times the cosine to n over the part of the sky for which seen() is
 * true, by midpoints in azimuth and sine of altitude, divided by that of the horizontal
 * plane. */
static double sum_on(double b, struct pp_vec3 n, bool (*seen)(struct pp_vec3, double),
                     double angle)
{
    double sum = 0.0, level = 0.0;
    for (int i = 0; i < STEPS; i++)
        for (int j = 0; j < STEPS; j++) {
            double z = (i + 0.5) / STEPS, r = sqrt(1.0 - z * z);
            double azimuth = 2.0 * PP_PI * (j + 0.5) / STEPS;
            struct pp_vec3 u = pp_vec(r * cos(azimuth), r * sin(azimuth), z);
            double facing = pp_vec_dot(n, u);
            level += brightness(b, z) * z;
            if (facing > 0.0 && seen(u, angle))
                sum += brightness(b, z) * facing;
        }
    return sum / level;
}

static bool anything(struct pp_vec3 u, double angle)
{
    (void)u, (void)angle;
    return true;
}

/* True above a skyline parallel to y, on the side of +x. */
static bool over_skyline(struct pp_vec3 u, double angle)
{
    return atan2(u.z, u.x) > angle;
}

static bool below_plane(struct pp_vec3 u, double angle)
{
    return atan2(u.z, u.x) < angle;
}

/* By hand: pi Lz (1 + 2b/3)/(1 + b) is 7 pi/9 Lz for b = 2, pi for 0, 5 pi/6 for 1. */
static void zenith_over_horizontal_illuminance(void **state)
{
    (void)state;
    assert_relative(pp_graded_sky_zenith(2.0), 9.0 / (7.0 * PP_PI), 1e-15);
    assert_relative(pp_graded_sky_zenith(0.0), 1.0 / PP_PI, 1e-15);
    assert_relative(pp_graded_sky_zenith(1.0), 6.0 / (5.0 * PP_PI), 1e-15);
    for (int i = 0; i < GRADATIONS; i++) {
        double b = gradations[i];
        assert_relative(pp_graded_sky_zenith(b) * pp_graded_sky_luminance(b, 0.0)
                            * PP_PI,
                        pp_graded_sky_horizon(b), 1e-15);
        assert_relative(pp_graded_sky_luminance(b, 1.0), 1.0, 1e-15);
        assert_relative(pp_graded_sky_luminance(b, 0.0), 1.0 / (1.0 + b), 1e-15);
    }
}

static void tilted_planes_as_by_a_plain_sum(void **state)
{
    (void)state;
    for (int i = 0; i < GRADATIONS; i++)
        for (int deg = 0; deg < 180; deg += 35) {
            struct pp_vec3 n = pp_vec(sin(deg * PP_RAD), 0.0, cos(deg * PP_RAD));
            double b = gradations[i], sum = sum_on(b, n, anything, 0.0);
            struct pp_sky sky = pp_sky_graded(b);
            assert_near(pp_graded_sky_on_plane(b, deg * PP_RAD), sum, 2e-4);
            assert_near(pp_sky_on_plane(&sky, n), sum, 2e-4);
        }
}

static void tilted_planes_of_two_skies_agree_with_closed_forms(void **state)
{
    (void)state;
    for (int deg = 0; deg <= 180; deg += 15) {
        double beta = deg * PP_RAD, c = cos(beta);
        assert_near(pp_graded_sky_on_plane(2.0, beta),
                    3.0 / 14.0 * (1.0 + c)
                        + 4.0 / (7.0 * PP_PI) * (sin(beta) + (PP_PI - beta) * c),
                    1e-15);
        assert_near(pp_graded_sky_on_plane(0.0, beta), (1.0 + c) / 2.0, 1e-15);
    }
}

static void upright_planes_over_a_skyline(void **state)
{
    (void)state;
    for (int i = 0; i < GRADATIONS; i++)
        for (int deg = 0; deg < 90; deg += 17)
            assert_near(
                pp_graded_sky_over_skyline(gradations[i], deg * PP_RAD),
                sum_on(gradations[i], pp_vec(1, 0, 0), over_skyline, deg * PP_RAD),
                2e-3);
    assert_near(pp_graded_sky_over_skyline(PP_GRADED_SKY_OVERCAST, 0.0), 0.396177,
                5e-7);
    assert_near(pp_graded_sky_over_skyline(PP_GRADED_SKY_OVERCAST, 25 * PP_RAD), 0.2731,
                5e-5);
    assert_near(pp_graded_sky_over_skyline(PP_GRADED_SKY_UNIFORM, 25 * PP_RAD), 0.2887,
                5e-5);
}

static void a_skyline_and_its_light_are_each_others_inverse(void **state)
{
    (void)state;
    for (int i = 0; i < GRADATIONS; i++) {
        double b = gradations[i];
        for (double deg = 0.5; deg < 85.0; deg += 3.7)
            /* asin is less accurate near 90 degrees */
            assert_near(
                pp_graded_sky_skyline(b, pp_graded_sky_over_skyline(b, deg * PP_RAD)),
                deg * PP_RAD, 1e-13);
        assert_near(pp_graded_sky_skyline(b, 0.6), 0.0, 0.0);
        assert_near(pp_graded_sky_skyline(b, 0.0), PP_PI / 2, 1e-7);
        assert_near(pp_graded_sky_skyline(b, -0.1), PP_PI / 2, 0.0);
    }
}

static void level_planes_by_the_sky_below_a_plane_and_an_altitude(void **state)
{
    (void)state;
    for (int i = 0; i < GRADATIONS; i++) {
        double b = gradations[i], whole = 0.0;
        for (int deg = 10; deg < 180; deg += 40)
            assert_near(pp_graded_sky_below_plane(b, deg * PP_RAD),
                        sum_on(b, pp_vec(0, 0, 1), below_plane, deg * PP_RAD), 2e-3);
        assert_near(pp_graded_sky_below_plane(b, PP_PI), 1.0, 1e-15);
        for (int k = 0; k < STEPS; k++)
            whole += brightness(b, (k + 0.5) / STEPS) * (k + 0.5);
        double part = 0.0;
        for (int k = 0; k < STEPS; k++) {
            if (k % 100 == 0)
                assert_near(pp_graded_sky_below_altitude(b, (double)k / STEPS),
                            part / whole / (2.0 * PP_PI), 1e-6);
            part += brightness(b, (k + 0.5) / STEPS) * (k + 0.5);
        }
        assert_near(pp_graded_sky_below_altitude(b, 1.0), 1.0 / (2.0 * PP_PI), 1e-15);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(zenith_over_horizontal_illuminance),
        cmocka_unit_test(tilted_planes_as_by_a_plain_sum),
        cmocka_unit_test(tilted_planes_of_two_skies_agree_with_closed_forms),
        cmocka_unit_test(upright_planes_over_a_skyline),
        cmocka_unit_test(a_skyline_and_its_light_are_each_others_inverse),
        cmocka_unit_test(level_planes_by_the_sky_below_a_plane_and_an_altitude),
    };
    add_tests(tests, NULL, NULL);
}
