/* test_sky_cube.c - the lamps of a cube around the scene. */
#include "tests/lib/near.h"

#include "model/light/photographs/sky_cube.h"

static const int edges[] = {2, 6, 64};

static void a_direction_to_a_lamp_finds_that_lamp(void **state)
{
    (void)state;
    for (int e = 0; e < 3; e++)
        for (int lamp = 0; lamp < pp_sky_cube_count(edges[e]); lamp++)
            for (int k = 0; k < 4; k++) {
                double a = k % 2 ? 0.999 : 0.001, b = k / 2 ? 0.98 : 0.02;
                struct pp_vec3 u = pp_sky_cube_point(edges[e], lamp, a, b);
                assert_near(pp_vec_length(u), 1.0, 1e-12);
                assert_true(u.z > 0.0);
                assert_int_equal(pp_sky_cube_lamp(edges[e], u, NULL), lamp);
            }
}

/* Each of the six faces of a cube has the solid angle 4 pi / 6, and half a side has
 * 2 pi / 6: top and four half sides together have 2 pi. */
static void the_lamps_have_the_solid_angle_of_the_sky(void **state)
{
    (void)state;
    const int edge = 64, fine = 4;
    double top = 0.0, all = 0.0;
    for (int lamp = 0; lamp < pp_sky_cube_count(edge); lamp++)
        for (int k = 0; k < fine * fine; k++) {
            double per_area;
            struct pp_vec3 u = pp_sky_cube_point(edge, lamp, (k % fine + 0.5) / fine,
                                                 (k / fine + 0.5) / fine);
            pp_sky_cube_lamp(edge, u, &per_area);
            double part = per_area * 4.0 / (edge * edge) / (fine * fine);
            all += part;
            top += lamp < edge * edge ? part : 0.0;
        }
    assert_relative(top, 4.0 * PP_PI / 6.0, 1e-4);
    assert_relative(all, 2.0 * PP_PI, 1e-4);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_direction_to_a_lamp_finds_that_lamp),
        cmocka_unit_test(the_lamps_have_the_solid_angle_of_the_sky),
    };
    add_tests(tests, NULL, NULL);
}
