/* test_he_torrance.c - the physical model of rough surfaces compared with given values
 * and its limits, and its reciprocity. */
#include "model/light/rough/he_torrance.h"

#include "tests/lib/near.h"
#include "tests/model/light/towards.h"

static struct pp_he_torrance_direction over(const struct pp_he_torrance *surface,
                                            struct pp_vec3 to)
{
    return pp_he_torrance_towards(to, surface->roughness, surface->correlation);
}

/* A table calculated by another program, with which Radiance's He.cal, with tighter
 * tolerances, agreed to 6e-6: n, k, wavelength, s0, T (micrometres), the tilts of
 * incidence and exit and the azimuth between them (0: the mirror side), s, g, S1 S1, F
 * and the directional diffuse part; 8 digits. */
static const double given[][13] = {
    {0.62, 5.47, 0.45, 0.05, 3.0, 30, 20, 0, 0.05, 1.5891855, 1, 0.92350429,
     0.41389778},
    {0.62, 5.47, 0.45, 0.28, 1.77, 30, 75, 0, 0.27606094, 18.798775, 0.84473127,
     0.91698112, 0.63252239},
    {0.62, 5.47, 0.45, 0.28, 1.77, 60, 85, 0, 0.1998028, 2.683147, 0.40604512,
     0.89481093, 4.3442961},
    {0.62, 5.47, 0.45, 1.0, 10.0, 30, 20, 90, 1, 635.67419, 1, 0.92372518, 0.1674789},
    {0.96, 6.69, 0.55, 3.0, 15.0, 10, 30, 180, 3, 4023.5686, 1, 0.9209762, 0.30093931},
    {0.96, 6.69, 0.55, 3.0, 15.0, 80, 85, 0, 1.9472499, 33.659368, 0.19538923,
     0.86910219, 13.309755},
    {1.47, 7.79, 0.65, 0.28, 1.77, 30, 60, 180, 0.27999838, 13.669782, 0.99447043,
     0.91191228, 0.0010884123},
    {1.18, 2.4, 0.45, 0.28, 3.0, 30, 60, 0, 0.28, 28.521235, 0.99999361, 0.55170483,
     0.41178499},
    {1.04, 2.59, 0.55, 0.05, 3.0, 60, 85, 0, 0.049999994, 0.11248145, 0.99989047,
     0.65096863, 0.12487614},
    {1.04, 2.59, 0.55, 0.28, 1.77, 30, 75, 45, 0.27606094, 12.584304, 0.84473127,
     0.61579743, 0.069092494},
    {1.5, 0.0, 0.55, 0.28, 1.77, 60, 60, 0, 0.2799935, 10.231287, 0.98897144,
     0.089186713, 0.31592028},
    {1.5, 0.0, 0.55, 1.0, 10.0, 10, 10, 45, 1, 506.28757, 1, 0.040011208, 0.074026701},
};
enum { GIVEN = sizeof given / sizeof *given };

static void rough_surfaces_reflect_as_given(void **state)
{
    (void)state;
    for (int i = 0; i < GIVEN; i++) {
        const double *row = given[i];
        struct pp_he_torrance surface = {row[0], row[1], row[2], row[3], row[4]};
        struct pp_he_torrance_direction in =
            over(&surface, pp_test_towards(row[5], 180.0));
        struct pp_he_torrance_direction out =
            over(&surface, pp_test_towards(row[6], row[7]));
        double s = pp_he_torrance_roughness(&in, &out, surface.roughness), half;
        double g = pow(2.0 * PP_PI * s * (in.cosine + out.cosine) / row[2], 2.0);
        pp_he_torrance_lobe(&surface, s, &in, &out, &half);
        assert_relative(s, row[8], 1e-7);
        assert_relative(g, row[9], 1e-7);
        assert_relative(in.shadow * out.shadow, row[10], 1e-7);
        assert_relative(pp_he_torrance_fresnel(row[0], row[1], half), row[11], 1e-7);
        double value = pp_he_torrance_diffuse(&surface, &in, &out);
        assert_relative(value, row[12], 1e-6);
        assert_relative(pp_he_torrance_diffuse(&surface, &out, &in), value, 1e-12);
    }
}

