/* test_ground.c - the ground outside is a surface shaded by the objects on it. */
#include "model/room/ground.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/transport/radiance_state.h"
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"

static const double rho = 0.2;

/* A world without a room whose ground is at z = -1 m. */
static struct pp_world open_field(void)
{
    return (struct pp_world){.ground_level_m = -1.0};
}

static struct pp_reading external_of(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     struct pp_receiver receiver)
{
    const struct pp_tracer_options options = pp_test_paths(512);
    struct pp_reading(*readings)[4] =
        pp_test_trace(world, light, &receiver, 1, &options, NULL);
    struct pp_reading external = readings[0][PP_ERC];
    free(readings);
    return external;
}

static struct pp_receiver facing_down(double x, double y, double z)
{
    return pp_test_receiver(x, y, z, 0.0, 0.0, -1.0);
}

/* Without objects: rho for a horizontal receiver, half of it for a wall. */
static void an_open_field_reflects_its_share_of_the_whole_sky(void **state)
{
    (void)state;
    struct pp_outside_light light = {.sky = pp_sky_overcast(),
                                     .ground_reflectance = rho};
    struct pp_world world = open_field();
    assert_traced(external_of(&world, &light, facing_down(3.0, 4.0, 0.0)), rho, 1e-3);
    assert_traced(external_of(&world, &light, pp_test_receiver(0, 0, 0, 0, 1, 0)),
                  0.5 * rho, 1e-3);
}

/* At its foot an infinitely long black wall hides half of a uniform sky from the
 * ground; at the distance of its height it hides (1 - cos 45 deg)/2. The receivers are
 * a millimetre above the ground and see the ground directly below them. */
static void a_wall_takes_its_share_of_the_sky_from_the_ground(void **state)
{
    (void)state;
    enum { HEIGHT = 10 };
    struct pp_vec3 corners[4] = {
        {-5000, 0, -1}, {5000, 0, -1}, {5000, 0, HEIGHT - 1}, {-5000, 0, HEIGHT - 1}};
    struct pp_surface wall = {.outline = {4, corners, {0, -1, 0}, 10000.0 * HEIGHT},
                              .role = PP_FREE_SURFACE,
                              .owner = -1};
    struct pp_outside_light light = {.sky = pp_sky_uniform(),
                                     .ground_reflectance = rho};
    struct pp_world world = open_field();
    world.surfaces = &wall;
    world.surface_count = 1;
    static const double distances[] = {0.1, 3.0, 10.0, 40.0};
    for (int i = 0; i < 4; i++) {
        double angle = atan2(HEIGHT, distances[i]);
        assert_traced(
            external_of(&world, &light, facing_down(0.0, -distances[i], -0.999)),
            rho * (1.0 + cos(angle)) / 2.0, 1e-3);
    }
    world.ground_is_open = true;
    assert_traced(external_of(&world, &light, facing_down(0.0, -0.1, -0.999)), rho,
                  1e-3);
}

/* A wall reflects as much light as it hides, if it is white: with white walls, white
 * ground and a uniform sky, light is the same everywhere, as if there were no walls. */
static void white_walls_and_white_ground_vanish_in_a_uniform_sky(void **state)
{
    (void)state;
    struct pp_vec3 corners[4] = {{-6, 0, -1}, {6, 0, -1}, {6, 0, 4}, {-6, 0, 4}};
    struct pp_surface wall = {.outline = {4, corners, {0, -1, 0}, 60.0},
                              .role = PP_FREE_SURFACE,
                              .front = 1.0,
                              .back = 1.0,
                              .owner = -1};
    struct pp_outside_light light = {.sky = pp_sky_uniform(),
                                     .ground_reflectance = rho};
    struct pp_world world = open_field();
    light.ground_reflectance = 1.0;
    world.surfaces = &wall;
    world.surface_count = 1;
    assert_traced(external_of(&world, &light, facing_down(0.5, -1.0, 0.0)), 1.0, 1e-3);
    assert_traced(external_of(&world, &light, pp_test_receiver(0, -3, 0, 0, -1, 0)),
                  0.5, 2e-3);
}

#define BOX                                                                            \
    "<plan width='4' depth='5' height='2.7'/>"                                         \
    "<window wall='south' left='0.5' sill='0.8' width='3' height='1.5'/>"

/* A skyline of 30 degrees at infinite distance: the ground receives (1 + cos 30 deg)/2
 * of a uniform sky, and the rest from the exitance of the skyline, which by convention
 * is rho (1/2 + rho_ground/2). The receiver is outside, 3 km from the wall and 1 mm
 * above the ground, and faces down. */
static void a_far_skyline_shades_the_ground_and_lights_it(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version='1'><sky type='uniform'/><site ground-level='-0.001'/>" BOX
        "<skyline wall='south' angle='30' reflectance='0.4'/></room>");
    struct pp_receiver receiver = facing_down(2.0, -3000.0, 0.0);
    double open = (1.0 + cos(30.0 * PP_RAD)) / 2.0;
    double exitance = 0.4 * (0.5 + rho / 2.0);
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    scene->has_room = false; /* the point is outside, far from the room */
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    const struct pp_tracer_options options = pp_test_paths(512);
    struct pp_tracer *tracer = NULL;
    assert_int_equal(
        pp_tracer_create(&tracer, scene, environment, &receiver, 1, &options, NULL),
        PP_OK);
    while (!pp_tracer_done(tracer))
        assert_int_equal(pp_tracer_advance(tracer, 1.0, NULL), PP_OK);
    struct pp_reading readings[4];
    pp_tracer_read(tracer, 0, readings);
    assert_traced(readings[PP_ERC], rho * (open + (1.0 - open) * exitance), 1e-3);
    pp_tracer_destroy(tracer);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

