/* test_rough_lobe.c - sampled directions of a physically rough surface give the albedo
 * found by quadrature. */
#include "simulate/sampling/rough_lobe.h"

#include "tests/lib/near.h"
#include "tests/model/light/towards.h"

static const struct pp_rough_surface *surface_of(double s0, double t, double k)
{
    static struct pp_rough_surface surface;
    const struct pp_rough_optics optics = {
        {1.0, 1.0, 1.0}, {k, k, k}, {0.55, 0.55, 0.55}, s0, t, {0.0, 0.0, 0.0}};
    assert_int_equal(pp_rough_surface_init(&surface, &optics, NULL), PP_OK);
    return &surface;
}

/* The mean weight over a grid of random numbers is the albedo from the quadrature of
 * the tables, to their error of 0.6 % between angles; every sampled direction has the
 * stated density. */
static void drawn_directions_carry_the_albedo(void **state)
{
    (void)state;
    enum { RADII = 200, AZIMUTHS = 32, ALL = RADII * AZIMUTHS };
    const double surfaces[][3] = {
        {0.05, 3.0, 1e5}, {0.28, 1.77, 2.59}, {3.0, 15.0, 1e5}, {0.05, 20.0, 6.0}};
    const double tilts[] = {0.0, 33.0, 60.0, 80.0, 87.0};
    for (int k = 0; k < 4; k++) {
        const double *of = surfaces[k];
        const struct pp_rough_surface *surface = surface_of(of[0], of[1], of[2]);
        for (int t = 0; t < 5; t++) {
            struct pp_vec3 eye = pp_test_towards(tilts[t], 40.0), to;
            double sum = 0.0, most = 0.0;
            for (int i = 0; i < ALL; i++) {
                double per =
                    pp_rough_lobe_sample(surface, eye, (i / AZIMUTHS + 0.5) / RADII,
                                         (i % AZIMUTHS + 0.5) / AZIMUTHS, &to);
                if (!(per > 0.0))
                    continue;
                assert_near(pp_vec_length(to), 1.0, 1e-12);
                assert_relative(per * pp_rough_lobe_pdf(surface, eye, to), 1.0, 1e-9);
                double weight = pp_rough_surface_value(surface, eye, to).g * to.z * per;
                sum += weight / ALL;
                most = fmax(most, weight);
            }
            double albedo = pp_rough_surface_lobe(surface, eye.z).g;
            assert_near(sum, albedo, 6e-3 * fmax(albedo, 0.1));
            assert_true(most < 4.0 * albedo); /* no direction is drawn too rarely */
        }
    }
}

/* The density integrates to 1, less the part that the lobe cannot reach. */
static void the_density_is_one_of_probability(void **state)
{
    (void)state;
    enum { SIDE = 800 };
    const struct pp_rough_surface *surface = surface_of(0.28, 1.77, 1e5);
    for (double tilt = 5.0; tilt < 90.0; tilt += 40.0) {
        double sum = 0.0;
        for (int i = 0; i < SIDE * SIDE; i++) {
            double t = (i / SIDE + 0.5) / SIDE * 90.0;
            struct pp_vec3 to = pp_test_towards(t, (i % SIDE + 0.5) / SIDE * 360.0);
            sum += pp_rough_lobe_pdf(surface, pp_test_towards(tilt, 77.0), to)
                   * sin(t * PP_RAD) * PP_PI * PP_PI / (SIDE * SIDE);
        }
        assert_near(sum, 1.0, 3e-3);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(drawn_directions_carry_the_albedo),
        cmocka_unit_test(the_density_is_one_of_probability),
    };
    add_tests(tests, NULL, NULL);
}
