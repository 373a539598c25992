/* test_perez_sky.c - the Perez sky of an hour. */
#include "tests/lib/near.h"

#include "model/light/perez_sky.h"
#include "model/light/sky_patches.h"

static struct pp_vec3 toward(double altitude_deg, double bearing_deg)
{
    double h = altitude_deg * PP_RAD, az = bearing_deg * PP_RAD;
    return pp_vec(cos(h) * sin(az), cos(h) * cos(az), sin(h));
}

static struct pp_perez_sky sky_of(double altitude_deg, double bearing_deg,
                                  double direct_w_m2, double diffuse_w_m2)
{
    struct pp_perez_conditions conditions = {
        .direct_w_m2 = direct_w_m2,
        .diffuse_w_m2 = diffuse_w_m2,
        .sun = toward(altitude_deg, bearing_deg),
        .sun_distance_au = 1.0 / sqrt(1.03502), /* as in gendaylit -ang */
        .dew_point_c = 10.97};
    return pp_perez_sky_of(&conditions);
}

/* One sky in each clearness bin: a to e as printed by Radiance's gendaylit 2.6 (six
 * digits, -O 2 -ang), and illuminances (lx) and relative luminances (1/sr) by an
 * independent program that normalises to 3e-4, at the centres of Tregenza's patches 1,
 * 85 and 145. */
static const struct {
    double altitude_deg, bearing_deg, direct_w_m2, diffuse_w_m2;
    double a, b, c, d, e, diffuse_lx, direct_lx, first, middle, zenith;
} published[] = {
    {20.8, 37.1, 5, 61, 0.7999, -0.630662, 0.414246, -0.365866, -0.03916, 7285.612,
     209.377, 0.2556987, 0.3351913, 0.3531893},
    {68.0, 235.4, 95, 460, -0.874782, -1.439106, 9.285614, -2.384469, 0.15382,
     52536.375, 9151.745, 0.147329, 0.1950579, 0.484438},
    {33.3, 73.0, 44, 131, -1.485873, -0.770426, 8.415573, -2.417481, 0.200292,
     15312.126, 4038.586, 0.377467, 0.259401, 0.1528205},
    {67.9, 332.8, 287, 415, -0.802743, -0.99275, 12.942998, -3.123373, 0.307043,
     48407.016, 27866.348, 0.2009762, 0.4332892, 0.5043158},
    {60.0, 50.0, 579, 494, -1.303334, -1.58024, 11.337295, -2.930873, -0.010405,
     56551.260, 55411.450, 0.2036686, 0.3697815, 0.3683095},
    {50.5, 246.9, 779, 257, -0.803948, -0.437927, 12.855111, -3.472554, 0.202084,
     32876.653, 76246.433, 0.2383722, 0.1625969, 0.256967},
    {6.2, 91.6, 274, 16, -0.993081, -0.182671, 11.536451, -3.888278, 0.462808, 2762.037,
     18333.575, 0.6314788, 0.1879713, 0.1344972},
    {57.0, 333.9, 502, 72, -0.995, -0.211168, 21.849102, -6.166976, 1.262089, 9887.987,
     52025.528, 0.6126207, 0.5306381, 0.2338889},
};
enum { PUBLISHED = sizeof published / sizeof *published };

static struct pp_perez_sky published_sky(int i)
{
    return sky_of(published[i].altitude_deg, published[i].bearing_deg,
                  published[i].direct_w_m2, published[i].diffuse_w_m2);
}

static void perez_coefficients_are_those_of_gendaylit(void **state)
{
    (void)state;
    for (int i = 0; i < PUBLISHED; i++) {
        struct pp_perez_sky sky = published_sky(i);
        assert_near(sky.a, published[i].a, 1e-5);
        assert_near(sky.b, published[i].b, 1e-5);
        assert_near(sky.c, published[i].c, 1e-5);
        assert_near(sky.d, published[i].d, 1e-5);
        assert_near(sky.e, published[i].e, 1e-5);
        assert_relative(sky.diffuse_lx, published[i].diffuse_lx, 1e-4);
        assert_relative(sky.direct_lx, published[i].direct_lx, 1e-4);
    }
}

