/* test_tracer_errors.c - standard errors are correct, and results depend only on room,
 * point and seed. */
#include "tests/lib/random_rooms.h"
#include "tests/lib/sized.h"

#define GLAZED_ROOM                                                                    \
    "<room version='1'><plan height='2.6'><vertex x='0' y='0'/>"                       \
    "<vertex x='5' y='0'/><vertex x='5' y='2'/><vertex x='2' y='2'/>"                  \
    "<vertex x='2' y='6'/><vertex x='0' y='6'/></plan>"                                \
    "<window wall='3' left='0.3' sill='0.4' width='2.2' height='1.9' reveal='0.1' "    \
    "frame-factor='0.8'/>"                                                             \
    "<window wall='6' left='0.5' sill='0.4' width='3.1' height='1.9'/>"                \
    "<block x='3' y='3.1' width='1.2' depth='1.7' height='2.2' rotate='20'/>"          \
    "<point x='0.7' y='1.1'/><point x='4.1' y='0.9'/><point x='1.2' y='5.1'/></room>"

static void assert_same_bytes(struct pp_reading (*a)[4], struct pp_reading (*b)[4],
                              int count)
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < PP_COMPONENT_COUNT; k++) {
            assert_memory_equal(&a[i][k].value, &b[i][k].value, sizeof(double));
            assert_memory_equal(&a[i][k].std_error, &b[i][k].std_error, sizeof(double));
        }
}

/* ---- true errors ---- */

/* Frequencies of 400 values: 68 +- 2.3 %, 95 +- 1.1 %; the limits are three times
 * these. For a quarter of the values they are twice as wide. */
static void sky_components_of_many_rooms_lie_within_their_errors(void **state)
{
    (void)state;
    int rooms = PP_SIZED(40, 40, 10), wide = PP_SIZED(1, 1, 2);
    struct pp_coverage c = pp_test_sky_coverage(0, rooms);
    assert_true(c.count > 35 * rooms / 4);
    assert_in_range(100 * c.within_1 / c.count, 69 - 7 * wide, 69 + 7 * wide);
    assert_in_range(100 * c.within_2 / c.count, 95 - 4 * wide, 94 + 4 * wide);
    assert_in_range(c.beyond_4, 0, 1);
}

static void daylight_factors_lie_within_their_errors_over_seeds(void **state)
{
    (void)state;
    int wide = PP_SIZED(0, 0, 5); /* 160 values under sanitizers, for 480 */
    struct pp_coverage c = pp_test_df_coverage(500, PP_SIZED(3, 3, 1), 32);
    assert_in_range(100 * c.within_1 / c.count, 61 - wide, 76 + wide);
    assert_in_range(100 * c.within_2 / c.count, 91 - wide, fmin(98 + wide, 99));
    assert_in_range(c.beyond_4, 0, 2);
}

/* The point is near the west window, which faces the dark side of a clear sky. The
 * window that faces the sun contributes 7 % of the sky component, but the overcast sky
 * suggests half a per cent. With fewer directions one run in ten missed this window,
 * and its standard error did not show it. */
static void a_small_bright_window_is_not_missed(void **state)
{
    (void)state;
    int seeds = PP_SIZED(60, 60, 30), wide = PP_SIZED(0, 0, 7);
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version='1'><sky type='iso-12' sun-altitude='35' sun-bearing='160'/>"
        "<plan width='3.3' depth='7.47' height='2.48'/>"
        "<window wall='west' left='2.85' sill='0.89' width='3.32' height='0.74'/>"
        "<window wall='south' left='0.76' sill='0.95' width='1.74' height='0.67'/>"
        "<point x='0.4' y='3.9'/></room>");
    double truth = pp_test_sky_component(world, &light, &world->receivers[0]);
    struct pp_coverage found = {0, 0, 0, 0};
    for (int seed = 0; seed < seeds; seed++) {
        struct pp_tracer_options options = {.error = 0.03, .seed = (uint64_t)seed};
        struct pp_reading(*traced)[4] =
            pp_test_trace(world, &light, world->receivers, 1, &options, NULL);
        pp_coverage_add(&found, traced[0][PP_SC], truth);
        free(traced);
    }
    assert_in_range(100 * found.within_1 / found.count, 50 - wide, 86 + wide);
    assert_int_equal(found.beyond_4, 0);
    pp_world_destroy(world);
}

