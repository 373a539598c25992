/* test_path_tracer.c - the plain path tracer compared with known values, and the fast
 * tracer compared with the plain one. */
#include "simulate/path_tracer/path_tracer.h"

#include "methods/exact/solid_angle.h"
#include "tests/lib/equilibrium.h"
#include "tests/lib/light_on.h"
#include "tests/lib/random_rooms.h"
#include "tests/lib/sized.h"

/* Readings of `count` receivers, followed by the average if requested. The caller frees
 * them. */
static struct pp_reading (
    *plain_readings(const struct pp_world *world, const struct pp_outside_light *light,
                    const struct pp_receiver *receivers, int count,
                    const struct pp_path_tracer_options *options))[4]
{
    struct pp_light_scene *scene = NULL;
    struct pp_path_tracer *tracer = NULL;
    struct pp_reading(*readings)[4] = calloc((size_t)count + 1, sizeof *readings);
    assert_non_null(readings);
    assert_int_equal(pp_light_scene_of_world_matt(&scene, world, NULL), PP_OK);
    struct pp_environment *environment = pp_test_light_on(scene, light);
    assert_int_equal(pp_path_tracer_create(&tracer, scene, environment, receivers,
                                           count, options, NULL),
                     PP_OK);
    while (!pp_path_tracer_done(tracer))
        assert_int_equal(pp_path_tracer_advance(tracer, 0.05, NULL), PP_OK);
    for (int i = 0; i <= count; i++)
        pp_path_tracer_read(tracer, i < count ? i : -1, readings[i]);
    pp_path_tracer_destroy(tracer);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    return readings;
}

static void plain_one(const struct pp_world *world,
                      const struct pp_outside_light *light, struct pp_receiver receiver,
                      long samples, struct pp_reading readings[4])
{
    const struct pp_path_tracer_options options = {.samples = samples, .seed = 1};
    struct pp_reading(*all)[4] = plain_readings(world, light, &receiver, 1, &options);
    memcpy(readings, all[0], sizeof all[0]);
    free(all);
}

/* ---- limits ---- */

static void a_closed_room_is_dark(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/></room>");
    struct pp_reading readings[4];
    plain_one(world, &light, pp_test_receiver(1.2, 2.3, 0.8, 0.0, 0.0, 1.0), 64,
              readings);
    for (int i = 0; i < PP_COMPONENT_COUNT; i++) {
        assert_near(readings[i].value, 0.0, 0.0);
        assert_near(readings[i].std_error, 0.0, 0.0);
    }
    pp_world_destroy(world);
}

/* A vertical plane under the overcast sky receives 39.62 % of the horizontal
 * illuminance from the sky, and half of 0.3 from the ground. */
static void a_vertical_plane_outside_sees_half_of_sky_and_ground(void **state)
{
    (void)state;
    const struct pp_world world = {0};
    struct pp_outside_light light = {.sky = pp_sky_overcast(),
                                     .ground_reflectance = 0.3};
    struct pp_reading readings[4];
    plain_one(&world, &light, pp_test_receiver(1.0, 2.0, 3.0, 0.0, 0.0, 1.0), 1024,
              readings);
    assert_traced(readings[PP_SC], 1.0, 1e-3);
    plain_one(&world, &light, pp_test_receiver(1.0, 2.0, 3.0, 0.3, -0.4, 0.0), 1024,
              readings);
    assert_traced(readings[PP_SC], 0.396177, 2e-3);
    assert_traced(readings[PP_ERC], 0.15, 2e-3);
}

/* Each surface emits 1 and reflects rho of the light it receives: 1 + rho + rho^2 +
 * ... */
static void a_furnace_glows_with_one_over_one_less_rho(void **state)
{
    (void)state;
    const double reflectances[] = {0.0, 0.2, 0.5, 0.8, 0.9};
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/></room>");
    for (size_t i = 0; i < sizeof reflectances / sizeof *reflectances; i++) {
        for (int k = 0; k < world->surface_count; k++) {
            world->surfaces[k].exitance = 1.0;
            world->surfaces[k].front = reflectances[i];
        }
        struct pp_reading readings[4];
        double expected = 1.0 / (1.0 - reflectances[i]);
        plain_one(world, &light, pp_test_receiver(1.2, 2.3, 0.7, 0.2, 0.3, 1.0), 1024,
                  readings);
        assert_traced(readings[PP_IRC], expected, 0.01 * expected);
    }
    pp_world_destroy(world);
}

/* ---- thermal equilibrium ---- */

/* Every receiver of a room in equilibrium (equilibrium.h) has the value 1. */
static void assert_equilibrium(const char *xml, bool lossless_glass)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_equilibrium(&light, xml, lossless_glass);
    int count = world->receiver_count;
    const struct pp_path_tracer_options options = {
        .samples = 512, .seed = 1, .average = true};
    struct pp_reading(*all)[4] =
        plain_readings(world, &light, world->receivers, count, &options);
    for (int i = 0; i <= count; i++)
        assert_traced(all[i][PP_DF], 1.0, 0.02);
    free(all);
    pp_world_destroy(world);
}

