/* test_scattering_pane.c - rooms with a measured pane, by both path tracers. */
#include "model/light/bsdf/measured_pane.h"
#include "simulate/path_tracer/path_tracer.h"
#include "tests/lib/made_bsdf.h"
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"

/* Room 4 x 6 x 3 m, its window filled with a measured pane. */
#define ROOM(wall)                                                                     \
    "<room version='1'><site ground-reflectance='0.2' ground='open'/>"                 \
    "<plan width='4' depth='6' height='3'/>"                                           \
    "<finishes floor='0.2' walls='0.5' ceiling='0.7'/>"                                \
    "<window wall='" wall "' left='0.5' sill='0.9' width='3' height='1.8'/></room>"

enum { POINTS = 3 };
static const double places[POINTS][2] = {{2, 2}, {0.8, 2}, {3.2, 2}};

static struct pp_measured_pane *pane_of(const char *basis, made_bsdf_law *law,
                                        bool split)
{
    struct made_bsdf file = made_bsdf_front(basis, law);
    struct pp_bsdf bsdf;
    struct pp_measured_pane *pane = NULL;
    struct pp_error err = {PP_OK, ""};
    if (pp_bsdf_file_parse(&bsdf, file.text, file.length, "made.xml", &err) != PP_OK
        || pp_measured_pane_create(&pane, &bsdf, split, &err) != PP_OK)
        fail_msg("%s", err.message);
    pp_bsdf_clear(&bsdf);
    free(file.text);
    return pane;
}

/* World of the room; it takes ownership of the pane. */
static struct pp_world *room_with(const char *xml, struct pp_measured_pane *pane)
{
    struct pp_world *world = pp_test_world(xml);
    world->openings[0].measured = pane;
    world->openings[0].scatter = &pane->scatter;
    return world;
}

static void read_plain(const struct pp_world *world,
                       const struct pp_outside_light *light,
                       const struct pp_receiver *receivers,
                       struct pp_reading (*readings)[4])
{
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    struct pp_environment *environment = pp_test_light_on(scene, light);
    const struct pp_path_tracer_options options = {.samples = 512, .seed = 1};
    struct pp_path_tracer *tracer = NULL;
    assert_int_equal(pp_path_tracer_create(&tracer, scene, environment, receivers,
                                           POINTS, &options, NULL),
                     PP_OK);
    while (!pp_path_tracer_done(tracer))
        assert_int_equal(pp_path_tracer_advance(tracer, 0.1, NULL), PP_OK);
    for (int i = 0; i < POINTS; i++)
        pp_path_tracer_read(tracer, i, readings[i]);
    pp_path_tracer_destroy(tracer);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
}

/* Asserts daylight factors at the points, facing up at 0.8 m, within 3 standard errors
 * and 0.5 % of `expected`. turned: true if the window is in the opposite wall. */
static void assert_room(const struct pp_world *world, bool turned,
                        const double expected[POINTS])
{
    struct pp_outside_light light = pp_test_light(ROOM("south"));
    struct pp_receiver receivers[POINTS];
    struct pp_reading plain[POINTS][4];
    const struct pp_tracer_options options = {.error = 0.005, .seed = 1};
    for (int i = 0; i < POINTS; i++) {
        double x = places[i][0], y = places[i][1];
        receivers[i] = pp_test_receiver(turned ? 4 - x : x, turned ? 6 - y : y, 0.8,
                                        0.0, 0.0, 1.0);
    }
    read_plain(world, &light, receivers, plain);
    struct pp_reading(*fast)[4] =
        pp_test_trace(world, &light, receivers, POINTS, &options, NULL);
    for (int i = 0; i < POINTS; i++) {
        const struct pp_reading *of[2] = {&plain[i][PP_DF], &fast[i][PP_DF]};
        for (int k = 0; k < 2; k++) {
            assert_true(of[k]->std_error < 0.02 * expected[i]);
            assert_near(of[k]->value, expected[i],
                        3.0 * of[k]->std_error + 0.005 * expected[i]);
        }
    }
    free(fast);
}

/* Illuminances by an independent path tracer divided by 10,000 lx of an overcast sky;
 * standard errors below 0.1 %. Its data are those of made_bsdf_prism and
 * made_bsdf_lambertian. */
static void rooms_agree_with_an_independent_tracer(void **state)
{
    (void)state;
    static const struct {
        const char *basis;
        made_bsdf_law *law;
        bool split;
        double expected[POINTS];
    } of[] = {{"LBNL/Klems Half",
               made_bsdf_lambertian,
               true,
               {0.0317307, 0.0276392, 0.0276468}},
              {"LBNL/Klems Quarter",
               made_bsdf_prism,
               false,
               {0.0543145, 0.0484674, 0.0452400}},
              {"LBNL/Klems Quarter",
               made_bsdf_prism,
               true,
               {0.0544858, 0.0486937, 0.0454103}}};
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        struct pp_world *world =
            room_with(ROOM("south"), pane_of(of[i].basis, of[i].law, of[i].split));
        assert_room(world, false, of[i].expected);
        pp_world_destroy(world);
    }
}

/* The overcast sky is the same in all directions, so the results must not change if the
 * wall, and with it the axes of the pane, is turned. */
static void the_pane_turns_with_its_wall(void **state)
{
    (void)state;
    static const double expected[POINTS] = {0.0543145, 0.0484674, 0.0452400};
    struct pp_world *world =
        room_with(ROOM("north"), pane_of("LBNL/Klems Quarter", made_bsdf_prism, false));
    assert_room(world, true, expected);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rooms_agree_with_an_independent_tracer),
        cmocka_unit_test(the_pane_turns_with_its_wall),
    };
    add_tests(tests, NULL, NULL);
}