/* Plans aim at 92 % of the target, and one value in a few exceeds the target: with 31
 * degrees of freedom an error is accurate to 13 %, and so is that of a pilot. */
static void the_target_error_is_about_reached_everywhere(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_random_room(&light, 77, 10);
    struct pp_tracer_options options = {.error = 0.02, .seed = 4, .average = true};
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, &light, world->receivers, 10, &options, NULL);
    double mean = 0.0;
    for (int i = 0; i <= 10; i++) {
        const struct pp_reading *df = &traced[i][PP_DF];
        double wanted = fmax(0.02 * df->value, 0.00002);
        assert_true(df->value > 0.0);
        assert_true(df->std_error <= 1.6 * wanted);
        mean += df->std_error / wanted / 11.0;
        assert_true(df->std_error > 0.0);
        assert_near(df->value,
                    traced[i][PP_SC].value + traced[i][PP_ERC].value
                        + traced[i][PP_IRC].value,
                    1e-12);
    }
    assert_true(mean < 1.0);
    free(traced);
    pp_world_destroy(world);
}

/* Two slits of 0.1 m in a thick wall. When the pilot was as for large windows, 6 of 12
 * averages had more than twice the target error, at worst 8 times. */
static void the_target_error_is_about_reached_behind_slits(void **state)
{
    (void)state;
    int seeds = PP_SIZED(12, 12, 4);
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='5' depth='5' height='3'/>"
                "<finishes floor='0.3' walls='0.5' ceiling='0.7'/>"
                "<window wall='south' left='1' sill='0.2' width='0.1' height='2.4' "
                "reveal='0.4'/><window wall='south' left='3.5' sill='0.2' width='0.1' "
                "height='2.4' reveal='0.4'/><point x='2' y='1'/></room>");
    int missed = 0;
    for (int seed = 1; seed <= seeds; seed++) {
        struct pp_tracer_options options = {
            .error = 0.005, .seed = (uint64_t)seed, .average = true};
        struct pp_reading(*traced)[4] =
            pp_test_trace(world, &light, world->receivers, 1, &options, NULL);
        const struct pp_reading *df = &traced[1][PP_DF];
        double times = df->std_error / fmax(0.005 * df->value, PP_TRACER_LEAST_ERROR);
        missed += times > 2.0;
        assert_true(times < 4.0);
        free(traced);
    }
    assert_in_range(missed, 0, 1);
    pp_world_destroy(world);
}

/* The mean over a fine grid equals the average over the plane. */
static void the_average_is_that_of_the_whole_plane(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/>"
                "<window wall='south' left='0.3' sill='0.9' width='2.2' height='1.5' "
                "glazing='none'/><grid spacing='0.3' margin='0'/></room>");
    struct pp_tracer_options options = {.error = 0.01, .seed = 3, .average = true};
    int count = world->receiver_count;
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, &light, world->receivers, count, &options, NULL);
    double mean = 0.0;
    for (int i = 0; i < count; i++)
        mean += traced[i][PP_DF].value / count;
    /* Midpoints have an error of one per cent of the mean near the window, where the
     * curve is steep. */
    assert_near(mean, traced[count][PP_DF].value,
                4.0 * traced[count][PP_DF].std_error + 0.01 * mean);
    free(traced);
    pp_world_destroy(world);
}

/* ---- independence of results ---- */

