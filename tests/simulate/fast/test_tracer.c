/* test_tracer.c - simulated light compared with known values. */
#include "methods/exact/solid_angle.h"

#include "tests/lib/equilibrium.h"
#include "tests/lib/room_of.h"
#include "tests/lib/sized.h"
#include "tests/lib/traced.h"
#include "model/room/position.h"

static const struct pp_vec3 zenith = {0.0, 0.0, 1.0};

/* One receiver, all components. */
static void trace_one(const struct pp_world *world,
                      const struct pp_outside_light *light, struct pp_receiver receiver,
                      long samples, struct pp_reading readings[4])
{
    struct pp_tracer_options options = pp_test_paths(samples);
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, light, &receiver, 1, &options, NULL);
    memcpy(readings, traced[0], sizeof traced[0]);
    free(traced);
}

/* Moments of a polygon seen from a receiver, clipped to up to two more half-spaces. */
static struct pp_moments moments_of(const struct pp_vec3 *corners, int count,
                                    struct pp_receiver receiver,
                                    const struct pp_vec3 *more, int more_count)
{
    struct pp_vec3 seen[8], half_spaces[4] = {receiver.normal};
    struct pp_moments moments = {0.0, 0.0, 0.0};
    for (int i = 0; i < count; i++)
        seen[i] = pp_vec_sub(corners[i], receiver.position);
    for (int i = 0; i < more_count; i++)
        half_spaces[1 + i] = more[i];
    pp_solid_angle_add_moments(&moments, seen, count, receiver.normal, half_spaces,
                               1 + more_count);
    /* The corners may be in either order. */
    double sign = moments.omega < 0.0 ? -1.0 : 1.0;
    return (struct pp_moments){sign * moments.omega, sign * moments.cosine,
                               sign * moments.cosine_sine};
}

static double sky_of(const struct pp_outside_light *light,
                     const struct pp_vec3 *corners, int count,
                     struct pp_receiver receiver)
{
    struct pp_moments moments = moments_of(corners, count, receiver, &zenith, 1);
    return pp_solid_angle_sky_component(&moments, &light->sky);
}

/* ---- limits ---- */

static void a_closed_room_is_dark_for_certain(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/>"
                "<point x='1.2' y='2.3'/></room>");
    struct pp_tracer_options options = {.error = 0.01, .seed = 1, .average = true};
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, &light, world->receivers, 1, &options, NULL);
    for (int point = 0; point < 2; point++)
        for (int i = 0; i < PP_COMPONENT_COUNT; i++) {
            assert_near(traced[point][i].value, 0.0, 0.0);
            assert_near(traced[point][i].std_error, 0.0, 0.0);
        }
    free(traced);
    pp_world_destroy(world);
}

/* Without objects a plane at any tilt receives the illuminance of the sky, and light
 * from the ground. */
static void the_open_sky_is_all_there_is_without_a_room(void **state)
{
    (void)state;
    const struct pp_world world = {0};
    struct pp_outside_light light = {.sky = pp_sky_overcast(),
                                     .ground_reflectance = 0.3};
    struct pp_reading readings[4];
    trace_one(&world, &light, pp_test_receiver(1.0, 2.0, 3.0, 0.0, 0.0, 1.0), 256,
              readings);
    assert_traced(readings[PP_SC], 1.0, 1e-3);
    assert_near(readings[PP_ERC].value, 0.0, 0.0);
    trace_one(&world, &light, pp_test_receiver(1.0, 2.0, 3.0, 0.3, -0.4, 0.0), 256,
              readings);
    assert_traced(readings[PP_SC], 0.396177, 2e-3);
    assert_traced(readings[PP_ERC], 0.15, 2e-3);
    light.sky = pp_sky_uniform();
    trace_one(&world, &light, pp_test_receiver(0.0, 0.0, 0.0, 1.0, 0.0, 1.0), 256,
              readings);
    assert_traced(readings[PP_SC], (1.0 + sqrt(0.5)) / 2.0, 2e-3);
}

