/* test_bump_facets.c - the facets of bumps reflect no more light than they receive, and
 * the same in both directions. */
#include "model/light/rough/bump_facets.h"

#include "tests/lib/near.h"
#include "tests/model/light/towards.h"

/* Facets of a level surface that rises by the slope along x. */
static struct pp_bump_facets rising(double slope)
{
    return pp_bump_facets_of(pp_vec(0.0, 0.0, 1.0), pp_vec(slope, 0.0, 0.0));
}

/* Light of the facets under light from a direction. */
static void lit(const struct pp_bump_facets *facets, double reflectance,
                struct pp_vec3 from, double light[PP_BUMP_KINDS])
{
    double shares[PP_BUMP_KINDS];
    pp_bump_facets_shares(facets, from, shares);
    pp_bump_facets_light(facets, reflectance, shares, light);
}

/* By hand: tilted facets at 45 degrees have an area of sqrt 2, their steps of 1. By
 * crossed strings, the tilted facets send (sqrt 2 + 1 - 1) / (2 sqrt 2) = 1/2 of their
 * light to the sky, and the steps (1 + 1 - sqrt 2) / 2. With a reflectance of 1/2 and
 * diffuse light, the facets receive 0.7071 and 0.2929, and send off 0.4446 and 0.2576. */
static void a_slope_of_1_and_half_the_light(void **state)
{
    (void)state;
    struct pp_bump_facets facets = rising(1.0);
    assert_near(facets.area[PP_BUMP_TILTED], sqrt(2.0), 1e-15);
    assert_near(facets.area[PP_BUMP_STEP], 1.0, 1e-15);
    assert_near(facets.leaving[PP_BUMP_TILTED], 0.5, 1e-15);
    assert_near(facets.leaving[PP_BUMP_STEP], 1.0 - sqrt(0.5), 1e-15);
    assert_near(facets.normal[PP_BUMP_TILTED].x, -sqrt(0.5), 1e-15);
    assert_near(facets.normal[PP_BUMP_STEP].x, 1.0, 1e-15);
    assert_near(pp_bump_facets_reflectance(1.0, 0.5), 0.5 * 0.4446 + 0.2929 * 0.2576,
                1e-4);
}

static void a_white_surface_reflects_all_light(void **state)
{
    (void)state;
    for (double slope = 0.01; slope < 20.0; slope *= 3.0) {
        struct pp_bump_facets facets = rising(slope);
        for (double tilt = 0.0; tilt < 90.0; tilt += 22.2) {
            double light[PP_BUMP_KINDS];
            lit(&facets, 1.0, pp_test_towards(tilt, 3.0 * tilt), light);
            assert_near(pp_bump_facets_albedo(&facets, light), 1.0, 1e-12);
        }
        assert_near(pp_bump_facets_reflectance(slope, 1.0), 1.0, 1e-12);
    }
}

/* Exchanging the two directions changes nothing, whatever the facets reflect to each
 * other. */
static void the_reflection_is_reciprocal(void **state)
{
    (void)state;
    for (int i = 0; i < 200; i++) {
        struct pp_bump_facets facets = rising(0.05 + 0.02 * i);
        struct pp_vec3 a = pp_test_towards(fmod(7.3 * i, 89.0), 31.0 * i),
                       b = pp_test_towards(fmod(3.1 * i, 89.0), 17.0 * i);
        double of_a[PP_BUMP_KINDS], of_b[PP_BUMP_KINDS];
        lit(&facets, 0.8, a, of_a);
        lit(&facets, 0.8, b, of_b);
        assert_near(pp_bump_facets_brdf(&facets, of_a, b),
                    pp_bump_facets_brdf(&facets, of_b, a), 1e-12);
    }
}

/* Midpoint rule over the hemisphere: the sum of a function times cosine / pi. */
static double over_hemisphere(double (*of)(const struct pp_bump_facets *,
                                           const double *, struct pp_vec3),
                              const struct pp_bump_facets *facets, const double *light)
{
    enum { TILTS = 400, AZIMUTHS = 400 };
    double sum = 0.0;
    for (int i = 0; i < TILTS; i++)
        for (int k = 0; k < AZIMUTHS; k++) {
            double sine2 = (i + 0.5) / TILTS, z = sqrt(1.0 - sine2);
            double azimuth = 2.0 * PP_PI * (k + 0.5) / AZIMUTHS;
            struct pp_vec3 o =
                pp_vec(sqrt(sine2) * cos(azimuth), sqrt(sine2) * sin(azimuth), z);
            sum += of(facets, light, o) / (TILTS * AZIMUTHS);
        }
    return sum;
}