static void perez_luminances_are_those_of_another_program(void **state)
{
    (void)state;
    struct pp_sky_patches patches;
    assert_true(pp_sky_patches_init(&patches, 145, 0.0));
    for (int i = 0; i < PUBLISHED; i++) {
        struct pp_perez_sky sky = published_sky(i);
        const double expected[3][2] = {{0, published[i].first},
                                       {84, published[i].middle},
                                       {144, published[i].zenith}};
        for (int k = 0; k < 3; k++) {
            struct pp_vec3 u = pp_sky_patches_centre(&patches, (int)expected[k][0]);
            double L = pp_perez_sky_luminance(&sky, u) / sky.diffuse_lx;
            assert_relative(L, expected[k][1], 4e-4);
        }
    }
}

/* The relative sky is integrated by another quadrature, in model/light/sky.c. */
static void every_sky_gives_its_diffuse_illuminance(void **state)
{
    (void)state;
    static const double altitudes[] = {-4.0, 0.3, 2.9, 17.3, 44.1, 71.9, 89.7};
    static const double direct[] = {0.0, 23.0, 310.0, 870.0};
    for (int i = 0; i < 7; i++)
        for (int k = 0; k < 4; k++) {
            struct pp_perez_sky sky = sky_of(altitudes[i], 200.0, direct[k], 60.0);
            struct pp_sky relative = pp_perez_sky_relative(&sky);
            assert_near(pp_sky_on_plane(&relative, pp_vec(0.0, 0.0, 1.0)), 1.0, 1e-5);
            struct pp_vec3 u = toward(31.0, 77.0);
            assert_relative(pp_sky_luminance(&relative, u) * sky.diffuse_lx,
                            pp_perez_sky_luminance(&sky, u), 1e-9);
        }
}

static void a_sky_without_bound_at_the_horizon_is_limited(void **state)
{
    (void)state;
    /* Bin 6, bright, sun at 2 degrees: b of the formula is positive. */
    struct pp_perez_sky sky = sky_of(2.0, 90.0, 60.0, 44.0);
    assert_true(sky.limits & PP_PEREZ_B_POSITIVE || sky.b < 0.0);
    sky = sky_of(1.5, 90.0, 200.0, 40.0);
    for (double h = 0.001; h < 90.0; h *= 2.0) {
        double L = pp_perez_sky_luminance(&sky, toward(h, 270.0));
        assert_true(L >= 0.0 && L < 1e6);
    }
}

/* Two hours of a weather file for Chicago, 1 and 3 January, calculated by an
 * independent program. */
static void a_low_sun_has_its_own_air_mass(void **state)
{
    (void)state;
    static const struct {
        double altitude_deg, direct_w_m2, diffuse_w_m2, dew_point_c;
        double diffuse_lx, direct_lx;
    } hours[] = {{0.784, 22.0, 10.0, -13.3, 1201.2, 437.8},
                 {0.7748, 0.0, 20.0, -5.6, 2105.5, 0.0}};
    for (int i = 0; i < 2; i++) {
        const struct pp_perez_conditions conditions = {
            .direct_w_m2 = hours[i].direct_w_m2,
            .diffuse_w_m2 = hours[i].diffuse_w_m2,
            .sun = toward(hours[i].altitude_deg, 122.5),
            .sun_distance_au = 0.9833,
            .dew_point_c = hours[i].dew_point_c};
        struct pp_perez_sky sky = pp_perez_sky_of(&conditions);
        assert_relative(sky.diffuse_lx, hours[i].diffuse_lx, 1e-3);
        assert_near(sky.direct_lx, hours[i].direct_lx, 2.0);
    }
}

/* gendaylit places a sun above 87 degrees at 87 degrees. */
static void a_sun_near_the_zenith_has_the_sky_of_87_degrees(void **state)
{
    (void)state;
    struct pp_perez_sky high = sky_of(89.0, 0.0, 700.0, 110.0),
                        limit = sky_of(87.0, 0.0, 700.0, 110.0);
    assert_near(high.a, limit.a, 1e-12);
    assert_near(high.c, limit.c, 1e-12);
    assert_near(high.diffuse_lx, limit.diffuse_lx, 1e-6);
}

