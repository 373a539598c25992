/* test_glass.c - transmittance by angle of incidence. */
#include "model/light/glass_curve.h"

#include "model/light/glazings.h"

#include "tests/lib/near.h"

#define RAD (3.14159265358979323846 / 180.0)

/* Angles 0 to 80 degrees; four printed digits of an independent calculation. */
static void one_and_two_panes_by_angle(void **state)
{
    (void)state;
    static const double lossless[] = {.9183, .9183, .9179, .9160, .9095,
                                      .8912, .8435, .7247, .4560};
    static const double single[] = {.9001, .8999, .8992, .8967, .8895,
                                    .8705, .8226, .7051, .4403};
    static const double twofold[] = {.8154, .8151, .8141, .8110, .8027,
                                     .7808, .7223, .5722, .2855};
    struct pp_glass clear = pp_glass_panes(1, 1.52, 0.0);
    struct pp_glass brs = pp_glass_clear_single();
    struct pp_glass two = pp_glass_panes(2, 1.52, 0.02);
    for (int i = 0; i <= 8; i++) {
        double c = cos(10.0 * i * RAD);
        assert_near(pp_glass_transmittance(&clear, c), lossless[i], 5e-5);
        assert_near(pp_glass_transmittance(&brs, c), single[i], 5e-5);
        assert_near(pp_glass_transmittance(&two, c), twofold[i], 5e-5);
    }
}

/* Radiance's `glass` with a normal transmittance of 0.70 has a transmissivity of
 * 0.762842 per passage for n 1.52. At 60 degrees cos r = sqrt(1 - 0.75/1.52^2) =
 * 0.82182, a = 0.762842^(1/0.82182) = 0.719357; reflectances s 0.183438, p 0.001527:
 * (0.488148 + 0.717162)/2. */
static void absorbing_glass_is_that_of_radiance(void **state)
{
    (void)state;
    struct pp_glass glass = pp_glass_absorbing(0.7);
    assert_near(exp(-glass.kl), 0.762842, 1e-6);
    assert_near(pp_glass_transmittance(&glass, 1.0), 0.7, 1e-12);
    assert_near(pp_glass_transmittance(&glass, 0.5), 0.602655, 2e-6);
    assert_near(pp_glass_absorbing(PP_GLASS_ABSORBING_MOST).kl, 0.0, 1e-3);
}

static void diffuse_transmittances(void **state)
{
    (void)state;
    assert_near(pp_glass_panes(1, 1.52, 0.0).diffuse, 0.8464, 5e-5);
    assert_near(pp_glass_clear_single().diffuse, 0.8269, 5e-5);
    assert_near(pp_glass_panes(1, 1.52, 0.025).diffuse, 0.8221, 5e-5);
    assert_near(pp_glass_panes(2, 1.52, 0.0).diffuse, 0.7646, 5e-5);
    assert_near(pp_glass_panes(2, 1.52, 0.02).diffuse, 0.7292, 5e-5);
}

/* The values stored for this pane agree with the integral except for rounding. */
static void the_brs_pane_is_the_sum_over_its_angles(void **state)
{
    (void)state;
    struct pp_glass brs = pp_glass_clear_single(),
                    summed = pp_glass_panes(1, 1.52, 0.02);
    assert_near(brs.normal, summed.normal, 1e-15);
    assert_near(brs.diffuse, summed.diffuse, 1e-14);
    for (double c = 0.03; c <= 1.0; c += 0.13)
        assert_near(pp_glass_transmittance(&brs, c), pp_glass_transmittance(&summed, c),
                    0.0);
}

/* Without absorption the light that is not reflected is transmitted, at every angle and
 * for any number of panes; at grazing incidence none is transmitted. */
static void lossless_glass_keeps_all_light(void **state)
{
    (void)state;
    for (int panes = 1; panes <= 4; panes++) {
        struct pp_glass glass = pp_glass_panes(panes, 1.52, 0.0);
        for (double c = 0.013; c < 1.0; c += 0.037)
            assert_near(pp_glass_transmittance(&glass, c)
                            + pp_glass_reflectance(&glass, c),
                        1.0, 1e-13);
        /* A direction in the plane of the glass may have a tiny cosine. */
        for (double c = 0.0; c < 3e-17; c += 1e-17) {
            assert_near(pp_glass_transmittance(&glass, c), 0.0, 0.0);
            assert_near(pp_glass_reflectance(&glass, c), 1.0, 1e-13);
        }
    }
}

static void a_normal_transmittance_scales_the_pane_at_every_angle(void **state)
{
    (void)state;
    struct pp_glass brs = pp_glass_clear_single();
    struct pp_glass tinted = pp_glass_of_normal(1, 1.52, 0.02, 0.37);
    for (double c = 0.07; c <= 1.0; c += 0.1)
        assert_relative(pp_glass_transmittance(&tinted, c),
                        0.37 / brs.normal * pp_glass_transmittance(&brs, c), 1e-14);
    assert_near(tinted.normal, 0.37, 0.0);
    assert_relative(tinted.diffuse / tinted.normal, brs.diffuse / brs.normal, 1e-14);
}