static void threads_change_nothing(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, GLAZED_ROOM);
    struct pp_reading(*traced[3])[4];
    for (int i = 0; i < 3; i++) {
        struct pp_tracer_options options = {
            .error = 0.03, .seed = 9, .threads = 1 << i, .average = true};
        traced[i] = pp_test_trace(world, &light, world->receivers, 3, &options, NULL);
    }
    assert_same_bytes(traced[0], traced[1], 4);
    assert_same_bytes(traced[0], traced[2], 4);
    for (int i = 0; i < 3; i++)
        free(traced[i]);
    pp_world_destroy(world);
}

static void slices_change_nothing(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, GLAZED_ROOM);
    struct pp_tracer_options options = {.error = 0.03, .seed = 9, .average = true};
    struct pp_reading(*whole)[4] =
        pp_test_trace(world, &light, world->receivers, 3, &options, NULL);
    struct pp_reading sliced[4][4];
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_tracer *tracer;
    assert_int_equal(pp_tracer_create(&tracer, scene, environment, world->receivers, 3,
                                      &options, NULL),
                     PP_OK);
    double progress = 0.0;
    while (!pp_tracer_done(tracer)) {
        assert_int_equal(pp_tracer_advance(tracer, 0.0, NULL), PP_OK);
        double now = pp_tracer_progress(tracer);
        assert_true(now >= 0.0 && now <= 1.0);
        progress = now;
    }
    assert_near(progress, 1.0, 0.0);
    for (int i = 0; i < 3; i++)
        pp_tracer_read(tracer, i, sliced[i]);
    pp_tracer_read(tracer, -1, sliced[3]);
    assert_same_bytes(whole, sliced, 4);
    pp_tracer_destroy(tracer);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    free(whole);
    pp_world_destroy(world);
}

/* One of the two runs omits rays whose end is known in advance; nothing else
 * differs. */
static void rays_left_out_change_nothing(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_random_room(&light, 5, 6);
    struct pp_reading(*traced[2])[4];
    struct pp_tracer_work work[2];
    for (int i = 0; i < 2; i++) {
        struct pp_tracer_options options = {
            .samples = 64, .seed = 2, .average = true, .every_ray = i == 1};
        traced[i] =
            pp_test_trace(world, &light, world->receivers, 6, &options, &work[i]);
    }
    assert_true(work[0].rays < work[1].rays);
    assert_same_bytes(traced[0], traced[1], 7);
    free(traced[0]);
    free(traced[1]);
    pp_world_destroy(world);
}

static void a_point_does_not_depend_on_the_others(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, GLAZED_ROOM);
    struct pp_tracer_options options = {.error = 0.05, .seed = 9};
    struct pp_reading(*all)[4] =
        pp_test_trace(world, &light, world->receivers, 3, &options, NULL);
    struct pp_reading(*alone)[4] =
        pp_test_trace(world, &light, &world->receivers[2], 1, &options, NULL);
    assert_same_bytes(&all[2], alone, 1);
    free(all);
    free(alone);
    pp_world_destroy(world);
}

static void another_seed_is_another_sample(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, GLAZED_ROOM);
    struct pp_reading(*traced[2])[4];
    for (int i = 0; i < 2; i++) {
        struct pp_tracer_options options = {.samples = 32, .seed = (uint64_t)i};
        traced[i] = pp_test_trace(world, &light, world->receivers, 3, &options, NULL);
    }
    for (int i = 0; i < 3; i++) {
        struct pp_reading a = traced[0][i][PP_DF], b = traced[1][i][PP_DF];
        assert_true(a.value != b.value);
        assert_near(a.value, b.value, 4.0 * hypot(a.std_error, b.std_error));
    }
    free(traced[0]);
    free(traced[1]);
    pp_world_destroy(world);
}

/* ---- loop of the caller ---- */

