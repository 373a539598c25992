/* test_bump_lobe.c - sampled directions of a surface with bumps carry its albedo. */
#include "simulate/sampling/bump_lobe.h"

#include "tests/lib/near.h"
#include "tests/model/light/towards.h"

static struct pp_bump_lobe lobe_of(double slope, double tilt_deg)
{
    return (struct pp_bump_lobe){.slope = {slope * 0.6, slope * 0.8, 0.0},
                                 .facet = {0.8, 0.4, 0.05},
                                 .normal = {0.0, 0.0, 1.0},
                                 .eye = pp_test_towards(tilt_deg, 20.0)};
}

/* The mean light over a grid of random numbers is the albedo in each colour; each
 * direction has the stated density, and none carries more light than facets reflect to
 * each other: 0.8 + 0.8^2 + ... = 4. */
static void drawn_directions_carry_the_albedo(void **state)
{
    (void)state;
    enum { SIDE = 300, ALL = SIDE * SIDE };
    for (double slope = 0.05; slope < 5.0; slope *= 4.0)
        for (double tilt = 0.0; tilt < 90.0; tilt += 28.0) {
            struct pp_bump_lobe lobe = lobe_of(slope, tilt);
            struct pp_rgb sum = pp_rgb_grey(0.0), light;
            struct pp_rgb albedo = pp_bump_lobe_albedo(&lobe);
            for (int i = 0; i < ALL; i++) {
                struct pp_vec3 o;
                if (!pp_bump_lobe_sample(&lobe, (i / SIDE + 0.5) / SIDE,
                                         (i % SIDE + 0.5) / SIDE, &o, &light))
                    continue;
                struct pp_rgb brdf = pp_bump_lobe_brdf(&lobe, o);
                double density = pp_bump_lobe_pdf(&lobe, o);
                assert_near(light.r * density, brdf.r * o.z, 1e-12);
                assert_true(pp_rgb_most(light) < 4.0);
                sum = pp_rgb_along(sum, 1.0 / ALL, light);
            }
            assert_near(sum.r, albedo.r, 3e-3);
            assert_near(sum.g, albedo.g, 3e-3);
            assert_near(sum.b, albedo.b, 3e-3);
        }
}

/* Light that is reflected several times between facets has a deeper colour. */
static void bumps_deepen_the_colour(void **state)
{
    (void)state;
    struct pp_bump_lobe low = lobe_of(0.05, 30.0), high = lobe_of(2.0, 30.0);
    struct pp_rgb of_low = pp_bump_lobe_albedo(&low),
                  of_high = pp_bump_lobe_albedo(&high);
    assert_true(of_high.b / of_high.r < 0.7 * of_low.b / of_low.r);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(drawn_directions_carry_the_albedo),
        cmocka_unit_test(bumps_deepen_the_colour),
    };
    add_tests(tests, NULL, NULL);
}