/* Every surface emits 1 and reflects rho of the light it receives: 1 + rho + rho^2 +
 * ... */
static void a_furnace_glows_with_one_over_one_less_rho(void **state)
{
    (void)state;
    const double reflectances[] = {0.0, 0.2, 0.5, 0.8, 0.9};
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/></room>");
    struct pp_receiver receiver = pp_test_receiver(1.2, 2.3, 0.7, 0.2, 0.3, 1.0);
    for (size_t i = 0; i < sizeof reflectances / sizeof *reflectances; i++) {
        for (int k = 0; k < world->surface_count; k++) {
            world->surfaces[k].exitance = 1.0;
            world->surfaces[k].front = reflectances[i];
        }
        struct pp_reading readings[4];
        trace_one(world, &light, receiver, 8, readings);
        double expected = 1.0 / (1.0 - reflectances[i]);
        assert_traced(readings[PP_IRC], expected, 0.005 * expected);
        assert_relative(readings[PP_IRC].value, expected, 0.01);
    }
    pp_world_destroy(world);
}

/* ---- thermal equilibrium ---- */

/* Every receiver of a room in equilibrium (equilibrium.h) has the value 1. */
static void assert_equilibrium(const char *xml, bool lossless_glass)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_equilibrium(&light, xml, lossless_glass);
    struct pp_tracer_options options = pp_test_paths(64);
    struct pp_tracer_work work;
    options.average = world->plane.count > 0;
    int count = world->receiver_count;
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, &light, world->receivers, count, &options, &work);
    for (int i = 0; i < count + options.average; i++)
        assert_traced(traced[i][PP_DF], 1.0, 0.01);
    assert_true(work.leaks <= work.rays / 1000000);
    free(traced);
    pp_world_destroy(world);
}

static void equilibrium_with_an_unglazed_window(void **state)
{
    (void)state;
    assert_equilibrium("<room version='1'>" PP_TEST_BOX
                       "<window wall='south' left='0.3' sill='0.7' width='2.2' "
                       "height='1.5' glazing='none'/>" PP_TEST_BOX_POINTS "</room>",
                       false);
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

/* There, single-precision coordinates have steps of a sixteenth of a millimetre. */
static void equilibrium_a_kilometre_away_from_the_origin(void **state)
{
    (void)state;
    assert_equilibrium(
        "<room version='1'><plan height='2.6'><vertex x='1000.1' y='-1000.7'/>"
        "<vertex x='1003.2' y='-1000.7'/><vertex x='1003.2' y='-996.4'/>"
        "<vertex x='1000.1' y='-996.4'/></plan>"
        "<window wall='2' left='0.3' sill='0.7' width='2.2' height='1.5'/>"
        "<point x='1001.3' y='-998.2'/></room>",
        true);
}

/* ---- sky component ---- */

#define WINDOW                                                                         \
    "<window wall='south' left='0.2' sill='0.9' width='2.6' height='1.4' glazing="

static const struct pp_vec3 window[4] = {
    {0.2, 0.0, 0.9}, {2.8, 0.0, 0.9}, {2.8, 0.0, 2.3}, {0.2, 0.0, 2.3}};

static void a_window_shows_the_sky_of_the_closed_form(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/>"
                "" WINDOW "'none'/></room>");
    struct pp_receiver receiver = pp_test_receiver(1.1, 2.0, 0.8, 0.0, 0.0, 1.0);
    struct pp_reading readings[4];
    trace_one(world, &light, receiver, 64, readings);
    assert_traced(readings[PP_SC], 0.04486082291318, 2e-5);
    assert_near(readings[PP_ERC].value, 0.0, 0.0);
    assert_near(readings[PP_ERC].std_error, 0.0, 0.0);
    light.sky = pp_sky_uniform();
    trace_one(world, &light, receiver, 64, readings);
    assert_traced(readings[PP_SC], 0.05899459937149, 2e-5);
    /* Facing the window, part of which is behind the receiver's plane. */
    light.sky = pp_sky_overcast();
    receiver = pp_test_receiver(0.4, 0.6, 1.4, 0.8, -0.5, -0.2);
    trace_one(world, &light, receiver, 256, readings);
    assert_traced(readings[PP_SC], sky_of(&light, window, 4, receiver), 2e-4);
    pp_world_destroy(world);
}

