/* test_skies.c - outdoor light is an argument: one scene under many skies. */
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/transport/opening_store.h"
#include "tests/lib/counted_builds.h"
#include "tests/lib/room_of.h"
#include "tests/lib/sampled_light.h"
#include "tests/lib/sized.h"
#include "tests/lib/traced.h"

#define ROOM                                                                           \
    "<plan width='3.1' depth='5.3' height='2.6'/>"                                     \
    "<finishes floor='0.3' walls='0.6' ceiling='0.8'/>"                                \
    "<window wall='south' left='0.4' sill='0.7' width='2.2' height='1.5'/>"            \
    "<skyline wall='south' angle='12' distance='17'/>"                                 \
    "<block x='-3' y='-11' width='4' depth='3' height='5'/>"                           \
    "<point x='1.4' y='1.7'/><point x='1.1' y='4.2'/></room>"

/* Every type of ISO 15469, with various bearings and altitudes of the sun. */
static struct pp_outside_light light_of(int number)
{
    struct pp_outside_light light = {.ground_reflectance = 0.1 + 0.003 * number};
    double altitude = (5.0 + 0.83 * number) * PP_RAD, bearing = 0.37 * number;
    struct pp_vec3 sun = pp_vec(cos(altitude) * sin(bearing),
                                cos(altitude) * cos(bearing), sin(altitude));
    assert_int_equal(pp_sky_iso(&light.sky, 1 + number % 15, sun, NULL), PP_OK);
    return light;
}

static void trace(const struct pp_light_scene *scene,
                  const struct pp_environment *environment,
                  struct pp_reading readings[2][4])
{
    const struct pp_tracer_options options = pp_test_paths(16);
    struct pp_tracer *tracer = NULL;
    assert_int_equal(pp_tracer_create(&tracer, scene, environment,
                                      scene->world->receivers, 2, &options, NULL),
                     PP_OK);
    while (!pp_tracer_done(tracer))
        assert_int_equal(pp_tracer_advance(tracer, 1.0, NULL), PP_OK);
    for (int i = 0; i < 2; i++)
        pp_tracer_read(tracer, i, readings[i]);
    pp_tracer_destroy(tracer);
}

/* The readings under every eleventh sky are identical to those of a scene created for
 * this sky alone. */
static void many_skies_are_traced_on_one_scene(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world("<room version='1'>" ROOM);
    builds = 0;
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    assert_int_equal(builds, 1);
    int scenes = 1;
    for (int i = 0; i < PP_SIZED(100, 23, 12); i++) {
        struct pp_outside_light light = light_of(i);
        struct pp_environment *environment = NULL;
        struct pp_reading readings[2][4], alone[2][4];
        assert_int_equal(pp_light_scene_under(&environment, scene, &light, NULL),
                         PP_OK);
        int before = builds;
        trace(scene, environment, readings);
        assert_int_equal(builds, before);
        pp_environment_destroy(environment);
        if (i % 11 != 0)
            continue;
        struct pp_light_scene *own = pp_test_matt_scene(world);
        assert_int_equal(pp_light_scene_under(&environment, own, &light, NULL), PP_OK);
        scenes++;
        trace(own, environment, alone);
        for (int k = 0; k < 2; k++)
            for (int c = 0; c < 4; c++) {
                assert_true(readings[k][c].value == alone[k][c].value);
                assert_true(readings[k][c].std_error == alone[k][c].std_error);
            }
        pp_environment_destroy(environment);
        pp_light_scene_destroy(own);
    }
    assert_int_equal(builds, scenes);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* Coloured light with the store of the window, under a sky that is passed separately:
 * as bright as with the sky in the file. */
static void coloured_light_is_traced_under_another_sky(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world("<room version='1'>" ROOM);
    struct pp_outside_light light;
    struct pp_world *clear = pp_test_lit_world(
        &light, "<room version='1'><site ground-reflectance='0.31'/>"
                "<sky type='iso-12' sun-altitude='41' sun-bearing='170'/>" ROOM);
    struct pp_light_scene *scenes[2] = {NULL, NULL};
    struct pp_test_mean means[2];
    builds = 0;
    for (int i = 0; i < 2; i++) {
        struct pp_environment *environment = NULL;
        struct pp_opening_store *store = NULL;
        assert_int_equal(pp_light_scene_of_world(&scenes[i], i ? clear : world, NULL),
                         PP_OK);
        assert_int_equal(pp_light_scene_under(&environment, scenes[i], &light, NULL),
                         PP_OK);
        assert_int_equal(
            pp_opening_store_create(&store, scenes[i], environment, 1, 1, NULL), PP_OK);
        means[i] = pp_test_irradiance(
            scenes[i], environment, store, pp_radiance_state_defaults(),
            world->receivers[0].position, world->receivers[0].normal, 64);
        pp_opening_store_destroy(store);
        pp_environment_destroy(environment);
    }
    assert_int_equal(builds, 2);
    assert_true(means[0].value.g > 0.0 && means[0].value.g == means[1].value.g);
    for (int i = 0; i < 2; i++)
        pp_light_scene_destroy(scenes[i]);
    pp_world_destroy(clear);
    pp_world_destroy(world);
}

static uint64_t scene_hash(const char *xml, uint64_t *of_light)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    struct pp_light_scene *scene;
    assert_int_equal(pp_light_scene_of_world(&scene, world, NULL), PP_OK);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    uint64_t hash = pp_light_scene_hash(scene);
    *of_light = pp_environment_hash(environment);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
    return hash;
}

static void scene_and_light_have_a_number_each(void **state)
{
    (void)state;
    uint64_t light, other;
    uint64_t scene = scene_hash("<room version='1'>" ROOM, &light);
    const char *const lights[] = {
        "<room version='1'><sky type='uniform'/>" ROOM,
        "<room version='1'><sky type='iso-1'/>" ROOM,
        "<room version='1'><site ground-reflectance='0.21'/>" ROOM};
    for (int i = 0; i < 3; i++) {
        assert_true(scene_hash(lights[i], &other) == scene);
        assert_false(other == light);
    }
    const char *const rooms[] = {
        "<room version='1'><skyline wall='north' angle='20'/>" ROOM,
        "<room version='1'><block x='-4' y='-34' width='10' depth='6' "
        "height='8'/>" ROOM};
    for (int i = 0; i < 2; i++) {
        assert_false(scene_hash(rooms[i], &other) == scene);
        assert_true(other == light);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(many_skies_are_traced_on_one_scene),
        cmocka_unit_test(coloured_light_is_traced_under_another_sky),
        cmocka_unit_test(scene_and_light_have_a_number_each),
    };
    add_tests(tests, NULL, NULL);
}
