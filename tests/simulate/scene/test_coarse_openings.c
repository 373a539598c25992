/* test_coarse_openings.c - directions to the openings of a coarse model: configuration
 * factors in closed form, and nested rooms in thermal equilibrium. */
#include "simulate/scene/coarse_openings.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "simulate/sampling/lobe.h"
#include "simulate/sampling/sobol.h"
#include "simulate/scene/light_scene_parts.h"
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"

/* Two rooflights in a ceiling at 5 m, the second one four times larger. */
static struct pp_target rooflight(double x, double y, double width, double depth)
{
    return (struct pp_target){.normal = {0.0, 0.0, -1.0},
                              .middle = {x + width / 2.0, y + depth / 2.0, 5.0},
                              .area_m2 = width * depth,
                              .rectangle = true,
                              .corner = {x, y, 5.0},
                              .along = {1.0, 0.0, 0.0},
                              .up = {0.0, 1.0, 0.0},
                              .width_m = width,
                              .height_m = depth};
}

/* Configuration factor from a horizontal point at the foot of a corner to a rectangle
 * a x b at the distance c above, from integrating cos cos / (pi r^2). */
static double corner_factor(double a, double b, double c)
{
    double p = sqrt(a * a + c * c), q = sqrt(b * b + c * c);
    return (a / p * atan(b / p) + b / q * atan(a / q)) / (2.0 * PP_PI);
}

static double factor(double x0, double x1, double y0, double y1, double c)
{
    return corner_factor(x1, y1, c) - corner_factor(x0, y1, c)
           - corner_factor(x1, y0, c) + corner_factor(x0, y0, c);
}

/* The weighted directions that meet an opening are its configuration factor, and all
 * weights together are 1, at any throughput. */
static void directions_meet_openings_as_often_as_the_cosine_lobe(void **state)
{
    (void)state;
    struct pp_target list[] = {rooflight(0.7, 1.1, 0.5, 0.9),
                               rooflight(2.2, 0.3, 1.0, 1.8)};
    const struct pp_coarse_openings coarse = {
        .list = list, .count = 2, .inside = {{0.0, 0.0, 0.0}, {4.0, 3.0, 5.0}}};
    const struct pp_brightness brightness = {.ground = 0.2, .gradation = 2.0};
    const struct pp_vec3 from = {1.3, 2.1, 0.0};
    const double expected[] = {factor(-0.6, -0.1, -1.0, -0.1, 5.0),
                               factor(0.9, 1.9, -1.8, 0.0, 5.0)};
    struct pp_frame frame = {.z = {0.0, 0.0, 1.0}};
    struct pp_sobol sobol;
    struct pp_sobol_sequence sequence;
    pp_sobol_init(&sobol);
    pp_lobe_frame(frame.z, &frame.x, &frame.y);
    for (int k = 0; k < 3; k++) {
        enum { N = 1 << 16 };
        double all = 0.0, met[2] = {0.0, 0.0};
        pp_sobol_sequence_init(&sequence, &sobol, 7);
        for (uint32_t i = 0; i < N; i++) {
            double u[3], weight;
            struct pp_vec3 to, there;
            pp_sobol_sequence_draw(&sequence, i, 0, 3, u);
            assert_true(pp_coarse_openings_draw(&coarse, &brightness, from, &frame,
                                                0.4 * k, u, &to, &weight));
            all += weight / N;
            for (int j = 0; j < 2; j++)
                if (pp_target_meets_rectangle(&list[j], from, to, &there))
                    met[j] += weight / N;
        }
        /* Net of 65,536 points in three dimensions, with a step at each edge. */
        assert_near(all, 1.0, 2e-3);
        assert_relative(met[0], expected[0], 5e-3);
        assert_relative(met[1], expected[1], 5e-3);
    }
}

static void openings_attract_no_directions_from_outside_or_from_behind(void **state)
{
    (void)state;
    struct pp_target list[] = {rooflight(0.7, 1.1, 0.5, 0.9)};
    const struct pp_coarse_openings coarse = {
        .list = list, .count = 1, .inside = {{0.0, 0.0, 0.0}, {4.0, 3.0, 5.0}}};
    const struct pp_brightness brightness = {.ground = 0.2, .gradation = 2.0};
    const double u[3] = {0.3, 0.6, 0.1};
    const struct pp_frame upward = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    const struct pp_frame downward = {
        {1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, -1.0}};
    struct pp_vec3 to;
    double weight;
    assert_true(pp_coarse_openings_draw(&coarse, &brightness, pp_vec(1.3, 2.1, 0.0),
                                        &upward, 0.5, u, &to, &weight));
    assert_false(pp_coarse_openings_draw(&coarse, &brightness, pp_vec(5.3, 2.1, 0.0),
                                         &upward, 0.5, u, &to, &weight));
    assert_false(pp_coarse_openings_draw(&coarse, &brightness, pp_vec(1.3, 2.1, 5.0),
                                         &downward, 0.5, u, &to, &weight));
}

/* ---- thermal equilibrium ---- */

static char folder[] = "/tmp/pepperpot-coarse-XXXXXX";

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static const char *path_of(const char *name)
{
    static char path[64];
    snprintf(path, sizeof path, "%s/%s.xml", folder, name);
    return path;
}