/* Receivers on the floor, two walls and the ceiling: no ray is lost in or behind them,
 * and the value is the same as just in front of them. The ceiling sees no sky. */
static void on_a_surface_one_measures_what_falls_on_it(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/>"
                "" WINDOW "'none'/></room>");
    static const struct pp_receiver on[] = {
        {{1.1, 2.0, 0.0}, {0.0, 0.0, 1.0}, 0, 0.0},
        {{0.0, 1.7, 1.3}, {1.0, 0.0, 0.0}, 0, 0.0},
        {{1.3, 4.3, 0.6}, {0.0, -1.0, 0.0}, 0, 0.0},
        {{1.1, 2.0, 2.6}, {0.0, 0.0, -1.0}, 0, 0.0},
    };
    for (size_t i = 0; i < sizeof on / sizeof *on; i++) {
        assert_null(pp_position_receiver_fault(world, on[i].position, on[i].normal));
        struct pp_receiver off = on[i];
        off.position = pp_vec_along(off.position, 2e-3, off.normal);
        struct pp_reading here[4], there[4];
        trace_one(world, &light, on[i], 256, here);
        trace_one(world, &light, off, 256, there);
        assert_traced(here[PP_SC], sky_of(&light, window, 4, on[i]), 2e-4);
        /* Two millimetres are a thousandth of the distances in this room. */
        double noise = hypot(here[PP_DF].std_error, there[PP_DF].std_error);
        assert_near(here[PP_DF].value, there[PP_DF].value,
                    4.0 * noise + 3e-3 * there[PP_DF].value);
        assert_true(here[PP_IRC].value > 1e-3);
    }
    pp_world_destroy(world);
}

static void glass_takes_its_share_by_angle(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/>"
                "" WINDOW "'clear-single' frame-factor='0.8' "
                "maintenance='0.9'/></room>");
    struct pp_receiver receiver = pp_test_receiver(0.6, 1.3, 0.8, 0.0, 0.0, 1.0);
    /* Midpoint rule with a relative error of about 1e-6. */
    double sum = 0.0;
    enum { N = 400 };
    for (int i = 0; i < N; i++)
        for (int k = 0; k < N; k++) {
            struct pp_vec3 v = pp_vec_sub(
                pp_vec(0.2 + 2.6 * (i + 0.5) / N, 0.0, 0.9 + 1.4 * (k + 0.5) / N),
                receiver.position);
            double r = pp_vec_length(v);
            struct pp_vec3 u = pp_vec_scale(v, 1.0 / r);
            sum += pp_sky_luminance(&light.sky, u) * u.z * -u.y / (r * r)
                   * pp_glass_transmittance(&world->openings[0].glass, -u.y);
        }
    struct pp_reading readings[4];
    trace_one(world, &light, receiver, 64, readings);
    assert_traced(readings[PP_SC], sum * 2.6 * 1.4 / (N * N) * 0.8 * 0.9, 5e-5);
    pp_world_destroy(world);
}

/* A diffusing pane emits tau times its illuminance, from the sky and from the ground
 * separately. */