static void with_a_time_limit_errors_fall_with_each_batch(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, GLAZED_ROOM);
    struct pp_tracer_options options = {.seed = 9, .threads = 1};
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_tracer *tracer;
    assert_int_equal(pp_tracer_create(&tracer, scene, environment, world->receivers, 3,
                                      &options, NULL),
                     PP_OK);
    struct pp_reading readings[4];
    pp_tracer_read(tracer, 0, readings);
    assert_true(isnan(readings[PP_DF].value));
    assert_non_null(readings[PP_DF].why);
    assert_true(isnan(pp_tracer_error(tracer)));
    do { /* one batch at a time, until the point has a value */
        assert_int_equal(pp_tracer_advance(tracer, 0.0, NULL), PP_OK);
        pp_tracer_read(tracer, 0, readings);
    } while (isnan(readings[PP_DF].value));
    double early = readings[PP_DF].std_error;
    assert_true(early > 0.0);
    for (int i = 0; i < 1000 && readings[PP_DF].std_error > 0.3 * early; i++) {
        assert_int_equal(pp_tracer_advance(tracer, 0.0, NULL), PP_OK);
        pp_tracer_read(tracer, 0, readings);
    }
    assert_true(readings[PP_DF].std_error <= 0.3 * early);
    assert_false(pp_tracer_done(tracer));
    pp_tracer_destroy(tracer);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_tracer_destroy(NULL);
    pp_world_destroy(world);
}

static void options_out_of_range_are_refused(void **state)
{
    (void)state;
    struct pp_world world = {0};
    const struct pp_outside_light light = {.sky = pp_sky_overcast()};
    struct pp_light_scene *scene = pp_test_matt_scene(&world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    const struct pp_tracer_options wrong[] = {
        {.error = -0.1}, {.error = 1.5},        {.error = NAN},
        {.samples = -1}, {.samples = 1L << 40}, {.error = 0.1, .threads = -2}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct pp_tracer *tracer;
        struct pp_error err;
        assert_int_equal(
            pp_tracer_create(&tracer, scene, environment, NULL, 0, &wrong[i], &err),
            PP_BAD_INPUT);
        assert_null(tracer);
        assert_true(err.message[0] != '\0');
    }
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
}

static void nothing_to_trace_is_done_at_once(void **state)
{
    (void)state;
    struct pp_world world = {0};
    const struct pp_outside_light light = {.sky = pp_sky_overcast()};
    struct pp_light_scene *scene = pp_test_matt_scene(&world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_tracer_options options = {.error = 0.1, .average = true};
    struct pp_tracer *tracer;
    struct pp_reading readings[4];
    assert_int_equal(
        pp_tracer_create(&tracer, scene, environment, NULL, 0, &options, NULL), PP_OK);
    assert_int_equal(pp_tracer_advance(tracer, 1.0, NULL), PP_OK);
    assert_true(pp_tracer_done(tracer));
    pp_tracer_read(tracer, -1, readings);
    assert_true(isnan(readings[PP_DF].value));
    pp_tracer_destroy(tracer);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sky_components_of_many_rooms_lie_within_their_errors),
        cmocka_unit_test(daylight_factors_lie_within_their_errors_over_seeds),
        cmocka_unit_test(a_small_bright_window_is_not_missed),
        cmocka_unit_test(the_target_error_is_about_reached_everywhere),
        cmocka_unit_test(the_target_error_is_about_reached_behind_slits),
        cmocka_unit_test(the_average_is_that_of_the_whole_plane),
        cmocka_unit_test(threads_change_nothing),
        cmocka_unit_test(slices_change_nothing),
        cmocka_unit_test(rays_left_out_change_nothing),
        cmocka_unit_test(a_point_does_not_depend_on_the_others),
        cmocka_unit_test(another_seed_is_another_sample),
        cmocka_unit_test(with_a_time_limit_errors_fall_with_each_batch),
        cmocka_unit_test(options_out_of_range_are_refused),
        cmocka_unit_test(nothing_to_trace_is_done_at_once),
    };
    add_tests(tests, NULL, NULL);
}
