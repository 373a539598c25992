/* test_direct_light.c - direct light calculated alone equals the direct light in the
 * full simulation. */
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"

static const char street[] =
    "<room version='1'><site ground-reflectance='0.3'/>"
    "<plan width='3.4' depth='6.2' height='2.8'/>"
    "<window wall='south' left='0.6' sill='0.8' width='2.1' height='1.6'/>"
    "<block x='-9' y='-14' width='21' depth='5' height='8' reflectance='0.4'/>"
    "<point x='1.2' y='1.1'/><point x='2.3' y='5.7'/></room>";

/* With this number of paths and the same seed, both use the same paths. */
static void components_are_those_of_the_whole(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, street);
    struct pp_tracer_options options = pp_test_paths(64);
    options.average = true;
    struct pp_reading(*whole)[4] =
        pp_test_trace(world, &light, world->receivers, 2, &options, NULL);
    options.direct = true;
    struct pp_reading(*direct)[4] =
        pp_test_trace(world, &light, world->receivers, 2, &options, NULL);
    for (int point = 0; point < 3; point++) {
        for (int i = PP_SC; i <= PP_ERC; i++) {
            assert_near(direct[point][i].value, whole[point][i].value, 0.0);
            assert_near(direct[point][i].std_error, whole[point][i].std_error, 0.0);
        }
        assert_true(isnan(direct[point][PP_IRC].value) && direct[point][PP_IRC].why);
        assert_true(isnan(direct[point][PP_DF].value) && direct[point][PP_DF].why);
    }
    assert_true(whole[0][PP_SC].value > 0.0 && whole[1][PP_ERC].value > 0.0);
    free(whole);
    free(direct);
    pp_world_destroy(world);
}

/* The target error applies to the sum of sky component and externally reflected
 * component. Both use the same paths, so their errors need not add as squares. */
static void the_error_is_over_the_sum(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, street);
    struct pp_tracer_options options = {.error = 0.01, .seed = 3, .direct = true};
    struct pp_tracer_work work, more;
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, &light, world->receivers, 2, &options, &work);
    for (int point = 0; point < 2; point++) {
        const struct pp_reading *r = traced[point];
        double sum = r[PP_SC].value + r[PP_ERC].value;
        assert_true(fabs(r[PP_SC].std_error - r[PP_ERC].std_error) < 0.011 * sum);
        assert_true(r[PP_SC].std_error + r[PP_ERC].std_error > 1e-4 * sum);
    }
    free(traced);
    options.direct = false;
    free(pp_test_trace(world, &light, world->receivers, 2, &options, &more));
    assert_true(3 * work.rays < more.rays);
    pp_world_destroy(world);
}

/* A room without windows. */
static void where_none_comes_there_is_none(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/>"
                "<point x='1.2' y='2.3'/></room>");
    struct pp_tracer_options options = {.error = 0.01, .seed = 1, .direct = true};
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, &light, world->receivers, 1, &options, NULL);
    for (int i = PP_SC; i <= PP_ERC; i++) {
        assert_near(traced[0][i].value, 0.0, 0.0);
        assert_near(traced[0][i].std_error, 0.0, 0.0);
    }
    free(traced);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(components_are_those_of_the_whole),
        cmocka_unit_test(the_error_is_over_the_sum),
        cmocka_unit_test(where_none_comes_there_is_none),
    };
    add_tests(tests, NULL, NULL);
}