/* At normal incidence ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2), at grazing incidence 1. At
 * Brewster's angle no p-polarised light is reflected, and s-polarised light by ((n^2 -
 * 1)/(n^2 + 1))^2. */
static void a_smooth_surface_reflects_by_fresnel(void **state)
{
    (void)state;
    assert_relative(pp_he_torrance_fresnel(0.96, 6.69, 1.0),
                    (0.04 * 0.04 + 6.69 * 6.69) / (1.96 * 1.96 + 6.69 * 6.69), 1e-13);
    assert_near(pp_he_torrance_fresnel(0.96, 6.69, 0.0), 1.0, 1e-12);
    double n2 = 1.52 * 1.52;
    assert_relative(pp_he_torrance_fresnel(1.52, 0.0, cos(atan(1.52))),
                    pow((n2 - 1.0) / (n2 + 1.0), 2.0) / 2.0, 1e-12);

    struct pp_he_torrance smooth = {1.2, 2.5, 0.55, 1e-6, 3.0};
    struct pp_he_torrance_direction in = over(&smooth, pp_test_towards(37.0, 180.0));
    struct pp_he_torrance_direction out = over(&smooth, pp_test_towards(37.0, 3.0));
    assert_relative(pp_he_torrance_spike(&smooth, &in),
                    pp_he_torrance_fresnel(1.2, 2.5, cos(37.0 * PP_RAD)), 1e-6);
    assert_true(pp_he_torrance_diffuse(&smooth, &in, &out) < 1e-6);
}

/* g = 3,150: no spike, and the facets of Cook and Torrance with Beckmann's slopes of m
 * = 2 s0/T. */
static void a_very_rough_surface_consists_of_facets(void **state)
{
    (void)state;
    struct pp_he_torrance rough = {0.96, 6.69, 0.55, 3.0, 15.0};
    struct pp_vec3 i = pp_test_towards(28.0, 180.0), r = pp_test_towards(41.0, 23.0);
    struct pp_he_torrance_direction in = over(&rough, i), out = over(&rough, r);
    struct pp_vec3 v = pp_vec_add(i, r);
    double c = v.z / pp_vec_length(v), m = 0.4, tan2 = 1.0 / (c * c) - 1.0;
    double facets = pp_he_torrance_fresnel(0.96, 6.69, pp_vec_length(v) / 2.0)
                    * in.shadow * out.shadow * exp(-tan2 / (m * m))
                    / (4.0 * PP_PI * m * m * c * c * c * c * i.z * r.z);
    assert_relative(pp_he_torrance_diffuse(&rough, &in, &out), facets, 3e-3);
    assert_true(pp_he_torrance_spike(&rough, &in) < 1e-100);
}

/* Compared with the sum of all terms from 1 on; the program only adds the largest
 * terms, and if there are many of them, only some. */
static void the_series_is_the_sum_of_its_terms(void **state)
{
    (void)state;
    const double values[][2] = {{0.013, 0.2},  {1.9, 3.3},    {31.0, 4.0},
                                {31.0, 900.0}, {2100.0, 0.7}, {2100.0, 9000.0}};
    for (int i = 0; i < 6; i++) {
        double g = values[i][0], e = values[i][1], sum = 0.0;
        for (int m = 1; m < 5000; m++) {
            int sign;
            sum += exp(m * log(g) - g - lgamma_r(m + 1.0, &sign) - log(m) - e / m);
        }
        assert_relative(pp_he_torrance_series(g, e), sum, 1e-11);
    }
    assert_near(pp_he_torrance_series(0.0, 1.0), 0.0, 0.0);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rough_surfaces_reflect_as_given),
        cmocka_unit_test(a_smooth_surface_reflects_by_fresnel),
        cmocka_unit_test(a_very_rough_surface_consists_of_facets),
        cmocka_unit_test(the_series_is_the_sum_of_its_terms),
    };
    add_tests(tests, NULL, NULL);
}