static void a_diffusing_pane_is_a_lamp(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><site ground-reflectance='0.3' ground='open'/>"
                "<plan width='3.1' depth='4.3' height='2.6'/>"
                "<window wall='south' left='0.2' sill='0.9' width='2.6' "
                "height='1.4' transmittance='0.6' diffusing='yes'/></room>");
    struct pp_receiver receiver = pp_test_receiver(0.6, 1.3, 0.8, 0.0, 0.0, 1.0);
    struct pp_moments moments = moments_of(window, 4, receiver, NULL, 0);
    struct pp_reading readings[4];
    trace_one(world, &light, receiver, 256, readings);
    double factor = 0.6 * moments.cosine / PP_PI;
    assert_traced(readings[PP_SC], 0.39617691 * factor, 1e-3 * factor);
    assert_traced(readings[PP_ERC], 0.15 * factor, 1e-3 * factor);
    pp_world_destroy(world);
}

/* The glass is 0.4 m outside the plane of the wall: seen from the point, the outline of
 * the opening in the wall is projected onto the glass. */
static void a_reveal_hides_the_edges_of_the_glass(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/>"
                "" WINDOW "'none' reveal='0.4'/></room>");
    struct pp_receiver receiver = pp_test_receiver(0.5, 1.0, 0.8, 0.0, 0.0, 1.0);
    double s = 1.4; /* (1.0 + 0.4)/1.0 */
    double left = fmax(0.2, 0.5 + s * (0.2 - 0.5));
    double right = fmin(2.8, 0.5 + s * (2.8 - 0.5));
    double low = fmax(0.9, 0.8 + s * (0.9 - 0.8));
    double high = fmin(2.3, 0.8 + s * (2.3 - 0.8));
    struct pp_vec3 seen[4] = {
        {left, -0.4, low}, {right, -0.4, low}, {right, -0.4, high}, {left, -0.4, high}};
    struct pp_reading readings[4];
    trace_one(world, &light, receiver, 512, readings);
    assert_traced(readings[PP_SC], sky_of(&light, seen, 4, receiver), 2e-4);
    pp_world_destroy(world);
}

/* With the same paths and seed: a façade in the plane of the glass leaves the identical
 * sky component; a façade 0.25 m farther out leaves the same as a reveal deeper by 0.25
 * m. */
static void a_facade_hides_what_a_deeper_reveal_does(void **state)
{
    (void)state;
    static const char *const parts[4] = {
        "reveal='0.2'/>",
        "reveal='0.2'/><facade wall='south' left='4' right='3' up='5'/>",
        "reveal='0.45'/>",
        "reveal='0.2'/><facade wall='south' left='4' right='3' up='5' depth='0.45'/>"};
    struct pp_reading readings[4][4];
    for (int i = 0; i < 4; i++) {
        char xml[1000];
        snprintf(xml, sizeof xml,
                 "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/>" WINDOW
                 "'none' %s</room>",
                 parts[i]);
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, xml);
        trace_one(world, &light, pp_test_receiver(0.5, 1.0, 0.8, 0.0, 0.0, 1.0),
                  PP_SIZED(2048, 1024, 256), readings[i]);
        pp_world_destroy(world);
    }
    assert_near(readings[1][PP_SC].value, readings[0][PP_SC].value, 0.0);
    assert_near(readings[1][PP_ERC].value, readings[0][PP_ERC].value, 0.0);
    double noise =
        hypot(readings[2][PP_SC].std_error, readings[3][PP_SC].std_error) + 1e-5;
    assert_near(readings[3][PP_SC].value, readings[2][PP_SC].value, 4.0 * noise);
    assert_true(readings[3][PP_SC].value < readings[0][PP_SC].value - 20.0 * noise);
    /* The edges of the reveal hide sky, and the façade is visible instead. */
    assert_true(readings[3][PP_ERC].value > 1.2 * readings[2][PP_ERC].value);
}

/* A street 7 m wide and 12 m high: its own side as a façade, as three blocks flush with
 * the wall, and black. The house opposite receives the light that its own side
 * reflects. */
