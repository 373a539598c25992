/* test_gradation.c - no closed form assumes the overcast sky's gradation of 2: moments,
 * Waldram's diagram, a protractor and pepper-pot dots integrate a sky with another
 * gradation to the same value as a simple sum. */
#include "methods/exact/solid_angle.h"
#include "methods/pepper_pot/pepper_pot_dots.h"
#include "methods/protractor/protractor_scale.h"
#include "methods/waldram/waldram_scale.h"

#include "tests/lib/near.h"

static const double gradations[] = {0.0, 1.0, 2.0, 5.0};
enum { GRADATIONS = 4 };

/* A vertical window from a0 to a1 and 0 to b1 at the distance 1. */
static const double a0 = -0.7, a1 = 1.6, b1 = 0.9;

/* Sky component of the unglazed window, by midpoints over its plane, with L/Eh = 3 (1 +
 * b sin) / ((3 + 2b) pi). */
static double by_sum(double b)
{
    enum { STEPS = 400 };
    double sum = 0.0;
    for (int i = 0; i < STEPS; i++)
        for (int j = 0; j < STEPS; j++) {
            double x = a0 + (a1 - a0) * (i + 0.5) / STEPS, z = b1 * (j + 0.5) / STEPS;
            double r = sqrt(1.0 + x * x + z * z);
            sum += (1.0 + b * z / r) * (z / r) / (r * r * r);
        }
    return sum * (a1 - a0) * b1 / STEPS / STEPS * 3.0 / ((3.0 + 2.0 * b) * PP_PI);
}

static double by_moments(const struct pp_sky *sky)
{
    const struct pp_vec3 up = {0.0, 0.0, 1.0};
    const struct pp_vec3 corners[] = {
        {a0, 1.0, b1}, {a0, 1.0, 0.0}, {a1, 1.0, 0.0}, {a1, 1.0, b1}};
    struct pp_moments moments = {0};
    pp_solid_angle_add_moments(&moments, corners, 4, up, &up, 1);
    return pp_solid_angle_sky_component(&moments, sky);
}

static double by_waldram(const struct pp_sky *sky)
{
    const struct pp_window_axes axes = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    double xy[4][2] = {{a0, 0.0}, {a1, 0.0}, {a1, b1}, {a0, b1}};
    struct pp_ring ring = {4, xy};
    struct pp_region region = {1, &ring};
    struct pp_waldram waldram;
    assert_int_equal(pp_waldram_scale_init(&waldram, sky, false, NULL), PP_OK);
    return pp_waldram_scale_area(&waldram, &axes, &region);
}

static double by_dots(const struct pp_sky *sky)
{
    double xy[4][2] = {{a0, 0.0}, {a1, 0.0}, {a1, b1}, {a0, b1}};
    struct pp_ring ring = {4, xy};
    struct pp_region region = {1, &ring};
    struct pp_pepper_pot *pot;
    assert_int_equal(
        pp_pepper_pot_dots_create(&pot, sky, false, false, 0.0, 1e-5, NULL), PP_OK);
    double share = pp_pepper_pot_dots_count(pot, &region) * pot->worth;
    pp_pepper_pot_dots_destroy(pot);
    return share;
}

static void a_window_by_four_ways(void **state)
{
    (void)state;
    for (int i = 0; i < GRADATIONS; i++) {
        struct pp_sky sky = pp_sky_graded(gradations[i]);
        double sum = by_sum(gradations[i]);
        assert_near(by_moments(&sky), sum, 1e-6);
        assert_near(by_waldram(&sky), sum, 1e-6);
        assert_near(by_dots(&sky), sum, 1e-4);
    }
}

/* The scales of an unglazed protractor compared with sums of its density. */
static void scales_of_a_protractor_are_the_sums_of_its_density(void **state)
{
    (void)state;
    enum { STEPS = 300 };
    for (int i = 0; i < GRADATIONS; i++) {
        struct pp_protractor protractor = {.sky = pp_sky_graded(gradations[i]),
                                           .glass = pp_glass_none(),
                                           .slope_rad = PP_PI / 2.0};
        double gamma = 1.1, theta = 0.6, sum = 0.0, part = 0.0, strip = 0.0;
        for (int j = 0; j < STEPS; j++) {
            double t = PP_PI / 2.0 * (j + 0.5) / STEPS;
            for (int k = 0; k < STEPS; k++)
                sum += 2.0 * PP_PI / 2.0 * gamma / STEPS / STEPS
                       * pp_protractor_scale_density(&protractor,
                                                     gamma * (k + 0.5) / STEPS, t);
            strip += pp_protractor_scale_density(&protractor, gamma, t) / STEPS;
            part += pp_protractor_scale_density(&protractor, gamma,
                                                theta * (j + 0.5) / STEPS)
                    / STEPS;
        }
        assert_near(pp_protractor_scale_primary(&protractor, gamma), sum, 1e-5);
        assert_near(pp_protractor_scale_auxiliary(&protractor, gamma, theta),
                    0.5 * part * theta / (strip * PP_PI / 2.0), 1e-5);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_window_by_four_ways),
        cmocka_unit_test(scales_of_a_protractor_are_the_sums_of_its_density),
    };
    add_tests(tests, NULL, NULL);
}
