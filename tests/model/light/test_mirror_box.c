/* test_mirror_box.c - the sky in a box of mirrors compared with its limits and with
 * rays followed through the box. */
#include "model/light/mirror_box.h"

#include "model/geometry/vec.h"
#include "tests/lib/near.h"

/* Perfect mirrors show an infinite ceiling: a uniform sky with a horizontal illuminance
 * of pi L. Relative to this sky the overcast sky has 9/7 at the zenith and 3/7 at the
 * horizon. */
static void perfect_mirrors_make_a_uniform_sky(void **state)
{
    (void)state;
    const struct pp_mirror_box box = {1.0, 0.7};
    assert_near(pp_mirror_box_luminance(&box, 0.1), 1.0, 1e-12);
    assert_near(pp_mirror_box_horizontal(&box), PP_PI, 1e-5);
    assert_near(pp_mirror_box_correction(&box, 0.5 * PP_PI), 9.0 / 7.0, 1e-5);
    assert_near(pp_mirror_box_correction(&box, 1e-9), 3.0 / 7.0, 1e-5);
}

/* Follows rays from evenly spread starting points from mirror to mirror until they
 * reach the height of the ceiling. The points are fractional parts of multiples of
 * irrational numbers. */
static double followed(const struct pp_mirror_box *box, double altitude)
{
    enum { RAYS = 40000 };
    double sum = 0.0;
    for (int i = 1; i <= RAYS; i++) {
        double at[2] = {fmod(i * 0.7548776662466927, 1.0),
                        fmod(i * 0.5698402909980532, 1.0)};
        double psi = 2.0 * PP_PI * fmod(i * 0.6180339887498949, 1.0), light = 1.0;
        double way[2] = {cos(psi) / tan(altitude), sin(psi) / tan(altitude)}, up = 0.0;
        for (;;) {
            double next = box->height - up;
            int mirror = -1;
            for (int k = 0; k < 2; k++) {
                double far = way[k] > 0.0 ? 1.0 - at[k] : at[k];
                if (far / fabs(way[k]) < next) {
                    next = far / fabs(way[k]);
                    mirror = k;
                }
            }
            if (mirror < 0)
                break;
            for (int k = 0; k < 2; k++)
                at[k] += way[k] * next;
            at[mirror] = way[mirror] > 0.0 ? 1.0 : 0.0;
            up += next;
            way[mirror] = -way[mirror];
            light *= box->rho;
        }
        sum += light;
    }
    return sum / RAYS;
}

/* About 40,000 evenly spread points are accurate to three digits. */
static void luminances_are_those_of_rays_that_are_followed(void **state)
{
    (void)state;
    static const double altitudes[] = {4.0, 13.0, 31.0, 52.0, 77.0};
    static const struct pp_mirror_box boxes[] = {{0.85, 0.5}, {0.6, 1.3}};
    for (int b = 0; b < 2; b++)
        for (int i = 0; i < 5; i++)
            assert_near(pp_mirror_box_luminance(&boxes[b], altitudes[i] * PP_RAD),
                        followed(&boxes[b], altitudes[i] * PP_RAD), 1e-3);
}

static void the_box_is_darker_towards_the_horizon_and_needs_more_correction(
    void **state)
{
    (void)state;
    const struct pp_mirror_box box = {0.85, 0.5};
    double before = 0.0;
    for (int degree = 1; degree <= 90; degree++) {
        double now = pp_mirror_box_luminance(&box, degree * PP_RAD);
        assert_true(now >= before && now <= 1.0);
        before = now;
    }
    assert_near(pp_mirror_box_luminance(&box, 0.5 * PP_PI), 1.0, 1e-12);
    /* The box is too dark at low altitudes and too bright halfway up: more than 1 at 3
     * degrees, less at 30. */
    assert_true(pp_mirror_box_correction(&box, 3.0 * PP_RAD) > 1.5);
    assert_true(pp_mirror_box_correction(&box, 30.0 * PP_RAD) < 1.0);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(perfect_mirrors_make_a_uniform_sky),
        cmocka_unit_test(luminances_are_those_of_rays_that_are_followed),
        cmocka_unit_test(
            the_box_is_darker_towards_the_horizon_and_needs_more_correction),
    };
    add_tests(tests, NULL, NULL);
}
