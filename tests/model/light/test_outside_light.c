/* test_outside_light.c - illuminances of planes that are calculated once for a sky. */
#include "model/light/outside_light.h"

#include "tests/lib/near.h"

static struct pp_sky clear_sky(void)
{
    struct pp_sky sky;
    assert_int_equal(pp_sky_iso(&sky, 12, pp_vec(0.48, -0.64, 0.6), NULL), PP_OK);
    return sky;
}

static void a_known_plane_has_the_illuminance_of_the_integral_to_the_bit(void **state)
{
    (void)state;
    const struct pp_vec3 south = {0.0, -1.0, 0.0}, slope = {0.28, 0.0, 0.96};
    struct pp_outside_planes planes = {0};
    const struct pp_outside_light light = {.sky = clear_sky(), .planes = &planes};
    assert_int_equal(pp_outside_light_add_plane(&planes, &light.sky, south, NULL),
                     PP_OK);
    assert_int_equal(pp_outside_light_add_plane(&planes, &light.sky, slope, NULL),
                     PP_OK);
    assert_true(pp_outside_light_sky_on_plane(&light, south)
                == pp_sky_on_plane(&light.sky, south));
    assert_true(pp_outside_light_sky_on_plane(&light, slope)
                == pp_sky_on_plane(&light.sky, slope));
    pp_outside_light_clear_planes(&planes);
}

static void a_plane_is_listed_once(void **state)
{
    (void)state;
    struct pp_outside_planes planes = {0};
    const struct pp_sky sky = clear_sky();
    for (int i = 0; i < 6; i++)
        assert_int_equal(pp_outside_light_add_plane(
                             &planes, &sky, pp_vec(i % 2 ? 1.0 : -1.0, 0.0, 0.0), NULL),
                         PP_OK);
    assert_int_equal(planes.count, 2);
    pp_outside_light_clear_planes(&planes);
}

/* The sun is in the south-east, so that north has less light than south. */
static void a_plane_that_is_not_listed_is_calculated(void **state)
{
    (void)state;
    const struct pp_vec3 south = {0.0, -1.0, 0.0}, north = {0.0, 1.0, 0.0};
    struct pp_outside_planes planes = {0};
    struct pp_outside_light light = {.sky = clear_sky(), .planes = &planes};
    assert_int_equal(pp_outside_light_add_plane(&planes, &light.sky, south, NULL),
                     PP_OK);
    double of_south = pp_outside_light_sky_on_plane(&light, south);
    double of_north = pp_outside_light_sky_on_plane(&light, north);
    assert_true(of_north < 0.8 * of_south);
    light.planes = NULL;
    assert_true(pp_outside_light_sky_on_plane(&light, north) == of_north);
    pp_outside_light_clear_planes(&planes);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_known_plane_has_the_illuminance_of_the_integral_to_the_bit),
        cmocka_unit_test(a_plane_is_listed_once),
        cmocka_unit_test(a_plane_that_is_not_listed_is_calculated),
    };
    add_tests(tests, NULL, NULL);
}
