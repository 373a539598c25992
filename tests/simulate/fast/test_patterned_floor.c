/* test_patterned_floor.c - a floor whose pattern is two paints, compared with a floor of
 * two faces, one of each paint. */
#include "simulate/path_tracer/path_tracer.h"
#include "tests/lib/room_of.h"
#include "tests/lib/sized.h"
#include "tests/lib/traced.h"

/* Ceiling, walls, window and point. */
#define ABOVE_FLOOR                                                                    \
    "<face role='ceiling' name='c'>"                                                   \
    "<vertex x='0' y='0' z='2.7'/>"                                                    \
    "<vertex x='0' y='4.8' z='2.7'/>"                                                  \
    "<vertex x='3.6' y='4.8' z='2.7'/>"                                                \
    "<vertex x='3.6' y='0' z='2.7'/>"                                                  \
    "</face>"                                                                          \
    "<face role='wall' name='s'>"                                                      \
    "<vertex x='0' y='0' z='0'/>"                                                      \
    "<vertex x='0' y='0' z='2.7'/>"                                                    \
    "<vertex x='3.6' y='0' z='2.7'/>"                                                  \
    "<vertex x='3.6' y='0' z='0'/>"                                                    \
    "</face>"                                                                          \
    "<face role='wall' name='n'>"                                                      \
    "<vertex x='0' y='4.8' z='0'/>"                                                    \
    "<vertex x='3.6' y='4.8' z='0'/>"                                                  \
    "<vertex x='3.6' y='4.8' z='2.7'/>"                                                \
    "<vertex x='0' y='4.8' z='2.7'/>"                                                  \
    "</face>"                                                                          \
    "<face role='wall' name='w'>"                                                      \
    "<vertex x='0' y='0' z='0'/>"                                                      \
    "<vertex x='0' y='2.8' z='0'/>"                                                    \
    "<vertex x='0' y='4.8' z='0'/>"                                                    \
    "<vertex x='0' y='4.8' z='2.7'/>"                                                  \
    "<vertex x='0' y='0' z='2.7'/>"                                                    \
    "</face>"                                                                          \
    "<face role='wall' name='e'>"                                                      \
    "<vertex x='3.6' y='4.8' z='0'/>"                                                  \
    "<vertex x='3.6' y='2.8' z='0'/>"                                                  \
    "<vertex x='3.6' y='0' z='0'/>"                                                    \
    "<vertex x='3.6' y='0' z='2.7'/>"                                                  \
    "<vertex x='3.6' y='4.8' z='2.7'/>"                                                \
    "</face>"                                                                          \
    "</envelope>"                                                                      \
    "<window wall='n' left='0.9' sill='0.9' width='1.8' height='1.5'/>"                \
    "<point x='1.8' y='2.8' z='0.85'/></room>"

#define ONE_FLOOR                                                                      \
    "<face role='floor' name='f'>"                                                     \
    "<vertex x='0' y='0' z='0'/>"                                                      \
    "<vertex x='3.6' y='0' z='0'/>"                                                    \
    "<vertex x='3.6' y='2.8' z='0'/>"                                                  \
    "<vertex x='3.6' y='4.8' z='0'/>"                                                  \
    "<vertex x='0' y='4.8' z='0'/>"                                                    \
    "<vertex x='0' y='2.8' z='0'/>"                                                    \
    "</face>"

/* 2 m of the floor next to the window reflect 0.9, the other 2.8 m reflect 0.1. */
static const char two_faces[] = "<room version='1'><envelope>"
                                "<face role='floor' name='far' reflectance='0.1'>"
                                "<vertex x='0' y='0' z='0'/>"
                                "<vertex x='3.6' y='0' z='0'/>"
                                "<vertex x='3.6' y='2.8' z='0'/>"
                                "<vertex x='0' y='2.8' z='0'/>"
                                "</face>"
                                "<face role='floor' name='near' reflectance='0.9'>"
                                "<vertex x='0' y='2.8' z='0'/>"
                                "<vertex x='3.6' y='2.8' z='0'/>"
                                "<vertex x='3.6' y='4.8' z='0'/>"
                                "<vertex x='0' y='4.8' z='0'/>"
                                "</face>" ABOVE_FLOOR;
static const char patterned[] =
    "<room version='1'><material name='paint' diffuse='0.9' "
    "pattern='1 - 8/9 max(0, 1 - floor(y / 2.8))'/><finishes floor='#paint'/>"
    "<envelope>" ONE_FLOOR ABOVE_FLOOR;
/* (2 x 0.9 + 2.8 x 0.1) / 4.8 */
static const char mean[] =
    "<room version='1'><finishes floor='0.43333333'/><envelope>" ONE_FLOOR ABOVE_FLOOR;

/* The daylight factor at the point, by the fast or the plain tracer. */
static struct pp_reading factor(const char *xml, bool fast, long samples)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    struct pp_reading readings[4];
    if (fast) {
        const struct pp_tracer_options options = pp_test_paths(samples);
        struct pp_reading(*all)[4] =
            pp_test_trace(world, &light, world->receivers, 1, &options, NULL);
        memcpy(readings, all[0], sizeof readings);
        free(all);
    } else {
        struct pp_light_scene *scene = pp_test_matt_scene(world);
        struct pp_environment *environment = pp_test_light_on(scene, &light);
        const struct pp_path_tracer_options options = {.samples = samples, .seed = 1};
        struct pp_path_tracer *tracer = NULL;
        assert_int_equal(pp_path_tracer_create(&tracer, scene, environment,
                                               world->receivers, 1, &options, NULL),
                         PP_OK);
        while (!pp_path_tracer_done(tracer))
            assert_int_equal(pp_path_tracer_advance(tracer, 0.05, NULL), PP_OK);
        pp_path_tracer_read(tracer, 0, readings);
        pp_path_tracer_destroy(tracer);
        pp_environment_destroy(environment);
        pp_light_scene_destroy(scene);
    }
    pp_world_destroy(world);
    return readings[PP_DF];
}

/* The same paths meet the same reflectances. */
static void plain_paths_see_the_two_paints(void **state)
{
    (void)state;
    struct pp_reading of_faces = factor(two_faces, false, 64),
                      of_pattern = factor(patterned, false, 64);
    assert_near(of_pattern.value, of_faces.value, 1e-7);
}

/* The control variate has the mean of the pattern, and the correction the pattern
 * itself. */
static void the_fast_tracer_corrects_the_mean(void **state)
{
    (void)state;
    long samples = PP_SIZED(4096, 1024, 256);
    struct pp_reading of_faces = factor(two_faces, true, samples),
                      of_pattern = factor(patterned, true, samples),
                      of_mean = factor(mean, true, samples);
    double error = hypot(of_faces.std_error, of_pattern.std_error);
    assert_near(of_pattern.value, of_faces.value, 3.0 * error);
    /* Paint next to the window reflects more light than the same paint spread evenly. */
    assert_true(of_pattern.value
                > of_mean.value + 4.0 * hypot(of_mean.std_error, error));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plain_paths_see_the_two_paints),
        cmocka_unit_test(the_fast_tracer_corrects_the_mean),
    };
    add_tests(tests, NULL, NULL);
}