static void a_facade_lights_the_street_as_houses_in_its_plane_do(void **state)
{
    (void)state;
    static const char *const sides[3] = {
        "<facade wall='south' left='40' right='40' up='9.4' reflectance='0.2'/>",
        "<block x='-40' y='0' width='40' depth='9' height='12'/>"
        "<block x='3.1' y='0' width='40' depth='9' height='12'/>"
        "<block x='-40' y='0' width='83.1' depth='9' base='2.6' height='9.4'/>",
        "<facade wall='south' left='40' right='40' up='9.4' reflectance='0'/>"};
    struct pp_reading readings[3][4];
    for (int i = 0; i < 3; i++) {
        char xml[1000];
        snprintf(xml, sizeof xml,
                 "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/>" WINDOW
                 "'none'/><block x='-40' y='-15' width='83' depth='8' height='12' "
                 "reflectance='0.8'/>%s</room>",
                 sides[i]);
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, xml);
        trace_one(world, &light, pp_test_receiver(0.5, 1.0, 0.8, 0.0, 0.0, 1.0),
                  PP_SIZED(4096, 1024, 512), readings[i]);
        pp_world_destroy(world);
    }
    double noise = hypot(readings[0][PP_ERC].std_error, readings[1][PP_ERC].std_error);
    assert_true(noise < PP_SIZED(0.02, 0.04, 0.05) * readings[0][PP_ERC].value);
    assert_near(readings[0][PP_SC].value, readings[1][PP_SC].value, 0.0);
    assert_near(readings[0][PP_ERC].value, readings[1][PP_ERC].value, 4.0 * noise);
    assert_true(readings[2][PP_ERC].value < 0.95 * readings[0][PP_ERC].value);
}

static void walls_of_an_l_shaped_room_hide_the_window(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan height='2.6'><vertex x='0' y='0'/>"
                "<vertex x='5' y='0'/><vertex x='5' y='2'/><vertex x='2' y='2'/>"
                "<vertex x='2' y='6'/><vertex x='0' y='6'/></plan>"
                "<window wall='2' left='0.2' sill='0.9' width='1.6' "
                "height='1.4' glazing='none'/></room>");
    /* From (1.5, 3) the corner (2, 2) hides the window in x = 5 completely; from (1,
     * 2.5) the part below y = 2 - 3/2 = 0.5 is visible. */
    struct pp_reading readings[4];
    trace_one(world, &light, pp_test_receiver(1.5, 3.0, 0.8, 0.0, 0.0, 1.0), 64,
              readings);
    assert_near(readings[PP_SC].value, 0.0, 0.0);
    assert_true(readings[PP_IRC].value > 1e-4);
    struct pp_receiver receiver = pp_test_receiver(1.0, 2.5, 0.8, 0.0, 0.0, 1.0);
    struct pp_vec3 seen[4] = {
        {5.0, 0.2, 0.9}, {5.0, 0.5, 0.9}, {5.0, 0.5, 2.3}, {5.0, 0.2, 2.3}};
    trace_one(world, &light, receiver, 1024, readings);
    assert_traced(readings[PP_SC], sky_of(&light, seen, 4, receiver), 1e-4);
    pp_world_destroy(world);
}

static void a_rooflight_shows_the_zenith(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world =
        pp_test_lit_world(&light, "<room version='1'>" PP_TEST_BOX
                                  "<rooflight x='0.6' y='1.9' width='1.1' depth='1.3' "
                                  "glazing='none'/></room>");
    struct pp_vec3 seen[4] = {
        {0.6, 1.9, 2.6}, {1.7, 1.9, 2.6}, {1.7, 3.2, 2.6}, {0.6, 3.2, 2.6}};
    struct pp_receiver receiver = pp_test_receiver(1.2, 2.0, 0.85, 0.0, 0.0, 1.0);
    struct pp_reading readings[4];
    trace_one(world, &light, receiver, 64, readings);
    assert_traced(readings[PP_SC], sky_of(&light, seen, 4, receiver), 1e-4);
    pp_world_destroy(world);
}

