/* test_photons.c - light followed forwards, compared with known values. */
#include "model/light/finishes.h"
#include "tests/lib/equilibrium.h"
#include "tests/lib/photons_of.h"
#include "tests/lib/random_rooms.h"

static struct pp_photons_options photons_of(long samples)
{
    return (struct pp_photons_options){.samples = samples, .seed = 20, .threads = 1};
}

/* One receiver, all components. */
static void follow_one(const struct pp_world *world,
                       const struct pp_outside_light *light,
                       struct pp_receiver receiver, long samples,
                       struct pp_reading readings[4])
{
    struct pp_photons_options options = photons_of(samples);
    struct pp_reading(*found)[4] =
        pp_test_photons(world, light, &receiver, 1, &options, NULL);
    memcpy(readings, found[0], sizeof found[0]);
    free(found);
}

/* ---- limits ---- */

static void a_closed_room_is_dark_for_certain(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'>" PP_TEST_BOX "<point x='1.2' y='2.3'/></room>");
    struct pp_photons_options options = {.error = 0.01, .seed = 1, .average = true};
    struct pp_reading(*found)[4] =
        pp_test_photons(world, &light, world->receivers, 1, &options, NULL);
    for (int point = 0; point < 2; point++)
        for (int i = 0; i < PP_COMPONENT_COUNT; i++) {
            assert_near(found[point][i].value, 0.0, 0.0);
            assert_near(found[point][i].std_error, 0.0, 0.0);
        }
    free(found);
    pp_world_destroy(world);
}

static void the_open_sky_is_all_there_is_without_a_room(void **state)
{
    (void)state;
    const struct pp_world world = {0};
    struct pp_outside_light light = {.sky = pp_sky_overcast(),
                                     .ground_reflectance = 0.3};
    struct pp_reading readings[4];
    follow_one(&world, &light, pp_test_receiver(1.0, 2.0, 3.0, 0.0, 0.0, 1.0), 256,
               readings);
    assert_traced(readings[PP_SC], 1.0, 1e-3);
    assert_near(readings[PP_ERC].value, 0.0, 0.0);
    follow_one(&world, &light, pp_test_receiver(1.0, 2.0, 3.0, 0.3, -0.4, 0.0), 256,
               readings);
    assert_traced(readings[PP_SC], 0.396177, 2e-3);
    assert_traced(readings[PP_ERC], 0.15, 2e-3);
}

/* Every surface emits 1 and reflects rho of the light it receives: 1 + rho + rho^2 +
 * ... Photons that start or land a millimetre from a receiver would contribute without
 * limit; the errors remain a few per cent there, too. In the corner connections keep
 * 2e-6 of the light, which one photon in a million contributes. */
static void a_furnace_glows_with_one_over_one_less_rho(void **state)
{
    (void)state;
    const double reflectances[] = {0.0, 0.5, 0.9};
    const struct pp_receiver receivers[] = {
        pp_test_receiver(1.2, 2.3, 0.7, 0.2, 0.3, 1.0),
        pp_test_receiver(0.001, 2.3, 0.7, -1.0, 0.0, 0.0),
        pp_test_receiver(0.001, 2.3, 0.001, 0.0, 0.0, 1.0),
        pp_test_receiver(0.001, 0.001, 0.001, -0.3, -0.5, -0.7),
    };
    enum { COUNT = sizeof receivers / sizeof *receivers };
    struct pp_outside_light light;
    struct pp_world *world =
        pp_test_lit_world(&light, "<room version='1'>" PP_TEST_BOX "</room>");
    for (size_t i = 0; i < sizeof reflectances / sizeof *reflectances; i++) {
        for (int k = 0; k < world->surface_count; k++) {
            world->surfaces[k].exitance = 1.0;
            world->surfaces[k].front = reflectances[i];
        }
        struct pp_photons_options options = photons_of(128);
        options.average = true;
        struct pp_reading(*found)[4] =
            pp_test_photons(world, &light, receivers, COUNT, &options, NULL);
        double expected = 1.0 / (1.0 - reflectances[i]);
        for (int k = 0; k <= COUNT; k++) {
            assert_near(found[k][PP_IRC].value, expected,
                        4.0 * found[k][PP_IRC].std_error + 1e-5 * expected);
            assert_true(found[k][PP_IRC].std_error < 0.03 * expected);
        }
        free(found);
    }
    pp_world_destroy(world);
}

