/* test_room_light.c - light in rooms, compared with the tracer and between variants. */
#include "simulate/sampling/hash.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/transport/opening_store.h"
#include "tests/lib/sampled_light.h"
#include "tests/lib/room_of.h"
#include "tests/lib/sized.h"
#include "tests/lib/traced.h"

static struct pp_light_scene *scene_of(const struct pp_world *world)
{
    struct pp_light_scene *scene = NULL;
    struct pp_error err = {0};
    if (pp_light_scene_of_world(&scene, world, &err) != PP_OK)
        fail_msg("%s", err.message);
    return scene;
}

/* The receivers of the file by the tracer with an error of 0.5 % (1 % under
 * sanitizers), and by transport with and without the store: within three of their
 * common standard errors. One receiver in 370 would exceed this at random; seeds are
 * fixed. */
static void assert_as_traced(const char *xml, double slack)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    struct pp_light_scene *scene = scene_of(world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_opening_store *store = NULL;
    assert_int_equal(pp_opening_store_create(&store, scene, environment, 1, 1, NULL),
                     PP_OK);
    struct pp_tracer_options options = {
        .error = PP_SIZED(0.005, 0.005, 0.01), .seed = 11, .threads = 1};
    struct pp_reading(*traced)[4] = pp_test_trace(
        world, &light, world->receivers, world->receiver_count, &options, NULL);
    for (int i = 0; i < world->receiver_count; i++) {
        struct pp_reading df = traced[i][PP_DF];
        for (int stored = 0; stored < 2; stored++) {
            struct pp_radiance_options how = pp_radiance_state_defaults();
            how.source_size = 0.5;
            struct pp_test_mean mean = pp_test_irradiance(
                scene, environment, stored ? store : NULL, how,
                world->receivers[i].position, world->receivers[i].normal,
                PP_SIZED(1024, 512, 128));
            assert_near(mean.value.g, df.value,
                        3.0 * hypot(mean.error, df.std_error)
                            + (stored ? slack * df.value : 0.0));
            assert_true(mean.error < PP_SIZED(0.02, 0.025, 0.05) * df.value);
        }
    }
    free(traced);
    pp_opening_store_destroy(store);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

#define DEEP                                                                           \
    "<room version='1'><plan width='3' depth='9' height='2.7'/>"                       \
    "<finishes floor='0.2' walls='0.7' ceiling='0.8'/>"                                \
    "<window wall='south' left='0.2' sill='0.8' width='2.6' height='1.5'/>"

static void a_deep_room_has_the_tracers_daylight_factors(void **state)
{
    (void)state;
    assert_as_traced(DEEP "<line from='1.5 0.5' to='1.5 8.5' points='3'/></room>", 0.0);
}

/* A block nearby: patches and bins of the store may cause an error of 0.3 %. */
static void room_with_a_block_nearby_is_as_traced(void **state)
{
    (void)state;
    assert_as_traced(DEEP "<block x='-1' y='-4' width='3' depth='2' height='4' "
                          "rotate='15' reflectance='0.6'/>"
                          "<skyline wall='south' angle='25' distance='12'/>"
                          "<line from='1.5 0.5' to='1.5 8.5' points='3'/></room>",
                     0.003);
}

/* A bright wall half a metre in front of the window: light goes back and forth between
 * room and wall. Windows are sampled directly only on the first way out; the patches of
 * the store may cause an error of 1 % just beside the window. */
static void room_with_a_wall_close_to_its_window_is_as_traced(void **state)
{
    (void)state;
    assert_as_traced(DEEP "<block x='-1' y='-2.5' width='3' depth='2' height='4' "
                          "reflectance='0.9'/>"
                          "<line from='1.5 0.5' to='1.5 4.5' points='3'/></room>",
                     0.01);
}

/* Two windows that see each other outside, reveals, frames, dirt, a diffusing
 * rooflight, a partition that glows. */
static void room_with_all_kinds_of_openings_is_as_traced(void **state)
{
    (void)state;
    assert_as_traced(
        "<room version='1'><site ground-reflectance='0.3'/><plan height='2.6'>"
        "<vertex x='0' y='0'/><vertex x='5' y='0'/><vertex x='5' y='2'/>"
        "<vertex x='2' y='2'/><vertex x='2' y='6'/><vertex x='0' y='6'/></plan>"
        "<finish wall='1' reflectance='0.8'/>"
        "<window wall='3' left='0.4' sill='0.6' width='1.6' height='1.4' reveal='0.2' "
        "frame-factor='0.8' maintenance='0.9'/>"
        "<window wall='4' left='0.7' sill='0.5' width='2.2' height='1.8' "
        "glazing='clear-double'/>"
        "<rooflight x='0.4' y='4.1' width='0.9' depth='0.8' transmittance='0.5' "
        "diffusing='yes'/>"
        "<surface reflectance='0.4' exitance='0.02'><vertex x='0.3' y='3' z='0'/>"
        "<vertex x='1.2' y='3.1' z='0'/><vertex x='1.2' y='3.1' z='1.8'/></surface>"
        "<point x='1' y='1'/><point x='4' y='1.2'/><point x='0.8' y='4.6'/>"
        "<point x='1.1' y='2.2' z='1.2' nx='1' ny='0' nz='0.2'/></room>",
        0.003);
}

/* The separation by the tracer: sky and objects outside, as seen from the point through
 * glass. */
static void sky_and_outside_are_separate_components(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, DEEP "<skyline wall='south' angle='20' reflectance='0.3'/></room>");
    struct pp_receiver receiver = pp_test_receiver(1.4, 1.8, 0.9, 0.0, 0.0, 1.0);
    struct pp_tracer_options options = pp_test_paths(1024);
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, &light, &receiver, 1, &options, NULL);
    struct pp_light_scene *scene = scene_of(world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_sobol *sobol = malloc(sizeof *sobol);
    pp_sobol_init(sobol);
    struct pp_radiance_state path_state = {.scene = scene,
                                           .environment = environment,
                                           .options = pp_radiance_state_defaults()};
    pp_sobol_sequence_init(&path_state.sequence, sobol, 5);
    double sky = 0.0, outside = 0.0;
    enum { PATHS = 512 };
    for (path_state.index = 0; path_state.index < PATHS; path_state.index++) {
        struct pp_irradiance e = pp_radiance_direct(&path_state, receiver.position,
                                                    receiver.normal, PP_INDOORS);
        sky += e.sky.g / PATHS;
        outside += e.outside.g / PATHS;
        assert_true(pp_rgb_is_black(e.rest) && pp_rgb_is_black(e.sources));
    }
    /* 512 x 64 directions: accurate to 0.2 %. */
    assert_relative(sky, traced[0][PP_SC].value, 0.003);
    assert_relative(outside, traced[0][PP_ERC].value, 0.003);
    assert_int_equal(path_state.leaks, 0);
    free(traced);
    free(sobol);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* If windows are only found by random paths, the light is the same but needs more
 * rays. */
static void windows_aimed_at_save_time_not_light(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, DEEP "</room>");
    struct pp_light_scene *scene = scene_of(world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_radiance_options options = pp_radiance_state_defaults();
    struct pp_vec3 back = {1.5, 7.0, 0.85}, up = {0.0, 0.0, 1.0};
    struct pp_test_mean sampled = pp_test_irradiance(scene, environment, NULL, options,
                                                     back, up, PP_SIZED(256, 256, 64));
    options.windows = false;
    struct pp_test_mean found = pp_test_irradiance(scene, environment, NULL, options,
                                                   back, up, PP_SIZED(1024, 1024, 256));
    assert_near(sampled.value.g, found.value.g,
                4.0 * hypot(sampled.error, found.error));
    /* The number of rays for the same error is proportional to the squared error. */
    double rays = (double)sampled.rays * sampled.error * sampled.error;
    assert_true((double)found.rays * found.error * found.error > 2.0 * rays);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* Rooms with a mirror and metal narrower or wider than the window, a window that is not
 * a rectangle, and a house outside. */
static const char *const polished[] = {
    "<finishes floor='polished-aluminium' walls='0.5' ceiling='0.7'/>"
    "<window wall='south' left='0.2' sill='0.8' width='2.6' height='1.5'/>",
    "<finishes floor='0.2' walls='0.5' ceiling='brass'/>"
    "<finish wall='east' reflectance='mirror'/>"
    "<window wall='south' left='0.4' sill='1.1' width='0.7' height='0.9'/>"
    "<window wall='south' left='1.6' sill='0.9' width='0.8' height='0.8'/>"
    "<block x='-4' y='-14' width='10' depth='6' height='5'/>",
    "<finishes floor='0.2' walls='0.5' ceiling='0.7'/>"
    "<finish wall='east' reflectance='brushed-aluminium'/>"
    "<finish wall='north' reflectance='polished-aluminium'/>"
    "<opening><vertex x='0.8' y='0' z='2.2'/><vertex x='1.9' y='0' z='2.3'/>"
    "<vertex x='2.6' y='0' z='1.1'/><vertex x='0.3' y='0' z='0.9'/></opening>"};

/* Polished planes reflect the same light of a window, whether its mirror images are
 * sampled directly or found by rays from the walls; with less than half the error for
 * the same number of paths. */
static void polished_planes_send_on_the_same_light_aimed_at_and_found(void **state)
{
    (void)state;
    const uint32_t paths = PP_SIZED(256, 128, 32);
    const struct pp_vec3 points[] = {{0.7, 1.3, 2.1}, {1.9, 3.1, 0.9}};
    const struct pp_vec3 normals[] = {{0.6, 0.0, -0.8}, {0.0, 0.6, 0.8}};
    for (int i = 0; i < 3; i++) {
        char xml[2000];
        struct pp_outside_light light;
        snprintf(
            xml, sizeof xml,
            "<room version='1'><plan width='3' depth='4.3' height='2.7'/>%s</room>",
            polished[i]);
        struct pp_world *world = pp_test_lit_world(&light, xml);
        struct pp_light_scene *scene = scene_of(world);
        struct pp_environment *environment = pp_test_light_on(scene, &light);
        double sampled_square = 0.0, found_square = 0.0;
        for (int k = 0; k < 2; k++) {
            struct pp_radiance_options options = pp_radiance_state_defaults();
            options.source_most = 1;
            struct pp_test_mean sampled = pp_test_irradiance(
                scene, environment, NULL, options, points[k], normals[k], paths);
            options.windows = false;
            struct pp_test_mean found = pp_test_irradiance(
                scene, environment, NULL, options, points[k], normals[k], 8 * paths);
            assert_near(sampled.value.g, found.value.g,
                        4.0 * hypot(sampled.error, found.error));
            assert_true(sampled.error < PP_SIZED(0.03, 0.03, 0.06) * sampled.value.g);
            sampled_square += pow(sampled.error / sampled.value.g, 2.0);
            found_square += pow(found.error / found.value.g, 2.0);
        }
        assert_true(sampled_square < 0.25 * 8.0 * found_square);
        pp_environment_destroy(environment);
        pp_light_scene_destroy(scene);
        pp_world_destroy(world);
    }
}

/* Part of a wall in front of one window receives light through the room and its other
 * window. From this wall windows are not sampled directly, so light found through both
 * windows counts. */
static void light_through_two_windows_falls_on_objects_outside(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version='1'><plan width='3' depth='2' height='2.7'/>"
        "<finishes floor='0.2' walls='0.2' ceiling='0.2'/>"
        "<window wall='south' left='0.2' sill='0.3' width='2.6' height='2.2' "
        "glazing='none'/><window wall='north' left='0.2' sill='0.3' width='2.6' "
        "height='2.2' glazing='none'/>"
        "<block x='-9' y='-3' width='21' depth='2' height='12' reflectance='0.8'/>"
        "</room>");
    struct pp_light_scene *scene = scene_of(world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_radiance_options options = pp_radiance_state_defaults();
    struct pp_vec3 eye = {1.5, 1.0, 1.5}, south = {0.0, -1.0, 0.0};
    const uint32_t paths = PP_SIZED(1024, 512, 128);
    struct pp_test_mean sampled =
        pp_test_radiance(scene, environment, options, eye, south, paths);
    options.windows = false;
    struct pp_test_mean found =
        pp_test_radiance(scene, environment, options, eye, south, paths);
    assert_near(sampled.value.g, found.value.g,
                4.0 * hypot(sampled.error, found.error));
    assert_true(hypot(sampled.error, found.error)
                < PP_SIZED(0.01, 0.015, 0.03) * found.value.g);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* A room in equilibrium with a white sky and ground, whose matt and glossy surfaces
 * emit the share that they do not reflect: all radiances are 1 / pi. */
static void a_room_in_equilibrium_shows_one_everywhere(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><site ground-reflectance='1'/><sky type='uniform'/>"
                "<plan width='3.1' depth='4.3' height='2.6'/>"
                "<finishes floor='steel' walls='0.3' ceiling='mirror'/>"
                "<finish wall='east' reflectance='brushed-aluminium'/>"
                "<finish wall='west' reflectance='white-tiles'/>"
                "<window wall='south' left='0.5' sill='0.4' width='1.9' height='1.6' "
                "glazing='none' reveal='0.3'/></room>");
    for (int i = 0; i < world->surface_count; i++) {
        world->surfaces[i].exitance = 1.0 - world->surfaces[i].front;
        world->surfaces[i].back =
            world->surfaces[i].front; /* as seen from the ground */
    }
    struct pp_light_scene *scene = scene_of(world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_radiance_options options = pp_radiance_state_defaults();
    const struct pp_vec3 looks[] = {{0.1, 0.2, 1.0},   {0.3, -1.0, 0.1},
                                    {-0.4, 0.3, -0.6}, {0.0, -1.0, -0.2},
                                    {1.0, -0.3, 0.1},  {-1.0, -0.4, -0.1}};
    for (int i = 0; i < 6; i++)
        assert_lit(pp_test_radiance(scene, environment, options, pp_vec(1.4, 2.2, 1.1),
                                    looks[i], PP_SIZED(256, 128, 32)),
                   1.0 / PP_PI, PP_SIZED(0.002, 0.003, 0.006));
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* No ray leaves through the edges, although all rays are aimed at them. */
static void no_light_leaks_in_by_the_edges(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan height='2.6'><vertex x='101' y='57'/>"
                "<vertex x='104' y='57.3'/><vertex x='103' y='60'/></plan></room>");
    struct pp_light_scene *scene = scene_of(world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_vec3 in = {102.7, 58.1, 1.1};
    const struct pp_surface *surfaces = world->surfaces;
    for (int i = 0; i < world->surface_count; i++)
        for (int k = 0; k < surfaces[i].outline.count; k++)
            for (int s = 0; s <= 1000; s++) {
                struct pp_vec3 a = surfaces[i].outline.vertices[k];
                struct pp_vec3 b =
                    surfaces[i].outline.vertices[(k + 1) % surfaces[i].outline.count];
                struct pp_vec3 at = pp_vec_along(a, s / 1000.0, pp_vec_sub(b, a));
                struct pp_light_ray ray = {.from = in,
                                           .to = pp_vec_unit(pp_vec_sub(at, in)),
                                           .space = PP_INDOORS};
                struct pp_light_hit hit;
                assert_true(pp_light_scene_first(scene, &ray, &hit));
                assert_false(hit.back);
            }
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* A ray of a picture that hits an edge exactly: the light continues from there into the
 * room. */
static void light_goes_on_from_the_edges(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, DEEP "</room>");
    struct pp_light_scene *scene = scene_of(world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_sobol *sobol = malloc(sizeof *sobol);
    pp_sobol_init(sobol);
    struct pp_radiance_state path_state = {.scene = scene,
                                           .environment = environment,
                                           .options = pp_radiance_state_defaults()};
    pp_sobol_sequence_init(&path_state.sequence, sobol, 7);
    for (path_state.index = 0; path_state.index < 3000; path_state.index++) {
        struct pp_vec3 eye = {1.5, 8.0, 1.6}, at = {0.001 * path_state.index, 0.0, 0.0};
        struct pp_light_ray ray = {
            .from = eye, .to = pp_vec_unit(pp_vec_sub(at, eye)), .space = PP_INDOORS};
        pp_radiance_along(&path_state, &ray, NULL);
    }
    assert_true(path_state.rays > 6000);
    assert_int_equal(path_state.leaks, 0);
    free(sobol);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* Direct light of sky and objects outside on a horizontal plane in the room. */
static struct pp_irradiance straight_in(const char *xml, bool stored,
                                        struct pp_vec3 point)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    struct pp_light_scene *scene = scene_of(world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_opening_store *store = NULL;
    struct pp_sobol *sobol = malloc(sizeof *sobol);
    assert_non_null(sobol);
    pp_sobol_init(sobol);
    assert_int_equal(pp_opening_store_create(&store, scene, environment, 1, 1, NULL),
                     PP_OK);
    struct pp_radiance_state path_state = {.scene = scene,
                                           .environment = environment,
                                           .options = pp_radiance_state_defaults(),
                                           .store = stored ? store : NULL};
    struct pp_irradiance sum = {.rest = pp_rgb_grey(0.0)};
    enum { PATHS = 1024 };
    pp_sobol_sequence_init(&path_state.sequence, sobol, 5);
    for (path_state.index = 0; path_state.index < PATHS; path_state.index++) {
        struct pp_irradiance e =
            pp_radiance_direct(&path_state, point, pp_vec(0.0, 0.0, 1.0), PP_INDOORS);
        sum.sky = pp_rgb_along(sum.sky, 1.0 / PATHS, e.sky);
        sum.outside = pp_rgb_along(sum.outside, 1.0 / PATHS, e.outside);
    }
    free(sobol);
    pp_opening_store_destroy(store);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
    return sum;
}

/* A skyline 1 m in front of a diffusing pane leaves little sky for its lower half. An
 * average over the pane would be half as much again near it, and a quarter less far
 * away. Compared with exact integration; 1024 x 64 directions are accurate to 1 %. */
static void a_diffusing_pane_is_lit_from_point_to_point(void **state)
{
    (void)state;
    static const char xml[] =
        "<room version='1'><plan width='3' depth='5' height='2.7'/>"
        "<window wall='south' left='0.2' sill='0.4' width='2.6' height='2.1' "
        "transmittance='0.6' diffusing='yes'/>"
        "<skyline wall='south' angle='50' distance='1' reflectance='0.1'/></room>";
    for (int stored = 0; stored < 2; stored++) {
        struct pp_vec3 near = {1.5, 0.15, 0.85}, far = {1.5, 2.80714285714, 0.85};
        assert_relative(straight_in(xml, stored, near).sky.g, 0.02720136814, 0.02);
        assert_relative(straight_in(xml, stored, far).sky.g, 0.004384324179, 0.02);
    }
}

/* A bright shelf that touches the window, in front of a dark wall: objects nearer than
 * the patches can resolve are not stored. If they were, the result would be 7.6 % too
 * high. */
static void things_at_the_window_are_not_stored(void **state)
{
    (void)state;
    static const char xml[] =
        "<room version='1'><plan width='3' depth='5' height='2.7'/>"
        "<window wall='south' left='0.2' sill='0.4' width='2.6' height='2.1'/>"
        "<surface reflectance='0.8'><vertex x='-1' y='-1.2' z='0'/>"
        "<vertex x='4' y='-1.2' z='0'/><vertex x='4' y='-1.2' z='3'/>"
        "<vertex x='-1' y='-1.2' z='3'/></surface>"
        "<surface reflectance='0.9'><vertex x='0' y='-0.5' z='1.4'/>"
        "<vertex x='3' y='-0.5' z='1.4'/><vertex x='3' y='-0.02' z='1.4'/>"
        "<vertex x='0' y='-0.02' z='1.4'/></surface></room>";
    struct pp_vec3 point = {1.5, 0.15, 0.85};
    double stored = straight_in(xml, true, point).outside.g;
    double followed = straight_in(xml, false, point).outside.g;
    /* 1024 x 64 directions each: accurate to 1 %. */
    assert_relative(stored, followed, 0.025);
}

/* The store is identical for one thread and for three. */
static void the_store_does_not_depend_on_threads(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, DEEP "<block x='-1' y='-3' width='3' depth='2' height='4'/></room>");
    struct pp_light_scene *scene = scene_of(world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    double seen[2];
    for (int i = 0; i < 2; i++) {
        struct pp_opening_store *store;
        assert_int_equal(
            pp_opening_store_create(&store, scene, environment, 9, 1 + 2 * i, NULL),
            PP_OK);
        seen[i] =
            pp_test_irradiance(scene, environment, store, pp_radiance_state_defaults(),
                               pp_vec(1.2, 2.3, 0.7), pp_vec(0.0, 0.0, 1.0), 8)
                .value.g;
        pp_opening_store_destroy(store);
    }
    assert_true(seen[0] == seen[1] && seen[0] > 0.0);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_deep_room_has_the_tracers_daylight_factors),
        cmocka_unit_test(room_with_a_block_nearby_is_as_traced),
        cmocka_unit_test(sky_and_outside_are_separate_components),
        cmocka_unit_test(windows_aimed_at_save_time_not_light),
        cmocka_unit_test(polished_planes_send_on_the_same_light_aimed_at_and_found),
        cmocka_unit_test(light_through_two_windows_falls_on_objects_outside),
        cmocka_unit_test(a_room_in_equilibrium_shows_one_everywhere),
        cmocka_unit_test(no_light_leaks_in_by_the_edges),
        cmocka_unit_test(light_goes_on_from_the_edges),
        cmocka_unit_test(a_diffusing_pane_is_lit_from_point_to_point),
        cmocka_unit_test(things_at_the_window_are_not_stored),
        cmocka_unit_test(the_store_does_not_depend_on_threads),
    };
    add_tests(tests, NULL, NULL);
    const struct CMUnitTest long_tests[] = {
        cmocka_unit_test(room_with_a_wall_close_to_its_window_is_as_traced),
        cmocka_unit_test(room_with_all_kinds_of_openings_is_as_traced),
    };
    add_long_tests(long_tests, NULL, NULL);
}