static void direct_light_alone_leaves_a_black_sky(void **state)
{
    (void)state;
    struct pp_perez_sky sky = sky_of(40.0, 180.0, 700.0, 0.0);
    assert_true(sky.limits & PP_PEREZ_NO_DIFFUSE);
    assert_near(sky.diffuse_lx, 0.0, 0.0);
    assert_near(pp_perez_sky_luminance(&sky, toward(20.0, 10.0)), 0.0, 0.0);
    assert_true(sky.direct_lx > 50000.0 && sky.direct_lx < 90000.0);
    sky = sky_of(40.0, 180.0, 0.0, 0.0);
    assert_near(sky.direct_lx + sky.diffuse_lx, 0.0, 0.0);
}

/* Zenith luminances by an independent quadrature. That of the overcast sky is 9 Ed/(7
 * pi). */
static void standard_skies_have_the_zenith_of_their_illuminance(void **state)
{
    (void)state;
    static const struct {
        double altitude, diffuse_lx, zenith;
    } iso12[] = {{30.0, 12000.0, 1876.73}, {20.0, 9000.0, 1276.25}};
    struct pp_vec3 up = pp_vec(0.0, 0.0, 1.0);
    for (int i = 0; i < 2; i++) {
        struct pp_vec3 sun = toward(iso12[i].altitude, 135.0);
        struct pp_sky standard;
        assert_int_equal(pp_sky_iso(&standard, 12, sun, NULL), PP_OK);
        struct pp_perez_sky sky =
            pp_perez_sky_of_standard(&standard, sun, 55000.0, iso12[i].diffuse_lx);
        assert_relative(pp_perez_sky_luminance(&sky, up), iso12[i].zenith, 1e-5);
        struct pp_sky relative = pp_perez_sky_relative(&sky);
        struct pp_vec3 u = toward(12.0, 100.0);
        assert_relative(pp_sky_luminance(&relative, u), pp_sky_luminance(&standard, u),
                        1e-5);
    }
    struct pp_sky overcast = pp_sky_overcast();
    struct pp_perez_sky sky = pp_perez_sky_of_standard(&overcast, up, 0.0, 20000.0);
    assert_relative(pp_perez_sky_luminance(&sky, up), 9.0 * 20000.0 / (7.0 * PP_PI),
                    1e-6);
    assert_relative(pp_perez_sky_luminance(&sky, toward(30.0, 0.0)),
                    6.0 * 20000.0 / (7.0 * PP_PI), 1e-6);
    struct pp_sky relative = pp_perez_sky_relative(&sky);
    assert_near(pp_sky_on_plane(&relative, up), 1.0, 1e-9);
}

/* Luminances at altitudes of 20, 5 and 90 degrees, at 90, 15 and 0 degrees from the
 * bearing of a sun at 40 degrees, divided by that at 70 and 200 degrees: equation (3)
 * of perez_sky.h, calculated with awk. */
static void the_intermediate_sky_is_brighter_near_the_sun_and_overhead(void **state)
{
    (void)state;
    struct pp_perez_sky sky = sky_of(40.0, 0.0, 300.0, 200.0);
    sky.intermediate = true;
    double base = pp_perez_sky_luminance(&sky, toward(70.0, 200.0));
    assert_relative(pp_perez_sky_luminance(&sky, toward(20.0, 90.0)) / base, 1.52315478,
                    1e-7);
    assert_relative(pp_perez_sky_luminance(&sky, toward(5.0, 15.0)) / base, 2.90022107,
                    1e-7);
    assert_relative(pp_perez_sky_luminance(&sky, toward(90.0, 0.0)) / base, 1.52242023,
                    1e-7);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(standard_skies_have_the_zenith_of_their_illuminance),
        cmocka_unit_test(perez_coefficients_are_those_of_gendaylit),
        cmocka_unit_test(perez_luminances_are_those_of_another_program),
        cmocka_unit_test(every_sky_gives_its_diffuse_illuminance),
        cmocka_unit_test(a_sky_without_bound_at_the_horizon_is_limited),
        cmocka_unit_test(a_low_sun_has_its_own_air_mass),
        cmocka_unit_test(a_sun_near_the_zenith_has_the_sky_of_87_degrees),
        cmocka_unit_test(direct_light_alone_leaves_a_black_sky),
        cmocka_unit_test(the_intermediate_sky_is_brighter_near_the_sun_and_overhead),
    };
    add_tests(tests, NULL, NULL);
}
