/* test_crown_light.c - light through the crown of a tree. */
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"

/* A black room, open to the sky: 10 x 10 m, 0.5 m high. The point is 8 m below the
 * middle of the crown's base. */
#define ROOM                                                                           \
    "<room version='1'><site ground='open' ground-reflectance='0'>%s</site>"           \
    "<sky type='uniform'/><plan width='10' depth='10' height='0.5'/>"                  \
    "<finishes floor='0' walls='0' ceiling='0'/><working-plane height='0.1'/>"         \
    "<rooflight x='0' y='0' width='10' depth='10' glazing='none'/>"                    \
    "<point x='5' y='5' z='0.1'/></room>"

static struct pp_reading sky_component(const char *trees)
{
    const struct pp_tracer_options options = {.samples = 1024, .seed = 5, .threads = 1};
    struct pp_outside_light light;
    char xml[1500];
    snprintf(xml, sizeof xml, ROOM, trees);
    struct pp_world *world = pp_test_lit_world(&light, xml);
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, &light, world->receivers, 1, &options, NULL);
    struct pp_reading sky = traced[0][PP_SC];
    free(traced);
    pp_world_destroy(world);
    return sky;
}

#define TREE(more)                                                                     \
    "<tree x='5' y='5' height='15' crown-base='8.1' crown-width='20' " more "/>"

/* Configuration factor of a polygon of twelve sides around the zenith, h = 8 m up, with
 * the area of a circle of radius 10 m: apothem a, side s. Lambert:
 *
 *     F = 12/(2 pi) 2 atan(s / (2 sqrt(a2 + h2))) a / sqrt(a2 + h2) = 0.6097
 */
static double crown_factor(void)
{
    double radius = 10.0 * sqrt(PP_PI / 3.0);
    double a = radius * cos(PP_PI / 12.0), half = radius * sin(PP_PI / 12.0);
    double slant = hypot(a, 8.0);
    return 12.0 / PP_PI * atan(half / slant) * a / slant;
}

static void a_crown_dims_the_sky_behind_it(void **state)
{
    (void)state;
    assert_near(crown_factor(), 0.6097, 1e-4);
    struct pp_reading open = sky_component("");
    struct pp_reading crown = sky_component(TREE("transmittance='0.3'"));
    assert_near(crown.value, open.value - 0.7 * crown_factor(),
                3.0 * hypot(open.std_error, crown.std_error) + 1e-4);
}

/* The second crown hangs over the first, and covers it. */
static void each_crown_dims_the_light_once(void **state)
{
    (void)state;
    struct pp_reading open = sky_component("");
    struct pp_reading both =
        sky_component(TREE("transmittance='0.5'") "<tree x='5' y='5' height='40' "
                                                  "crown-base='20' crown-width='50' "
                                                  "transmittance='0.4'/>");
    struct pp_reading upper =
        sky_component("<tree x='5' y='5' height='40' crown-base='20' crown-width='50' "
                      "transmittance='0.4'/>");
    assert_near(both.value, upper.value - 0.4 * 0.5 * crown_factor(),
                3.0 * hypot(both.std_error, upper.std_error) + 1e-4);
    assert_true(upper.value < open.value);
}

static void a_crown_of_full_transmittance_changes_nothing(void **state)
{
    (void)state;
    struct pp_reading open = sky_component("");
    struct pp_reading clear = sky_component(TREE("transmittance='1'"));
    assert_near(clear.value, open.value,
                3.0 * hypot(open.std_error, clear.std_error) + 1e-6);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_crown_dims_the_sky_behind_it),
        cmocka_unit_test(each_crown_dims_the_light_once),
        cmocka_unit_test(a_crown_of_full_transmittance_changes_nothing),
    };
    add_tests(tests, NULL, NULL);
}