static int remove_folder(void **state)
{
    (void)state;
    unlink(path_of("coarse"));
    unlink(path_of("room"));
    return rmdir(folder);
}

static void write_room(const char *name, const char *children, const char *more)
{
    FILE *file = fopen(path_of(name), "w");
    assert_non_null(file);
    fprintf(file, "<room version='1' %s%s</room>", children, more);
    assert_int_equal(fclose(file), 0);
}

/* A room off the east wall of a coarse model, rotated by 90 degrees against it. Every
 * surface of both emits the 0.6 that it does not reflect. */
static struct pp_world *nested_equilibrium(struct pp_outside_light *light,
                                           const char *openings)
{
    struct pp_building *building = NULL;
    struct pp_world *world = NULL;
    struct pp_mistakes mistakes;
    write_room("coarse",
               "><plan width='3.3' depth='4.1' height='7'/>"
               "<window name='w' wall='east' left='0.7' sill='1.2' width='1.9' "
               "height='1.3'/>",
               openings);
    write_room(
        "room",
        "north='90' within='coarse.xml'><plan width='3.1' depth='2.7' height='2.6'/>"
        "<window name='w' wall='south' left='0.5' sill='0.8' width='1.9' "
        "height='1.3' glazing='none' reveal='0.2'/>",
        "<point x='1.2' y='0.4'/><point x='1.7' y='2.3'/><point x='1.3' y='0.9' "
        "z='1.1' nx='0.1' ny='-1' nz='0.3'/>");
    pp_mistakes_init(&mistakes, "test");
    assert_int_equal(pp_building_read(&building, path_of("room"), &mistakes, NULL),
                     PP_OK);
    const struct pp_room *room = pp_building_room(building, 0);
    assert_int_equal(pp_world_create(&world, room, &mistakes, NULL), PP_OK);
    assert_int_equal(pp_room_light(light, room, NULL), PP_OK);
    pp_mistakes_clear(&mistakes);
    pp_building_destroy(building);
    light->sky = pp_sky_uniform();
    light->ground_reflectance = 1.0;
    for (int i = 0; i < world->surface_count; i++) {
        world->surfaces[i].front = world->surfaces[i].back = 0.4;
        world->surfaces[i].exitance = 0.6;
    }
    for (int i = 0; i < world->within->opening_count; i++)
        world->within->openings[i].glass = pp_glass_panes(1, 1.52, 0.0);
    return world;
}

/* Every point has the value 1: no light is lost at an opening of the coarse model, and
 * none is counted twice. */
static void assert_nested_equilibrium(const char *openings, int count)
{
    struct pp_outside_light light;
    struct pp_world *world = nested_equilibrium(&light, openings);
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    struct pp_tracer_options options = pp_test_paths(256);
    assert_int_equal(scene->coarse.count, count);
    pp_light_scene_destroy(scene);
    struct pp_reading(*traced)[4] = pp_test_trace(
        world, &light, world->receivers, world->receiver_count, &options, NULL);
    for (int i = 0; i < world->receiver_count; i++)
        assert_traced(traced[i][PP_DF], 1.0, 0.004);
    free(traced);
    pp_world_destroy(world);
}

static void equilibrium_under_a_small_rooflight_of_the_coarse_model(void **state)
{
    (void)state;
    assert_nested_equilibrium("<rooflight x='0.4' y='2.3' width='0.9' depth='0.7' "
                              "frame-factor='1' maintenance='1'/>",
                              1);
}

static void equilibrium_with_an_open_roof_and_a_window_in_the_coarse_model(void **state)
{
    (void)state;
    assert_nested_equilibrium(
        "<rooflight x='0' y='0' width='3.3' depth='4.1' glazing='none'/>"
        "<window wall='north' left='0.9' sill='2.1' width='1.2' height='3.3' "
        "frame-factor='1' maintenance='1' reveal='0.3'/>",
        2);
}

/* The choice among many openings costs more than it saves. */
static void a_coarse_model_with_nine_rooflights_has_no_targets(void **state)
{
    (void)state;
    char openings[1024] = "";
    struct pp_outside_light light;
    for (int i = 0; i < 9; i++) {
        size_t length = strlen(openings);
        snprintf(openings + length, sizeof openings - length,
                 "<rooflight x='%g' y='%g' width='0.5' depth='0.6'/>",
                 0.3 + 1.1 * (i % 3), 0.4 + 1.2 * (i / 3));
    }
    struct pp_world *world = nested_equilibrium(&light, openings);
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    assert_int_equal(world->outer_pane_count, 9);
    assert_int_equal(scene->coarse.count, 0);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(directions_meet_openings_as_often_as_the_cosine_lobe),
        cmocka_unit_test(openings_attract_no_directions_from_outside_or_from_behind),
        cmocka_unit_test(equilibrium_under_a_small_rooflight_of_the_coarse_model),
        cmocka_unit_test(
            equilibrium_with_an_open_roof_and_a_window_in_the_coarse_model),
        cmocka_unit_test(a_coarse_model_with_nine_rooflights_has_no_targets),
    };
    add_tests(tests, make_folder, remove_folder);
}