static void trace_room(const char *xml, struct pp_receiver receiver,
                       struct pp_reading readings[4])
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    const struct pp_tracer_options options = pp_test_paths(2048);
    struct pp_reading(*list)[4] =
        pp_test_trace(world, &light, &receiver, 1, &options, NULL);
    memcpy(readings, list[0], sizeof *list);
    free(list);
    pp_world_destroy(world);
}

#define STREET                                                                         \
    "<block x='-30' y='-16' width='64' depth='8' height='11' reflectance='0.3'/>"
#define PAVED                                                                          \
    "<surface reflectance='0.2'><vertex x='-800' y='-400' z='-0.5'/>"                  \
    "<vertex x='800' y='-400' z='-0.5'/><vertex x='800' y='400' z='-0.5'/>"            \
    "<vertex x='-800' y='400' z='-0.5'/></surface>"

/* The ground of a street written as a surface, as in older files, compared with the
 * program's ground. */
static void the_ground_is_as_a_surface_of_the_file(void **state)
{
    (void)state;
    const struct pp_receiver receiver = pp_test_receiver(2.0, 2.5, 0.85, 0, 0, 1);
    struct pp_reading own[4], written[4], open[4];
    trace_room("<room version='1'><site ground-level='-0.5'/>" BOX STREET "</room>",
               receiver, own);
    trace_room(
        "<room version='1'><site ground-level='-0.5' ground='open'/>" BOX STREET PAVED
        "</room>",
        receiver, written);
    trace_room("<room version='1'><site ground-level='-0.5' ground='open'/>" BOX STREET
               "</room>",
               receiver, open);
    for (int i = PP_SC; i <= PP_DF; i++)
        assert_near(own[i].value, written[i].value,
                    3.0 * hypot(own[i].std_error, written[i].std_error) + 1e-9);
    assert_true(open[PP_IRC].value > 1.1 * own[PP_IRC].value);
}

/* In front of a window that extends below the ground, the ground is lowered. */
static void the_ground_lies_no_higher_than_a_sill(void **state)
{
    (void)state;
    struct pp_world *low =
        pp_test_world("<room version='1'><site ground-level='1.2'/>" BOX "</room>");
    struct pp_world *high =
        pp_test_world("<room version='1'><site ground-level='-6'/>" BOX "</room>");
    assert_near(pp_ground_level(low), 0.8, 1e-12);
    assert_near(pp_ground_level(high), -6.0, 0.0);
    pp_world_destroy(low);
    pp_world_destroy(high);
}

/* Inside a reveal it is unknown on which side of the glass a point is. No ground is
 * visible in the room, although the ground is higher than the floor. */
static void there_is_no_ground_in_a_basement(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version='1'><site ground-level='1'/>"
        "<plan width='4' depth='5' height='2.7'/>"
        "<window wall='south' left='0.5' sill='1.4' width='3' height='1' reveal='0.3'/>"
        "</room>");
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    struct pp_light_ray ray = {.from = {2.0, -0.1, 1.8},
                               .to = pp_vec_unit(pp_vec(0.0, 1.0, -1.0))};
    struct pp_light_hit hit;
    ray.space = pp_light_scene_space(scene, ray.from);
    assert_int_equal(ray.space, PP_ANYWHERE);
    assert_true(pp_light_scene_first(scene, &ray, &hit));
    assert_near(hit.point.z, 0.0, 1e-9);
    /* The same ray in the opposite direction reaches the ground through the glass. */
    ray.to.y = -ray.to.y;
    ray.from.y = -0.4;
    ray.from = pp_vec_sub(ray.from, scene->centre);
    ray.space = PP_OUTDOORS;
    assert_int_equal(pp_light_scene_meet(scene, &ray, &hit), PP_MEETS_GROUND);
    assert_near(hit.point.z + scene->centre.z, 1.0, 1e-9);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* The ground hides the ends of shadow rays on its other side. */
static void a_shadow_ray_ends_at_the_ground(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan width='4' depth='5' height='2.7'/></room>");
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    struct pp_radiance_state paths = {.scene = scene};
    struct pp_rgb through = pp_rgb_grey(1.0);
    struct pp_light_ray ray = {.from =
                                   pp_vec_sub(pp_vec(2.0, -3.0, 1.0), scene->centre),
                               .to = pp_vec_unit(pp_vec(0.0, -1.0, -1.0)),
                               .space = PP_OUTDOORS};
    assert_false(pp_radiance_state_unoccluded(&paths, ray, -1, INFINITY, &through));
    assert_false(pp_radiance_state_unoccluded(&paths, ray, 0, 5.0, &through));
    ray.to.z = -ray.to.z;
    assert_true(pp_radiance_state_unoccluded(&paths, ray, -1, INFINITY, &through));
    assert_int_equal(paths.rays, 3);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_open_field_reflects_its_share_of_the_whole_sky),
        cmocka_unit_test(a_wall_takes_its_share_of_the_sky_from_the_ground),
        cmocka_unit_test(white_walls_and_white_ground_vanish_in_a_uniform_sky),
        cmocka_unit_test(a_far_skyline_shades_the_ground_and_lights_it),
        cmocka_unit_test(the_ground_is_as_a_surface_of_the_file),
        cmocka_unit_test(the_ground_lies_no_higher_than_a_sill),
        cmocka_unit_test(there_is_no_ground_in_a_basement),
        cmocka_unit_test(a_shadow_ray_ends_at_the_ground),
    };
    add_tests(tests, NULL, NULL);
}