/* Between perfect mirrors as walls, floor and ceiling are infinite plates:
 *
 *    B_f = M_f + rho_f B_c,  B_c = M_c + rho_c B_f
 *
 * M is the exitance. A receiver that faces one of them has its B.
 */
static void two_plates_light_each_other_by_a_geometric_series(void **state)
{
    (void)state;
    static const struct pp_finish mirror = {.name = "mirror",
                                            .reflectance = 1.0,
                                            .red = 1.0,
                                            .green = 1.0,
                                            .blue = 1.0,
                                            .specular = 1.0,
                                            .along = 0.0,
                                            .across = 0.0,
                                            .metal = "no"};
    const double given[2] = {0.3, 1.7}, reflectance[2] = {0.4, 0.8};
    struct pp_outside_light light;
    struct pp_world *world =
        pp_test_lit_world(&light, "<room version='1'>" PP_TEST_BOX "</room>");
    for (int i = 0; i < world->surface_count; i++) {
        struct pp_surface *surface = &world->surfaces[i];
        bool upper = surface->role == PP_CEILING;
        surface->front = surface->role == PP_WALL ? 1.0 : reflectance[upper];
        surface->finish = surface->role == PP_WALL ? &mirror : NULL;
        surface->exitance = surface->role == PP_WALL ? 0.0 : given[upper];
    }
    const struct pp_receiver receivers[] = {
        pp_test_receiver(0.4, 1.1, 0.8, 0.0, 0.0, 1.0),
        pp_test_receiver(2.3, 3.9, 1.7, 0.0, 0.0, -1.0)};
    struct pp_light_scene *scene = NULL;
    assert_int_equal(pp_light_scene_of_world(&scene, world, NULL), PP_OK);
    struct pp_photons_options options = photons_of(1024);
    struct pp_reading(*found)[4] =
        pp_test_photons_in(scene, &light, receivers, 2, &options, NULL);
    double more = 1.0 - reflectance[0] * reflectance[1];
    assert_traced(found[0][PP_IRC], (given[1] + reflectance[1] * given[0]) / more,
                  0.03);
    assert_traced(found[1][PP_IRC], (given[0] + reflectance[0] * given[1]) / more,
                  0.03);
    free(found);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* ---- thermal equilibrium ---- */

/* Every receiver of a room in equilibrium (equilibrium.h) has the value 1. */
static void assert_equilibrium(const char *xml, bool lossless_glass)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_equilibrium(&light, xml, lossless_glass);
    struct pp_photons_options options = photons_of(256);
    struct pp_photons_work work;
    options.average = world->plane.count > 0;
    int count = world->receiver_count;
    struct pp_reading(*found)[4] =
        pp_test_photons(world, &light, world->receivers, count, &options, &work);
    for (int i = 0; i < count + options.average; i++)
        assert_traced(found[i][PP_DF], 1.0, 0.02);
    assert_true(work.leaks <= work.rays / 1000000);
    free(found);
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

/* ---- direct light ---- */

static void openings_show_the_sky_of_quadrature(void **state)
{
    (void)state;
    enum { POINTS_OF_ROOM = 4 };
    for (uint64_t room = 50; room < 56; room++) {
        struct pp_outside_light light;
        struct pp_world *world = pp_test_random_room(&light, room, POINTS_OF_ROOM);
        struct pp_photons_options options = photons_of(128);
        struct pp_reading(*found)[4] = pp_test_photons(world, &light, world->receivers,
                                                       POINTS_OF_ROOM, &options, NULL);
        for (int i = 0; i < POINTS_OF_ROOM; i++) {
            double truth = pp_test_sky_component(world, &light, &world->receivers[i]);
            assert_traced(found[i][PP_SC], truth, 0.04 * truth + 1e-5);
        }
        free(found);
        pp_world_destroy(world);
    }
}

/* A receiver a few millimetres from the middle of an unglazed window receives the
 * vertical illuminance from the sky, 0.396 Eh, and half of the ground's 0.3, since the
 * window nearly fills its view. */
static void at_the_window_half_the_view_is_sky(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version='1'><site ground-reflectance='0.3' ground='open'/>" PP_TEST_BOX
        "<window wall='south' left='0.3' sill='0.3' width='2.5' height='2' "
        "glazing='none'/></room>");
    struct pp_reading readings[4];
    follow_one(world, &light, pp_test_receiver(1.55, 0.003, 1.3, 0.0, -1.0, 0.0), 1024,
               readings);
    assert_traced(readings[PP_SC], 0.396177, 0.01);
    assert_traced(readings[PP_ERC], 0.15, 0.01);
    pp_world_destroy(world);
}