static void equilibrium_with_glass_on_two_sides_and_above(void **state)
{
    (void)state;
    assert_equilibrium(PP_TEST_GLAZED_ROOM, true);
}

static void equilibrium_with_deep_reveals(void **state)
{
    (void)state;
    assert_equilibrium(PP_TEST_REVEALED_ROOM, true);
}

static void equilibrium_in_an_l_shaped_room_with_blocks_outside(void **state)
{
    (void)state;
    assert_equilibrium(PP_TEST_L_SHAPED_ROOM, true);
}

static void equilibrium_behind_a_diffusing_pane(void **state)
{
    (void)state;
    assert_equilibrium(PP_TEST_DIFFUSING_ROOM, false);
}

/* ---- sky component ---- */

/* By quadrature over each window, independent of the program's own calculations. */
static void sky_components_are_those_of_a_quadrature(void **state)
{
    (void)state;
    int rooms = PP_SIZED(100, 20, 5), within_2 = 0, beyond_4 = 0, count = 0;
    for (int number = 0; number < rooms; number++) {
        struct pp_outside_light light;
        struct pp_world *world = pp_test_random_room(&light, (uint64_t)number, 5);
        const struct pp_path_tracer_options options = {.samples = 64,
                                                       .seed = (uint64_t)number};
        struct pp_reading(*all)[4] =
            plain_readings(world, &light, world->receivers, 5, &options);
        for (int i = 0; i < 5; i++) {
            double truth = pp_test_sky_component(world, &light, &world->receivers[i]);
            const struct pp_reading *SC = &all[i][PP_SC];
            if (!(SC->std_error > 0.0))
                continue;
            double z = fabs(SC->value - truth) / SC->std_error;
            count++;
            within_2 += z < 2.0;
            beyond_4 += z > 4.0;
        }
        free(all);
        pp_world_destroy(world);
    }
    assert_true(count > 4 * rooms);
    assert_in_range(100 * within_2 / count, 88, 100);
    assert_in_range(beyond_4, 0, 1);
}

/* ---- the fast tracer ---- */

/* z is the difference of the two daylight factors divided by its standard error. For
 * independent values the mean of z is 0 and its variance 1. Each room contributes one
 * value. */
static void the_tracer_gives_the_same_daylight_factors(void **state)
{
    (void)state;
    int rooms = PP_SIZED(1000, 60, 10);
    double sum = 0.0, squares = 0.0;
    for (int number = 0; number < rooms; number++) {
        struct pp_outside_light light;
        struct pp_world *world =
            pp_test_random_room(&light, 7000 + (uint64_t)number, 1);
        const struct pp_path_tracer_options plain = {.samples = 256, .seed = 5};
        const struct pp_tracer_options fast = {
            .error = 0.01, .seed = 6 + (uint64_t)number, .alone = number % 2};
        struct pp_reading(*a)[4] =
            plain_readings(world, &light, world->receivers, 1, &plain);
        struct pp_reading(*b)[4] =
            pp_test_trace(world, &light, world->receivers, 1, &fast, NULL);
        double z = (a[0][PP_DF].value - b[0][PP_DF].value)
                   / hypot(a[0][PP_DF].std_error, b[0][PP_DF].std_error);
        assert_true(fabs(z) < 4.5);
        sum += z;
        squares += z * z;
        free(a);
        free(b);
        pp_world_destroy(world);
    }
    double mean = sum / rooms, variance = squares / rooms - mean * mean;
    assert_near(mean, 0.0, 3.1 / sqrt(rooms));
    assert_near(variance, 1.03, 0.04 + 3.1 * sqrt(2.0 / rooms));
}

static void the_answer_does_not_depend_on_threads(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_random_room(&light, 3, 4);
    struct pp_path_tracer_options options = {
        .error = 0.05, .seed = 2, .threads = 1, .average = true};
    struct pp_reading(*one)[4] =
        plain_readings(world, &light, world->receivers, 4, &options);
    options.threads = 3;
    struct pp_reading(*three)[4] =
        plain_readings(world, &light, world->receivers, 4, &options);
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < PP_COMPONENT_COUNT; k++)
            assert_memory_equal(&one[i][k].value, &three[i][k].value, sizeof(double));
    free(one);
    free(three);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_closed_room_is_dark),
        cmocka_unit_test(a_vertical_plane_outside_sees_half_of_sky_and_ground),
        cmocka_unit_test(a_furnace_glows_with_one_over_one_less_rho),
        cmocka_unit_test(equilibrium_with_glass_on_two_sides_and_above),
        cmocka_unit_test(equilibrium_with_deep_reveals),
        cmocka_unit_test(equilibrium_in_an_l_shaped_room_with_blocks_outside),
        cmocka_unit_test(equilibrium_behind_a_diffusing_pane),
        cmocka_unit_test(sky_components_are_those_of_a_quadrature),
        cmocka_unit_test(the_tracer_gives_the_same_daylight_factors),
        cmocka_unit_test(the_answer_does_not_depend_on_threads),
    };
    add_tests(tests, NULL, NULL);
}
