/* test_exact.c - the direct component of rooms: limits and values by closed form. */
#include "tests/lib/near.h"

#include "methods/method.h"
#include "methods/exact/exterior.h"
#include "tests/lib/room_of.h"

static struct pp_part at(const struct pp_world *world,
                         const struct pp_outside_light *light, struct pp_vec3 position,
                         struct pp_vec3 normal)
{
    struct pp_receiver receiver = {position, pp_vec_unit(normal), 0, 0.0};
    struct pp_part sum = {0};
    for (int i = 0; i < world->opening_count; i++) {
        struct pp_part part = {0};
        struct pp_error err = {0};
        if (pp_method_exact.evaluate(world, light, &world->openings[i], &receiver, NULL,
                                     &part, &err)
            != PP_OK)
            fail_msg("exact: %s", err.message);
        sum.sky += part.sky;
        sum.external += part.external;
    }
    return sum;
}

static struct pp_part facing_up(const struct pp_world *world,
                                const struct pp_outside_light *light, double x,
                                double y, double z)
{
    return at(world, light, pp_vec(x, y, z), pp_vec(0.0, 0.0, 1.0));
}

#define ROOM(inside)                                                                   \
    "<room version='1'><site ground-reflectance='0.3'/>"                               \
    "<plan width='3.0' depth='9.0' height='2.7'/>" inside "</room>"
#define WINDOW                                                                         \
    "<window wall='south' left='0.2' sill='0.9' width='2.6' height='1.4'"              \
    " glazing='none'/>"

static void the_design_window_keeps_its_digits_in_a_room(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, ROOM(WINDOW));
    struct pp_part part = facing_up(world, &light, 1.1, 2.0, 0.8);
    assert_relative(part.sky, 0.04486082291318, 1e-12);
    assert_near(part.external, 0.0, 0.0);
    pp_world_destroy(world);
    world = pp_test_lit_world(&light, ROOM("<sky type='uniform'/>" WINDOW));
    assert_relative(facing_up(world, &light, 1.1, 2.0, 0.8).sky, 0.05899459937149,
                    1e-12);
    pp_world_destroy(world);
}

/* The same window above a floor raised to the height of the point: a surface hides
 * nothing from a point in its own plane. */
static void a_point_on_the_floor_sees_what_one_above_it_does(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='3.0' depth='9.0' height='2.7'/>"
                "<window wall='south' left='0.2' sill='0.1' width='2.6' height='1.4' "
                "glazing='none'/><working-plane height='0'/>"
                "<point x='1.1' y='2.0'/></room>");
    assert_int_equal(world->receiver_count, 1);
    assert_near(pp_region_area(&world->plane), 27.0, 1e-12);
    assert_relative(facing_up(world, &light, 1.1, 2.0, 0.0).sky, 0.04486082291318,
                    1e-12);
    pp_world_destroy(world);
}

static void the_open_sky_is_one_and_a_closed_room_dark(void **state)
{
    (void)state;
    /* A rooflight as wide as the room, from just under it. */
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version='1'><plan width='4.1' depth='3.7' height='3.0'/>"
        "<rooflight x='0' y='0' width='4.1' depth='3.7' glazing='none'/></room>");
    assert_near(facing_up(world, &light, 2.1, 1.7, 3.0 - 1e-5).sky, 1.0, 1e-9);
    pp_world_destroy(world);
    world = pp_test_lit_world(&light, ROOM(""));
    struct pp_part part = facing_up(world, &light, 1.5, 4.0, 0.85);
    assert_near(part.sky + part.external, 0.0, 0.0);
    pp_world_destroy(world);
}

/* A receiver just in front of a wide window sees half of the sky and half of the
 * ground. */
static void a_receiver_at_the_glass_sees_the_vertical_sky_component(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, ROOM("<window wall='south' left='0' sill='0' width='3' height='2.7'"
                     " glazing='none'/>"));
    struct pp_part part =
        at(world, &light, pp_vec(1.4, 1e-5, 1.3), pp_vec(0.0, -1.0, 0.0));
    assert_near(part.sky, 3.0 / 14.0 + 4.0 / (7.0 * PP_PI), 1e-9);
    assert_near(part.external, 0.3 / 2.0, 1e-9);
    pp_world_destroy(world);
}

static void behind_and_in_its_plane_a_window_gives_nothing(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, ROOM(WINDOW));
    assert_near(facing_up(world, &light, 1.1, 0.0, 0.8).sky, 0.0, 0.0);
    assert_near(facing_up(world, &light, 1.1, -2.0, 0.8).sky, 0.0, 0.0);
    assert_near(at(world, &light, pp_vec(1.1, 2.0, 0.8), pp_vec(0.0, 1.0, 0.0)).sky,
                0.0, 0.0);
    /* Nothing is left for a receiver whose horizon is at the head; light is left if it
     * is at the sill. */
    double head = 2.3 - 0.8, sill = 0.9 - 0.8;
    struct pp_vec3 p = {1.1, 2.0, 0.8};
    struct pp_part none = at(world, &light, p, pp_vec(0.0, head, 2.0));
    struct pp_part some = at(world, &light, p, pp_vec(0.0, sill, 2.0));
    assert_near(none.sky, 0.0, 1e-16);
    assert_true(some.sky > 0.03);
    pp_world_destroy(world);
}