/* Three windows in a row across a court show the same sky. Its light counts once, from
 * the first window through the other wing, or from the last one through the court.
 * Midpoint rule over the last window, whose outline limits the view; all surfaces are
 * black. */
static void through_three_windows_one_sees_the_sky_once(void **state)
{
    (void)state;
    enum { CELLS = 200 };
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan height='4'><vertex x='0' y='0'/>"
                "<vertex x='2' y='0'/><vertex x='2' y='4'/><vertex x='5' y='4'/>"
                "<vertex x='5' y='0'/><vertex x='7' y='0'/><vertex x='7' y='6'/>"
                "<vertex x='0' y='6'/></plan>"
                "<window wall='2' left='1.6' sill='0.8' width='0.8' height='1.4' "
                "glazing='none'/>"
                "<window wall='4' left='1.6' sill='0.8' width='0.8' height='1.4' "
                "glazing='none'/>"
                "<window wall='6' left='1.6' sill='0.8' width='0.8' height='1.4' "
                "glazing='none'/></room>");
    struct pp_receiver receiver = pp_test_receiver(0.3, 2.0, 1.5, 1.0, 0.0, 0.0);
    light.ground_reflectance = 0.0;
    for (int i = 0; i < world->surface_count; i++)
        world->surfaces[i].front = world->surfaces[i].back = 0.0;
    double sky = 0.0;
    for (int i = 0; i < CELLS; i++)
        for (int k = 0; k < CELLS; k++) {
            struct pp_vec3 to =
                pp_vec(6.7, 0.8 * ((i + 0.5) / CELLS - 0.5), 0.7 * (k + 0.5) / CELLS);
            double r = pp_vec_length(to), cosine = 6.7 / r;
            sky += pp_sky_luminance(&light.sky, pp_vec_scale(to, 1.0 / r)) * cosine
                   * cosine / (r * r) * 0.8 * 0.7 / (CELLS * CELLS);
        }
    struct pp_reading readings[4];
    follow_one(world, &light, receiver, 1024, readings);
    assert_traced(readings[PP_SC], sky, 0.02 * sky);
    assert_traced(readings[PP_DF], sky, 0.02 * sky);
    pp_world_destroy(world);
}

/* ---- sensors of finite size ---- */

/* The result of a disc is the mean over the disc, compared with 4 x 16 points on rings
 * of equal area. */
static void a_disc_counts_the_mean_over_it(void **state)
{
    (void)state;
    enum { RINGS = 4, ROUND = 16 };
    const double radius = 0.4;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'>" PP_TEST_BOX
                "<window wall='south' left='0.3' sill='0.9' width='2.5' "
                "height='1.4'/><point x='1.1' y='0.9'/></room>");
    struct pp_receiver on[RINGS * ROUND];
    for (int i = 0; i < RINGS * ROUND; i++) {
        double r = radius * sqrt((i / ROUND + 0.5) / RINGS);
        double turn = 2.0 * PP_PI * (i % ROUND + 0.3) / ROUND;
        on[i] = world->receivers[0];
        on[i].position.x += r * cos(turn);
        on[i].position.y += r * sin(turn);
    }
    struct pp_photons_options options = photons_of(64);
    struct pp_reading(*points)[4] =
        pp_test_photons(world, &light, on, RINGS * ROUND, &options, NULL);
    options = photons_of(4096);
    options.sensor_m = radius;
    struct pp_reading(*disc)[4] =
        pp_test_photons(world, &light, world->receivers, 1, &options, NULL);
    for (int k = PP_SC; k <= PP_IRC; k++) {
        double mean = 0.0, variance = 0.0;
        for (int i = 0; i < RINGS * ROUND; i++) {
            mean += points[i][k].value / (RINGS * ROUND);
            variance += pow(points[i][k].std_error / (RINGS * ROUND), 2.0);
        }
        double noise = hypot(disc[0][k].std_error, sqrt(variance));
        assert_near(disc[0][k].value, mean, 4.0 * noise + 0.002 * mean);
        assert_true(disc[0][k].std_error < 0.05 * mean + 1e-4);
    }
    free(points);
    free(disc);
    pp_world_destroy(world);
}