static void a_sloping_pentagon_shows_the_sky_behind_it(void **state)
{
    (void)state;
    /* The roof falls from z = 4 at y = 0 to z = 2.5 at y = 3: z = 4 - y/2. */
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version='1'><envelope>"
        "<face role='floor' name='f'><vertex x='0' y='0' z='0'/>"
        "<vertex x='4' y='0' z='0'/><vertex x='4' y='3' z='0'/>"
        "<vertex x='0' y='3' z='0'/></face>"
        "<face role='ceiling' name='r'><vertex x='0' y='0' z='4'/>"
        "<vertex x='0' y='3' z='2.5'/><vertex x='4' y='3' z='2.5'/>"
        "<vertex x='4' y='0' z='4'/></face>"
        "<face role='wall' name='s'><vertex x='0' y='0' z='0'/>"
        "<vertex x='0' y='0' z='4'/><vertex x='4' y='0' z='4'/>"
        "<vertex x='4' y='0' z='0'/></face>"
        "<face role='wall' name='n'><vertex x='0' y='3' z='0'/>"
        "<vertex x='4' y='3' z='0'/><vertex x='4' y='3' z='2.5'/>"
        "<vertex x='0' y='3' z='2.5'/></face>"
        "<face role='wall' name='w'><vertex x='0' y='0' z='0'/>"
        "<vertex x='0' y='3' z='0'/><vertex x='0' y='3' z='2.5'/>"
        "<vertex x='0' y='0' z='4'/></face>"
        "<face role='wall' name='e'><vertex x='4' y='0' z='0'/>"
        "<vertex x='4' y='0' z='4'/><vertex x='4' y='3' z='2.5'/>"
        "<vertex x='4' y='3' z='0'/></face></envelope>"
        "<opening glazing='none'><vertex x='1' y='0.6' z='3.7'/>"
        "<vertex x='0.7' y='1.4' z='3.3'/><vertex x='1.5' y='2.4' z='2.8'/>"
        "<vertex x='2.7' y='1.8' z='3.1'/><vertex x='2.4' y='0.8' z='3.6'/></opening>"
        "</room>");
    struct pp_vec3 seen[5] = {{1.0, 0.6, 3.7},
                              {0.7, 1.4, 3.3},
                              {1.5, 2.4, 2.8},
                              {2.7, 1.8, 3.1},
                              {2.4, 0.8, 3.6}};
    struct pp_receiver receivers[2] = {pp_test_receiver(1.9, 1.2, 0.85, 0, 0, 1),
                                       pp_test_receiver(3.4, 0.3, 1.7, -1, 0.2, 0.1)};
    for (int i = 0; i < 2; i++) {
        struct pp_reading readings[4];
        trace_one(world, &light, receivers[i], 64, readings);
        assert_traced(readings[PP_SC], sky_of(&light, seen, 5, receivers[i]), 2e-4);
    }
    pp_world_destroy(world);
}

/* ---- obstructions ---- */

/* Visible sky and hidden part of WINDOW if everything below a slope towards the window
 * is hidden. */
static void split_window(const struct pp_outside_light *light,
                         struct pp_receiver receiver, double slope, double *sky,
                         double *hidden)
{
    struct pp_vec3 above[2] = {{0.0, slope, 1.0}, {0.0, 0.0, 1.0}};
    struct pp_vec3 below[2] = {{0.0, -slope, -1.0}, {0.0, 0.0, 1.0}};
    struct pp_moments seen = moments_of(window, 4, receiver, above, 2);
    struct pp_moments mask = moments_of(window, 4, receiver, below, 2);
    *sky = pp_solid_angle_sky_component(&seen, &light->sky);
    *hidden = mask.cosine / PP_PI;
}

