/* test_window_chains.c - rooms whose rays pass several windows in a row: light is
 * counted once, by the window at which it is aimed. */
#include "simulate/scene/light_scene_of_world.h"
#include "tests/lib/room_of.h"
#include "tests/lib/sampled_light.h"
#include "tests/lib/sized.h"
#include "tests/lib/traced.h"

/* A room around three sides of a court, with windows to the court from two wings. A
 * third window is in the outer wall behind the second, so that from the west wing it is
 * visible through both. */
static const char court[] =
    "<room version='1'><plan height='2.6'>"
    "<vertex x='0' y='0'/><vertex x='3' y='0'/><vertex x='3' y='4'/>"
    "<vertex x='5' y='4'/><vertex x='5' y='0'/><vertex x='8' y='0'/>"
    "<vertex x='8' y='7'/><vertex x='0' y='7'/></plan>"
    "<finishes floor='0.1' walls='0.1' ceiling='0.1'/>"
    "<window wall='2' left='0.5' sill='0.5' width='3' height='1.8' glazing='none'/>"
    "<window wall='4' left='0.5' sill='0.5' width='3' height='1.8' glazing='none'/>"
    "<window wall='6' left='2' sill='0.5' width='4.5' height='1.8' glazing='none'/>"
    "<point x='1.5' y='2' z='1.2' nx='1' ny='0' nz='0'/></room>";

static void light_through_three_windows_counts_once(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, court);
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    struct pp_environment *outside = pp_test_light_on(scene, &light);
    struct pp_radiance_options sampled = pp_radiance_state_defaults(), found = sampled;
    found.windows = false;
    const struct pp_receiver *at = &world->receivers[0];
    int paths = PP_SIZED(4096, 512, 256);
    struct pp_test_mean a = pp_test_irradiance(scene, outside, NULL, sampled,
                                               at->position, at->normal, paths);
    struct pp_test_mean b = pp_test_irradiance(scene, outside, NULL, found,
                                               at->position, at->normal, paths);
    double off = pp_rgb_luminance(a.value) - pp_rgb_luminance(b.value);
    print_message("# sampled %g +- %g, found %g +- %g\n", pp_rgb_luminance(a.value),
                  a.error, pp_rgb_luminance(b.value), b.error);
    assert_true(fabs(off) < 4.0 * hypot(a.error, b.error));
    assert_true(hypot(a.error, b.error)
                < PP_SIZED(0.01, 0.03, 0.04) * pp_rgb_luminance(b.value));
    pp_environment_destroy(outside);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_through_three_windows_counts_once),
    };
    add_tests(tests, NULL, NULL);
}
