/* test_photons_gloss.c - light via mirrors, glossy and coloured surfaces, forwards and
 * backwards. */
#include "simulate/transport/sensors.h"
#include "tests/lib/photons_of.h"
#include "tests/lib/room_of.h"

/* Compares photons at the room's points, with all finishes, with sensors of
 * simulate/transport, which follow paths backwards. Returns the share of this light
 * that the matt scene would have. */
static double assert_agree(const char *xml)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    struct pp_light_scene *scene = NULL;
    assert_int_equal(pp_light_scene_of_world(&scene, world, NULL), PP_OK);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_photons_options options = {.error = 0.01, .seed = 4, .threads = 1};
    int count = world->receiver_count;
    struct pp_reading(*found)[4] =
        pp_test_photons_in(scene, &light, world->receivers, count, &options, NULL);
    struct pp_reading(*matt)[4] =
        pp_test_photons(world, &light, world->receivers, count, &options, NULL);
    struct pp_sensor list[8];
    for (int i = 0; i < count; i++)
        list[i] = (struct pp_sensor){world->receivers[i].position,
                                     world->receivers[i].normal, 0};
    const struct pp_sensors_options wanted = {
        .error = 0.005, .seed = 5, .threads = 1, .horizontal = 1.0};
    struct pp_sensors *sensors = NULL;
    assert_int_equal(
        pp_sensors_create(&sensors, scene, environment, list, count, &wanted, NULL),
        PP_OK);
    while (!pp_sensors_done(sensors))
        assert_int_equal(pp_sensors_advance(sensors, 1.0, NULL), PP_OK);
    double share = 0.0;
    for (int i = 0; i < count; i++) {
        struct pp_sensor_reading seen = pp_sensors_read(sensors, i);
        double noise = hypot(seen.grey_error, found[i][PP_DF].std_error);
        assert_near(found[i][PP_DF].value, seen.grey, 4.0 * noise);
        assert_true(noise < 0.03 * seen.grey);
        share += matt[i][PP_DF].value / seen.grey / count;
    }
    pp_sensors_destroy(sensors);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    free(matt);
    free(found);
    pp_world_destroy(world);
    return share;
}

#define BOX "<plan width='3.1' depth='4.3' height='2.6'/>"
#define WINDOW "<window wall='south' left='0.3' sill='0.9' width='2.2' height='1.4'/>"
#define POINTS                                                                         \
    "<point x='0.9' y='0.8'/><point x='1.7' y='3.4'/>"                                 \
    "<point x='1.3' y='2.1' z='2.2' nx='0.1' ny='0.2' nz='-1'/>"

static void a_mirror_opposite_sends_the_window_back(void **state)
{
    (void)state;
    double matt =
        assert_agree("<room version='1'>" BOX WINDOW
                     "<finish wall='north' reflectance='mirror'/>" POINTS "</room>");
    assert_true(fabs(matt - 1.0) > 0.02);
}

static void boards_tiles_and_metal_have_gloss_and_colour(void **state)
{
    (void)state;
    assert_agree("<room version='1'>" BOX
                 "<finishes floor='oak-floor' walls='white-tiles' "
                 "ceiling='gloss-paint'/><finish wall='east' reflectance='brass'/>"
                 "<finish wall='west' reflectance='brushed-aluminium'/>" WINDOW POINTS
                 "</room>");
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mirror_opposite_sends_the_window_back),
        cmocka_unit_test(boards_tiles_and_metal_have_gloss_and_colour),
    };
    add_tests(tests, NULL, NULL);
}