/* The face of a skyline receives 0.396 from the sky and half of the ground's 0.2. */
static void a_far_skyline_gives_what_its_face_gets(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/>" WINDOW
                "'none'/><skyline wall='south' angle='10' reflectance='0.2'/></room>");
    struct pp_receiver receiver = pp_test_receiver(1.1, 2.0, 0.8, 0.0, 0.0, 1.0);
    double sky, hidden, exitance = 0.2 * (0.39617691 + 0.1);
    split_window(&light, receiver, tan(10.0 * PP_RAD), &sky, &hidden);
    struct pp_reading readings[4];
    trace_one(world, &light, receiver, 512, readings);
    assert_traced(readings[PP_SC], sky, 1e-4);
    assert_traced(readings[PP_ERC], exitance * hidden, 1e-4);
    /* Relative to the luminance of the hidden sky: about 0.19 by convention. */
    struct pp_vec3 below[2] = {{0.0, -tan(10.0 * PP_RAD), -1.0}, {0.0, 0.0, 1.0}};
    struct pp_moments mask = moments_of(window, 4, receiver, below, 2);
    assert_near(exitance * hidden / pp_solid_angle_sky_component(&mask, &light.sky),
                0.19, 0.005);
    pp_world_destroy(world);
}

static void a_near_skyline_hides_more_from_the_front_of_the_room(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/>" WINDOW
                "'none'/><skyline wall='south' angle='20' distance='9' "
                "reflectance='0.2'/></room>");
    /* Height of the skyline, which is 9 m away; its angle is measured at the middle of
     * the window, 1.6 m up. */
    double head = 1.6 + 9.0 * tan(20.0 * PP_RAD);
    for (int i = 0; i < 2; i++) {
        double y = i == 0 ? 0.6 : 3.5, sky, hidden;
        struct pp_receiver receiver = pp_test_receiver(1.1, y, 0.8, 0.0, 0.0, 1.0);
        split_window(&light, receiver, (head - 0.8) / (9.0 + y), &sky, &hidden);
        struct pp_reading readings[4];
        trace_one(world, &light, receiver, 512, readings);
        assert_traced(readings[PP_SC], sky, 2e-4);
        /* The visible point of the face receives light from the whole sky, 0.396, and
         * almost none from the room. From the ground, of which it hides half of the sky
         * at its foot, it receives 0.061 to 0.1. */
        assert_true(readings[PP_ERC].value < 0.2 * (0.39617691 + 0.1) * hidden + 1e-4);
        assert_true(readings[PP_ERC].value > 0.2 * (0.39617691 + 0.05) * hidden - 1e-4);
    }
    pp_world_destroy(world);
}

/* A black block so long that its ends do not matter: only the hidden light is
 * missing. */
static void a_black_block_hides_the_sky_behind_it(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><site ground-reflectance='0'/>"
                "<plan width='3.1' depth='4.3' height='2.6'/>" WINDOW
                "'none'/><block x='-4000' y='-14' width='8000' depth='6' height='4' "
                "reflectance='0'/></room>");
    struct pp_receiver receiver = pp_test_receiver(1.1, 1.3, 0.8, 0.0, 0.0, 1.0);
    double sky, hidden;
    split_window(&light, receiver, (4.0 - 0.8) / (8.0 + 1.3), &sky, &hidden);
    struct pp_reading readings[4];
    trace_one(world, &light, receiver, 512, readings);
    assert_traced(readings[PP_SC], sky, 1e-4);
    assert_near(readings[PP_ERC].value, 0.0, 0.0);
    pp_world_destroy(world);
}

/* Most of the light at the back comes from the block via window and floor. Decreasing
 * weights along the path must not make a few paths dominate. 2,048 paths give an error
 * of 3.3 % (RMS of 12 seeds, 2.3 to 5.5 %); Russian roulette by unmodified weights gave
 * 17 %. */