static void no_glazing_gives_more_than_it_gets(void **state)
{
    (void)state;
    struct pp_glass clearest = pp_glass_of_normal(1, 1.52, 0.02, 1.0);
    for (double c = 0.0; c <= 1.0; c += 0.01)
        assert_true(pp_glass_transmittance(&clearest, c)
                        + pp_glass_reflectance(&clearest, c)
                    <= 1.0 + 1e-15);
}

/* Normal transmittances of ordinary products, as published by manufacturers, and of
 * diffusing glass; the transmittance of every clear glass decreases with the angle. */
static void named_glazings_are_within_their_published_ranges(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double low, high;
    } published[] = {
        {"clear-single", 0.88, 0.90},       {"clear-double", 0.78, 0.82},
        {"clear-triple", 0.70, 0.74},       {"low-e-double", 0.70, 0.80},
        {"low-e-triple", 0.55, 0.70},       {"solar-control-light", 0.30, 0.70},
        {"solar-control-dark", 0.30, 0.70}, {"etched-glass", 0.70, 0.85},
        {"opal-glass", 0.30, 0.65},         {"opal-glass-solid", 0.15, 0.40},
        {"opal-acrylic", 0.30, 0.70},
    };
    for (size_t i = 0; i < sizeof published / sizeof *published; i++) {
        const struct pp_glazing *glazing = pp_glazings_find(published[i].name);
        assert_non_null(glazing);
        struct pp_glass glass = pp_glazings_glass(glazing);
        double shown = glass.diffusing ? glass.diffuse : glass.normal;
        /* half a unit of the last digit of the range */
        assert_true(shown >= published[i].low - 0.005);
        assert_true(shown <= published[i].high + 0.005);
    }
    for (int i = 0; i < pp_glazings_count(); i++) {
        struct pp_glass glass = pp_glazings_glass(pp_glazings_at(i));
        assert_true(glass.diffuse > 0.0 && glass.diffuse <= 1.0);
        for (int deg = 5; deg < 90 && !glass.diffusing; deg += 5)
            assert_true(pp_glass_transmittance(&glass, cos(deg * RAD))
                        <= pp_glass_transmittance(&glass, cos((deg - 5) * RAD)));
    }
}

static void an_unglazed_opening_lets_all_through_at_any_angle(void **state)
{
    (void)state;
    struct pp_glass none = pp_glass_none();
    assert_near(pp_glass_transmittance(&none, 0.0), 1.0, 0.0);
    assert_near(pp_glass_transmittance(&none, 0.31), 1.0, 0.0);
    assert_near(pp_glass_reflectance(&none, 0.31), 0.0, 0.0);
    assert_near(none.diffuse, 1.0, 0.0);
}

/* Compares glass_curve.h with glass.h, for glazings from clear to dark. */
static void a_tabulated_law_is_the_law(void **state)
{
    (void)state;
    static struct pp_glass_curve curve;
    for (int panes = 0; panes <= 4; panes++)
        for (double kl = 1e-5; kl < 0.5; kl *= 3.0) {
            struct pp_glass glass =
                panes == 0 ? pp_glass_none()
                           : pp_glass_of_normal(panes, 1.52, kl, kl > 0.1 ? 0.3 : 0.6);
            pp_glass_curve_init(&curve, &glass);
            for (int i = 0; i <= 20011; i++) {
                double cosine = i / 20011.0;
                assert_near(pp_glass_curve_transmittance(&curve, cosine),
                            pp_glass_transmittance(&glass, cosine), 1e-8);
                assert_near(pp_glass_curve_reflectance(&curve, cosine),
                            pp_glass_reflectance(&glass, cosine), 1e-8);
            }
            assert_near(pp_glass_curve_transmittance(&curve, -0.1),
                        pp_glass_transmittance(&glass, -0.1), 0.0);
        }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tabulated_law_is_the_law),
        cmocka_unit_test(one_and_two_panes_by_angle),
        cmocka_unit_test(absorbing_glass_is_that_of_radiance),
        cmocka_unit_test(diffuse_transmittances),
        cmocka_unit_test(the_brs_pane_is_the_sum_over_its_angles),
        cmocka_unit_test(lossless_glass_keeps_all_light),
        cmocka_unit_test(a_normal_transmittance_scales_the_pane_at_every_angle),
        cmocka_unit_test(no_glazing_gives_more_than_it_gets),
        cmocka_unit_test(named_glazings_are_within_their_published_ranges),
        cmocka_unit_test(an_unglazed_opening_lets_all_through_at_any_angle),
    };
    add_tests(tests, NULL, NULL);
}