/* A skyline of 20 degrees at infinite distance in front of a window that seems
 * infinitely wide from the point: the vertical sky component above the skyline, and rho
 * times the rest. */
static void a_far_skyline_leaves_its_vertical_sky_component(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        ROOM("<window wall='south' left='0' sill='0' width='3' height='2.7'"
             " glazing='none'/><skyline wall='south' angle='20' reflectance='0.4'/>"));
    double alpha = 20.0 * PP_RAD, all = 3.0 / 14.0 + 4.0 / (7.0 * PP_PI);
    double left =
        3.0 / 14.0 * (1.0 - sin(alpha)) + 4.0 / (7.0 * PP_PI) * cos(alpha) * cos(alpha);
    struct pp_part part =
        at(world, &light, pp_vec(1.4, 1e-5, 1.3), pp_vec(0.0, -1.0, 0.0));
    assert_near(part.sky, left, 1e-9);
    assert_near(part.external, 0.4 * (all - left) + 0.3 / 2.0, 1e-9);
    double share;
    struct pp_sky sky = pp_sky_overcast();
    assert_int_equal(pp_exterior_sky_on_plane(&share, world, &world->openings[0],
                                              pp_vec(0.0, -1.0, 0.0), &sky, NULL),
                     PP_OK);
    assert_near(share, left, 1e-13);
    pp_world_destroy(world);
}

#define SIDE_WINDOW(reveal)                                                            \
    "<window wall='south' left='0.2' sill='0.9' width='2.1' height='1.4'"              \
    " glazing='none' reveal='" reveal "'/>"
#define FACADE "<facade wall='south' left='7' right='9' up='5' down='1' "

/* Checks that the sky components of two rooms are equal at four points. */
static void assert_same_sky(const char *xml, const char *as, double tolerance)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml), *like = pp_test_world(as);
    static const double places[][3] = {
        {1.1, 0.7, 0.85}, {2.8, 0.3, 0.85}, {1.7, 4.1, 0.85}, {0.2, 1.9, 0.1}};
    for (int i = 0; i < 4; i++) {
        const double *p = places[i];
        double sky = facing_up(like, &light, p[0], p[1], p[2]).sky;
        assert_true(sky > 1e-5);
        assert_near(facing_up(world, &light, p[0], p[1], p[2]).sky, sky, tolerance);
    }
    pp_world_destroy(world);
    pp_world_destroy(like);
}

/* A façade in the plane of the glass hides nothing. A façade whose face is farther out
 * hides the same sky as a reveal that is deeper by this distance. */
static void a_facade_hides_the_sky_as_a_reveal_to_its_face(void **state)
{
    (void)state;
    assert_same_sky(ROOM(SIDE_WINDOW("0") FACADE "/>"), ROOM(SIDE_WINDOW("0")), 1e-15);
    assert_same_sky(ROOM(SIDE_WINDOW("0.2") FACADE "/>"), ROOM(SIDE_WINDOW("0.2")),
                    1e-12);
    assert_same_sky(ROOM(SIDE_WINDOW("0.2") FACADE "depth='0.45'/>"),
                    ROOM(SIDE_WINDOW("0.45")), 1e-12);
    assert_same_sky(ROOM(SIDE_WINDOW("0") FACADE "depth='0.45'/>"),
                    ROOM(SIDE_WINDOW("0.45")), 1e-12);
}

/* The façade reflects light from the sky that it hides: its reflectance times that
 * sky. */
static void what_a_facade_hides_counts_as_facade(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, ROOM(SIDE_WINDOW("0") FACADE "depth='0.45' reflectance='0.4'/>"));
    struct pp_world *open = pp_test_world(ROOM(SIDE_WINDOW("0")));
    struct pp_part behind = facing_up(world, &light, 1.1, 0.7, 0.85);
    struct pp_part all = facing_up(open, &light, 1.1, 0.7, 0.85);
    assert_near(behind.external, 0.4 * (all.sky - behind.sky), 1e-12);
    pp_world_destroy(world);
    pp_world_destroy(open);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_design_window_keeps_its_digits_in_a_room),
        cmocka_unit_test(a_point_on_the_floor_sees_what_one_above_it_does),
        cmocka_unit_test(the_open_sky_is_one_and_a_closed_room_dark),
        cmocka_unit_test(a_receiver_at_the_glass_sees_the_vertical_sky_component),
        cmocka_unit_test(behind_and_in_its_plane_a_window_gives_nothing),
        cmocka_unit_test(a_far_skyline_leaves_its_vertical_sky_component),
        cmocka_unit_test(a_facade_hides_the_sky_as_a_reveal_to_its_face),
        cmocka_unit_test(what_a_facade_hides_counts_as_facade),
    };
    add_tests(tests, NULL, NULL);
}