static void a_sensor_of_negative_size_is_refused(void **state)
{
    (void)state;
    const struct pp_world world = {0};
    struct pp_outside_light light = {.sky = pp_sky_overcast(),
                                     .ground_reflectance = 0.3};
    struct pp_light_scene *scene = pp_test_matt_scene(&world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    struct pp_photons_options options = photons_of(8);
    struct pp_photons *photons;
    struct pp_error err = {0};
    options.sensor_m = -0.1;
    assert_int_equal(
        pp_photons_create(&photons, scene, environment, NULL, 0, &options, &err),
        PP_BAD_INPUT);
    assert_string_equal(err.message, "the sensor radius is -0.1 m; expected 0 or more");
    assert_null(photons);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
}

/* ---- compared with the path tracer ---- */

/* Each room contains one feature that the two engines could treat differently. */
static void photons_and_paths_agree(void **state)
{
    (void)state;
    static const char *const rooms[] = {
        /* a light well in front of the window, with a bright block */
        PP_TEST_BOX
        "<window wall='south' left='0.3' sill='0.7' width='2.2' height='1.5'/>"
        "<block x='-1' y='-3.2' width='6' depth='1' height='7' reflectance='0.7'/>",
        /* near and distant skylines, a frame and dirt */
        PP_TEST_BOX
        "<window wall='south' left='0.3' sill='0.7' width='2.2' height='1.5' "
        "frame-factor='0.7' maintenance='0.8'/>"
        "<window wall='west' left='0.4' sill='0.2' width='1.2' height='2.1'/>"
        "<skyline wall='south' angle='32' distance='7'/>"
        "<skyline wall='west' angle='25'/>",
        /* a high shelf, and the bright part of the sky in front of the window */
        PP_TEST_BOX
        "<sky type='iso-12' sun-altitude='35' sun-bearing='160'/>"
        "<window wall='south' left='0.3' sill='0.7' width='2.2' height='1.5'/>"
        "<surface reflectance='0.8'><vertex x='0.3' y='0.2' z='1.9'/>"
        "<vertex x='2.4' y='0.2' z='1.9'/><vertex x='2.4' y='0.9' z='1.9'/>"
        "<vertex x='0.3' y='0.9' z='1.9'/></surface>",
    };
    double squares = 0.0;
    int count = 0;
    for (size_t i = 0; i < sizeof rooms / sizeof *rooms; i++) {
        char xml[2000];
        snprintf(xml, sizeof xml, "<room version='1'>%s" PP_TEST_BOX_POINTS "</room>",
                 rooms[i]);
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, xml);
        struct pp_photons_options options = {
            .error = 0.02, .seed = 5, .threads = 1, .average = true};
        struct pp_tracer_options paths = {
            .error = 0.02, .seed = 6, .threads = 1, .average = true};
        int points = world->receiver_count;
        struct pp_reading(*found)[4] =
            pp_test_photons(world, &light, world->receivers, points, &options, NULL);
        struct pp_reading(*traced)[4] =
            pp_test_trace(world, &light, world->receivers, points, &paths, NULL);
        for (int k = 0; k <= points; k++)
            for (int c = PP_SC; c <= PP_IRC; c++) {
                double noise = hypot(found[k][c].std_error, traced[k][c].std_error);
                double z = (found[k][c].value - traced[k][c].value) / (noise + 1e-9);
                assert_near(z, 0.0, 4.0);
                squares += z * z;
                count++;
            }
        free(found);
        free(traced);
        pp_world_destroy(world);
    }
    /* The mean of 45 squares is 1 +- 0.21; some values are zero. */
    assert_true(squares / count < 1.0 + 4.0 * sqrt(2.0 / count));
}