static void light_by_way_of_a_block_is_not_a_lottery(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='3' depth='9' height='2.7'/>"
                "<window wall='south' left='0.2' sill='0.8' width='2.6' height='1.5'/>"
                "<block x='-28.5' y='-18' width='60' depth='8' height='9.5'/></room>");
    struct pp_reading readings[4];
    trace_one(world, &light, pp_test_receiver(1.5, 8.0, 0.85, 0.0, 0.0, 1.0), 64,
              readings);
    assert_true(readings[PP_DF].std_error < 0.06 * readings[PP_DF].value);
    assert_true(readings[PP_ERC].std_error < 0.01 * readings[PP_ERC].value);
    pp_world_destroy(world);
}

/* CIE 171 case 5.6: a horizontal reflector under the open sky contributes rho times its
 * configuration factor [CIE171]. */
static void a_horizontal_reflector_lights_what_faces_it(void **state)
{
    (void)state;
    struct pp_vec3 corners[4] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    struct pp_surface plate = {.outline = {4, corners, {0, 0, 1}, 16.0},
                               .role = PP_FREE_SURFACE,
                               .front = 0.3,
                               .back = 0.3,
                               .owner = -1};
    struct pp_world world = {.surfaces = &plate, .surface_count = 1};
    const struct pp_outside_light light = {.sky = pp_sky_overcast()};
    const double percent[4] = {26.80, 30.94, 33.98, 35.57};
    for (int i = 0; i < 4; i++) {
        struct pp_reading readings[4];
        trace_one(&world, &light, pp_test_receiver(2.0, 0.25 + 0.5 * i, 3.0, 0, 0, -1),
                  256, readings);
        assert_near(readings[PP_ERC].value, 0.3 * percent[i] / 100.0, 2e-3);
        assert_traced(readings[PP_ERC], 0.3 * percent[i] / 100.0, 1e-3);
        assert_near(readings[PP_SC].value, 0.0, 0.0);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_closed_room_is_dark_for_certain),
        cmocka_unit_test(the_open_sky_is_all_there_is_without_a_room),
        cmocka_unit_test(a_furnace_glows_with_one_over_one_less_rho),
        cmocka_unit_test(equilibrium_with_an_unglazed_window),
        cmocka_unit_test(equilibrium_with_glass_on_two_sides_and_above),
        cmocka_unit_test(equilibrium_with_deep_reveals),
        cmocka_unit_test(equilibrium_in_an_l_shaped_room_with_blocks_outside),
        cmocka_unit_test(equilibrium_behind_a_diffusing_pane),
        cmocka_unit_test(equilibrium_a_kilometre_away_from_the_origin),
        cmocka_unit_test(a_window_shows_the_sky_of_the_closed_form),
        cmocka_unit_test(on_a_surface_one_measures_what_falls_on_it),
        cmocka_unit_test(glass_takes_its_share_by_angle),
        cmocka_unit_test(a_diffusing_pane_is_a_lamp),
        cmocka_unit_test(a_reveal_hides_the_edges_of_the_glass),
        cmocka_unit_test(a_facade_hides_what_a_deeper_reveal_does),
        cmocka_unit_test(a_facade_lights_the_street_as_houses_in_its_plane_do),
        cmocka_unit_test(walls_of_an_l_shaped_room_hide_the_window),
        cmocka_unit_test(a_rooflight_shows_the_zenith),
        cmocka_unit_test(a_sloping_pentagon_shows_the_sky_behind_it),
        cmocka_unit_test(a_far_skyline_gives_what_its_face_gets),
        cmocka_unit_test(a_near_skyline_hides_more_from_the_front_of_the_room),
        cmocka_unit_test(a_black_block_hides_the_sky_behind_it),
        cmocka_unit_test(light_by_way_of_a_block_is_not_a_lottery),
        cmocka_unit_test(a_horizontal_reflector_lights_what_faces_it),
    };
    add_tests(tests, NULL, NULL);
}