static double brdf_over_lambert(const struct pp_bump_facets *facets,
                                const double *light, struct pp_vec3 o)
{
    return PP_PI * pp_bump_facets_brdf(facets, light, o);
}

/* The fractions from crossed strings agree with the integral of the BRDF. */
static void the_albedo_is_the_integral_of_the_brdf(void **state)
{
    (void)state;
    for (double slope = 0.1; slope < 5.0; slope *= 3.0)
        for (double tilt = 0.0; tilt < 90.0; tilt += 40.0) {
            struct pp_bump_facets facets = rising(slope);
            double light[PP_BUMP_KINDS];
            lit(&facets, 0.7, pp_test_towards(tilt, 160.0), light);
            assert_near(over_hemisphere(brdf_over_lambert, &facets, light),
                        pp_bump_facets_albedo(&facets, light), 5e-4);
        }
}

static double albedo_from(const struct pp_bump_facets *facets, const double *unused,
                          struct pp_vec3 o)
{
    (void)unused;
    double light[PP_BUMP_KINDS];
    lit(facets, 0.7, o, light);
    return pp_bump_facets_albedo(facets, light);
}

static void diffuse_light_is_the_mean_over_all_directions(void **state)
{
    (void)state;
    for (double slope = 0.1; slope < 5.0; slope *= 3.0) {
        struct pp_bump_facets facets = rising(slope);
        assert_near(over_hemisphere(albedo_from, &facets, NULL),
                    pp_bump_facets_reflectance(slope, 0.7), 5e-4);
    }
}

/* Low bumps reflect like a plane surface. Higher ones trap light, at most that of a
 * cavity whose area is that of all facets. */
static void bumps_trap_light(void **state)
{
    (void)state;
    assert_near(pp_bump_facets_reflectance(0.0, 0.6), 0.6, 0.0);
    assert_near(pp_bump_facets_reflectance(1e-6, 0.6), 0.6, 1e-6);
    double last = 0.6;
    for (double slope = 0.1; slope < 10.0; slope *= 1.5) {
        double now = pp_bump_facets_reflectance(slope, 0.6);
        double area = slope + sqrt(1.0 + slope * slope);
        assert_true(now < last && now < 0.6);
        assert_near(now, 0.6 / (area - 0.6 * (area - 1.0)), 0.02);
        last = now;
    }
}

/* Light along the facets, or from below the surface, reaches no facet. */
static void nothing_is_seen_from_below(void **state)
{
    (void)state;
    struct pp_bump_facets facets = rising(0.5);
    double shares[PP_BUMP_KINDS];
    pp_bump_facets_shares(&facets, pp_vec(1.0, 0.0, -1e-9), shares);
    assert_true(shares[PP_BUMP_TILTED] == 0.0 && shares[PP_BUMP_STEP] == 0.0);
    /* From the side that the facets face, no step is seen. */
    pp_bump_facets_shares(&facets, pp_test_towards(60.0, 180.0), shares);
    assert_true(shares[PP_BUMP_TILTED] == 1.0 && shares[PP_BUMP_STEP] == 0.0);
    /* From behind the crests, only steps are seen. */
    pp_bump_facets_shares(&facets, pp_test_towards(80.0, 0.0), shares);
    assert_true(shares[PP_BUMP_TILTED] == 0.0 && shares[PP_BUMP_STEP] == 1.0);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_slope_of_1_and_half_the_light),
        cmocka_unit_test(a_white_surface_reflects_all_light),
        cmocka_unit_test(the_reflection_is_reciprocal),
        cmocka_unit_test(the_albedo_is_the_integral_of_the_brdf),
        cmocka_unit_test(diffuse_light_is_the_mean_over_all_directions),
        cmocka_unit_test(bumps_trap_light),
        cmocka_unit_test(nothing_is_seen_from_below),
    };
    add_tests(tests, NULL, NULL);
}
