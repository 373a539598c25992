/* test_standard_sky.c - the standard skies used in mixtures for the year. */
#include "tests/lib/near.h"

#include "model/light/sky.h"
#include "studies/year/hand/standard_sky.h"

static struct pp_vec3 toward(double altitude_deg, double bearing_deg)
{
    double h = altitude_deg * PP_RAD, az = bearing_deg * PP_RAD;
    return pp_vec(cos(h) * sin(az), cos(h) * cos(az), sin(h));
}

static const struct pp_vec3 up = {0.0, 0.0, 1.0};

/* Moon and Spencer: E_h = 7/9 pi Lz, and the horizon has a third of the zenith's
 * luminance. */
static void overcast_sky_has_seven_ninths_of_pi_zenith(void **state)
{
    (void)state;
    struct pp_perez_sky sky = pp_standard_sky_of(PP_STANDARD_OVERCAST, up);
    assert_near(pp_standard_sky_per_zenith(&sky), 7.0 * PP_PI / 9.0, 1e-5);
    assert_near(pp_perez_sky_luminance(&sky, toward(1e-7, 40.0)),
                pp_perez_sky_luminance(&sky, up) / 3.0, 1e-6);
}

/* Compared with the general form of skies. */
static void clear_turbid_and_type_1_are_those_of_iso_15469(void **state)
{
    (void)state;
    static const struct {
        enum pp_standard_sky kind;
        int type;
    } pairs[] = {
        {PP_STANDARD_CLEAR, 12}, {PP_STANDARD_TURBID, 13}, {PP_STANDARD_ISO_1, 1}};
    struct pp_vec3 sun = toward(37.0, 142.0);
    for (int i = 0; i < 3; i++) {
        struct pp_sky iso;
        struct pp_perez_sky sky = pp_standard_sky_of(pairs[i].kind, sun);
        assert_int_equal(pp_sky_iso(&iso, pairs[i].type, sun, NULL), PP_OK);
        for (int k = 0; k < 8; k++) {
            struct pp_vec3 u = toward(6.0 + 11.0 * k, 47.0 * k);
            assert_near(pp_perez_sky_luminance(&sky, u) / pp_sky_luminance(&iso, u),
                        1.0, 1e-3);
        }
    }
}

/* EnergyPlus divides (3) of perez_sky.h by its value at the zenith, with its own rounded
 * constants: Z3 = 0.99224 sin(2.6 h + 0.316) + 2.73852, Z4 = exp(-0.563 (pi/2 - h)
 * (2.6298 (h - 0.008) + 0.812)). */
static void intermediate_sky_has_its_published_zenith(void **state)
{
    (void)state;
    double h = 41.0 * PP_RAD;
    struct pp_vec3 sun = toward(41.0, 200.0), u = toward(28.0, 153.0);
    struct pp_perez_sky sky = pp_standard_sky_of(PP_STANDARD_INTERMEDIATE, sun);
    double phi = 28.0 * PP_RAD, gamma = acos(pp_vec_dot(u, sun));
    double top =
        ((1.35 * (sin(3.59 * phi - 0.009) + 2.31) * sin(2.6 * h + 0.316) + phi + 4.799)
         / 2.326)
        * exp(-0.563 * gamma * ((h - 0.008) * (phi + 1.059) + 0.812));
    double zenith = (0.99224 * sin(2.6 * h + 0.316) + 2.73852)
                    * exp(-0.563 * (0.5 * PP_PI - h) * (2.6298 * (h - 0.008) + 0.812));
    assert_near(pp_perez_sky_luminance(&sky, u) / pp_perez_sky_luminance(&sky, up),
                top / zenith, 3e-3);
}

static void every_standard_sky_gives_one_lux(void **state)
{
    (void)state;
    enum { RINGS = 300, SECTORS = 180 };
    for (int kind = 0; kind < PP_STANDARD_COUNT; kind++) {
        struct pp_perez_sky sky =
            pp_standard_sky_of((enum pp_standard_sky)kind, toward(33.0, 210.0));
        double E = 0.0;
        for (int i = 0; i < RINGS; i++) {
            double z = sqrt((i + 0.5) / RINGS), h = asin(z) / PP_RAD;
            for (int k = 0; k < SECTORS; k++)
                E +=
                    pp_perez_sky_luminance(&sky, toward(h, (k + 0.5) * 360.0 / SECTORS))
                    * PP_PI / (RINGS * SECTORS);
        }
        assert_near(E, 1.0, 2e-3);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(overcast_sky_has_seven_ninths_of_pi_zenith),
        cmocka_unit_test(clear_turbid_and_type_1_are_those_of_iso_15469),
        cmocka_unit_test(intermediate_sky_has_its_published_zenith),
        cmocka_unit_test(every_standard_sky_gives_one_lux),
    };
    add_tests(tests, NULL, NULL);
}