/* ---- identical results ---- */

static void threads_do_not_change_a_bit(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_random_room(&light, 77, 5);
    struct pp_photons_options options = {.error = 0.05, .seed = 9, .average = true};
    struct pp_reading(*first)[4] = NULL;
    for (int threads = 1; threads <= 3; threads++) {
        options.threads = threads;
        struct pp_reading(*found)[4] =
            pp_test_photons(world, &light, world->receivers, 5, &options, NULL);
        for (int i = 0; first && i < 6; i++)
            for (int k = 0; k < PP_COMPONENT_COUNT; k++) {
                assert_true(found[i][k].value == first[i][k].value);
                assert_true(found[i][k].std_error == first[i][k].std_error);
            }
        if (first)
            free(found);
        else
            first = found;
    }
    free(first);
    pp_world_destroy(world);
}

/* All receivers use the same photons. */
static void receivers_do_not_change_each_other(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_random_room(&light, 78, 6);
    struct pp_photons_options options = {.error = 0.05, .seed = 9, .threads = 1};
    struct pp_reading(*all)[4] =
        pp_test_photons(world, &light, world->receivers, 6, &options, NULL);
    struct pp_reading(*alone)[4] =
        pp_test_photons(world, &light, &world->receivers[3], 1, &options, NULL);
    for (int k = 0; k < PP_COMPONENT_COUNT; k++) {
        assert_true(alone[0][k].value == all[3][k].value);
        assert_true(alone[0][k].std_error == all[3][k].std_error);
    }
    free(all);
    free(alone);
    pp_world_destroy(world);
}

/* Deep in a room neighbouring receivers use the same photons, so much of their variance
 * is common. Sensors have their own photons. */
static void receivers_deep_in_a_room_go_wrong_together(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='3.1' depth='9' height='2.6'/>"
                "<window wall='south' left='0.4' sill='0.9' width='2.2' "
                "height='1.4'/></room>");
    struct pp_receiver receivers[12];
    for (int i = 0; i < 12; i++)
        receivers[i] = pp_test_receiver(1.1 + 0.1 * i, 7.7, 0.85, 0.0, 0.0, 1.0);
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    for (int counted = 0; counted < 2; counted++) {
        struct pp_photons_options options = photons_of(64);
        struct pp_photons *photons;
        options.sensor_m = counted ? 0.05 : 0.0;
        assert_int_equal(pp_photons_create(&photons, scene, environment, receivers, 12,
                                           &options, NULL),
                         PP_OK);
        while (!pp_photons_done(photons))
            assert_int_equal(pp_photons_advance(photons, 1.0, NULL), PP_OK);
        double common = pp_photons_common(photons);
        double near = pp_photons_common_near(photons);
        assert_near(near, common, 0.01); /* the dozen points are all points */
        assert_true(counted ? common == 0.0 : common > 0.2 && common <= 1.0);
        pp_photons_destroy(photons);
    }
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_closed_room_is_dark_for_certain),
        cmocka_unit_test(the_open_sky_is_all_there_is_without_a_room),
        cmocka_unit_test(a_furnace_glows_with_one_over_one_less_rho),
        cmocka_unit_test(two_plates_light_each_other_by_a_geometric_series),
        cmocka_unit_test(equilibrium_with_glass_on_two_sides_and_above),
        cmocka_unit_test(equilibrium_with_deep_reveals),
        cmocka_unit_test(equilibrium_in_an_l_shaped_room_with_blocks_outside),
        cmocka_unit_test(equilibrium_behind_a_diffusing_pane),
        cmocka_unit_test(openings_show_the_sky_of_quadrature),
        cmocka_unit_test(at_the_window_half_the_view_is_sky),
        cmocka_unit_test(through_three_windows_one_sees_the_sky_once),
        cmocka_unit_test(a_disc_counts_the_mean_over_it),
        cmocka_unit_test(a_sensor_of_negative_size_is_refused),
        cmocka_unit_test(photons_and_paths_agree),
        cmocka_unit_test(threads_do_not_change_a_bit),
        cmocka_unit_test(receivers_do_not_change_each_other),
        cmocka_unit_test(receivers_deep_in_a_room_go_wrong_together),
    };
    add_tests(tests, NULL, NULL);
}
