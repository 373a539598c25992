/* test_receivers.c - receivers: their positions, and positions that are not allowed. */
#include "model/geometry/polygon.h"
#include "model/room/world.h"
#include "tests/lib/room_of.h"
#include "model/room/position.h"

#define ELL                                                                            \
    "<plan height=\"2.6\"><vertex x=\"0\" y=\"0\"/><vertex x=\"6\" y=\"0\"/>"          \
    "<vertex x=\"6\" y=\"3.2\"/><vertex x=\"2.5\" y=\"3.2\"/>"                         \
    "<vertex x=\"2.5\" y=\"6.2\"/><vertex x=\"0\" y=\"6.2\"/></plan>"

static struct pp_world *room_with(const char *plan, const char *parts)
{
    char xml[4096];
    snprintf(xml, sizeof xml, "<room version=\"1\">%s%s</room>", plan, parts);
    return pp_test_world(xml);
}

static struct pp_world *rectangle_with(double width, double depth, const char *parts)
{
    char plan[128];
    snprintf(plan, sizeof plan,
             "<plan width=\"%.17g\" depth=\"%.17g\" height=\"2.7\"/>", width, depth);
    return room_with(plan, parts);
}

/* 4 x 6 m at 0.25 m without a margin: 384 cells; the first centre is 0.125 m from the
 * walls. */
static void a_grid_has_the_cells_that_the_plan_divides_into(void **state)
{
    (void)state;
    struct pp_world *world =
        rectangle_with(4.0, 6.0, "<grid spacing=\"0.25\" margin=\"0\"/>");
    assert_int_equal(world->receiver_count, 384);
    assert_near(world->receivers[0].position.x, 0.125, 1e-15);
    assert_near(world->receivers[0].position.y, 0.125, 1e-15);
    assert_near(world->receivers[0].position.z, 0.85, 0.0);
    assert_near(world->receivers[0].normal.z, 1.0, 0.0);
    /* x runs first. */
    assert_near(world->receivers[1].position.x, 0.375, 1e-15);
    assert_near(world->receivers[383].position.y, 5.875, 1e-14);
    pp_world_destroy(world);
}

/* 4.3 - 1.2 = 3.1 m makes 7 cells of at most 0.5 m, 5.7 - 1.2 = 4.5 m makes 9 of
 * exactly 0.5 m (not ten, in spite of rounding). */
static void cells_are_equal_and_no_larger_than_the_spacing(void **state)
{
    (void)state;
    struct pp_world *world =
        rectangle_with(4.3, 5.7, "<grid spacing=\"0.5\" margin=\"0.6\"/>");
    assert_int_equal(world->receiver_count, 7 * 9);
    double step = 3.1 / 7.0;
    for (int i = 0; i < 7; i++)
        assert_near(world->receivers[i].position.x, 0.6 + (i + 0.5) * step, 1e-14);
    assert_near(world->receivers[7].position.y, 0.6 + 0.75, 1e-14);
    pp_world_destroy(world);
}

static void the_default_grid_is_half_a_metre_inside_half_a_metre(void **state)
{
    (void)state;
    struct pp_world *asked =
        rectangle_with(3.4, 5.1, "<grid spacing=\"0.5\" margin=\"0.5\"/>");
    struct pp_world *plain = rectangle_with(3.4, 5.1, "");
    struct pp_world *bare = rectangle_with(3.4, 5.1, "<grid/>");
    assert_int_equal(plain->receiver_count, 5 * 9);
    assert_int_equal(plain->receiver_count, asked->receiver_count);
    assert_int_equal(plain->receiver_count, bare->receiver_count);
    for (int i = 0; i < plain->receiver_count; i++) {
        struct pp_vec3 a = plain->receivers[i].position,
                       b = asked->receivers[i].position;
        assert_near(pp_vec_length(pp_vec_sub(a, b)), 0.0, 0.0);
    }
    pp_world_destroy(asked);
    pp_world_destroy(plain);
    pp_world_destroy(bare);
}

/* No centre is nearer to a wall than the margin, and no centre that is farther away is
 * missing. */
static void a_grid_keeps_its_margin_round_a_corner(void **state)
{
    (void)state;
    struct pp_world *world = room_with(ELL, "<grid spacing=\"0.4\" margin=\"0.6\"/>");
    int expected = 0;
    /* 4.8 m make 12 cells, 5 m make 13. */
    for (int j = 0; j < 13; j++)
        for (int i = 0; i < 12; i++) {
            double x = 0.6 + (i + 0.5) * 0.4, y = 0.6 + (j + 0.5) * 5.0 / 13.0;
            bool in_wing = x < 2.5 - 0.6 || y < 3.2 - 0.6;
            bool at_corner = x < 2.5 && y < 3.2 && hypot(2.5 - x, 3.2 - y) >= 0.6;
            expected += in_wing || at_corner;
        }
    assert_int_equal(world->receiver_count, expected);
    for (int i = 0; i < world->receiver_count; i++) {
        struct pp_vec3 p = world->receivers[i].position;
        assert_true(pp_region_edge_distance(&world->plane, p.x, p.y) > 0.6 - 1e-6);
        assert_null(pp_position_receiver_fault(world, p, pp_vec(0.0, 0.0, 1.0)));
    }
    pp_world_destroy(world);
}

/* A plan narrower than two margins has one point in its middle by default. */
static void a_tiny_room_is_measured_in_its_middle(void **state)
{
    (void)state;
    struct pp_world *world = rectangle_with(0.9, 0.7, "");
    assert_int_equal(world->receiver_count, 1);
    assert_near(world->receivers[0].position.x, 0.45, 1e-12);
    assert_near(world->receivers[0].position.y, 0.35, 1e-12);
    pp_world_destroy(world);
    /* Exactly as wide as two margins: a line of points along its middle. */
    world = rectangle_with(1.0, 3.0, "");
    assert_int_equal(world->receiver_count, 4);
    assert_near(world->receivers[2].position.x, 0.5, 1e-12);
    pp_world_destroy(world);
}

static void a_line_has_points_at_both_its_ends(void **state)
{
    (void)state;
    struct pp_world *world =
        rectangle_with(3.0, 9.0,
                       "<working-plane height=\"0.7\"/>"
                       "<line from=\"1.5 0.5\" to=\"1.7 8.3\" points=\"14\"/>");
    assert_int_equal(world->receiver_count, 14);
    assert_true(world->receivers[0].position.x == 1.5);
    assert_true(world->receivers[13].position.x == 1.7);
    assert_true(world->receivers[13].position.y == 8.3);
    for (int i = 0; i < 14; i++) {
        assert_near(world->receivers[i].position.y, 0.5 + 0.6 * i, 1e-14);
        assert_near(world->receivers[i].position.z, 0.7, 0.0);
    }
    pp_world_destroy(world);
}

static void a_point_may_have_its_own_height_and_face_any_way(void **state)
{
    (void)state;
    struct pp_world *world =
        rectangle_with(3.0, 4.0,
                       "<point x=\"1\" y=\"2\" z=\"1.6\" nx=\"0\" ny=\"-3\" nz=\"4\"/>"
                       "<point x=\"1\" y=\"3\"/>");
    assert_int_equal(world->receiver_count, 2);
    assert_near(world->receivers[0].position.z, 1.6, 0.0);
    assert_near(world->receivers[0].normal.y, -0.6, 1e-15);
    assert_near(world->receivers[0].normal.z, 0.8, 1e-15);
    assert_near(world->receivers[1].position.z, 0.85, 0.0);
    pp_world_destroy(world);
}

#define UP                                                                             \
    {                                                                                  \
        0.0, 0.0, 1.0                                                                  \
    }

static void a_point_inside_an_object_is_rejected(void **state)
{
    (void)state;
    struct pp_world *world = rectangle_with(
        3.0, 4.0,
        "<window wall=\"south\" left=\"1\" sill=\"1\" width=\"1\" height=\"1\" "
        "reveal=\"0.3\"/>"
        "<window wall=\"north\" left=\"1\" sill=\"1\" width=\"1\" height=\"1\"/>"
        "<block x=\"5\" y=\"0\" width=\"2\" depth=\"2\" height=\"3\" rotate=\"30\"/>"
        "<surface reflectance=\"0.5\"><vertex x=\"1\" y=\"2\" z=\"0.7\"/>"
        "<vertex x=\"2\" y=\"2\" z=\"0.7\"/><vertex x=\"2\" y=\"3\" z=\"0.7\"/>"
        "</surface>");
    static const struct {
        struct pp_vec3 at;
        const char *fault;
        struct pp_vec3 normal;
    } cases[] = {
        {{1.5, 2.0, 0.85}, NULL, UP},
        {{1.5, -0.1, 1.5}, "lies in an opening", UP},
        {{1.5, -0.3, 1.5}, "lies in an opening", UP},
        {{1.5, -0.31, 1.5}, "lies outside the room", UP},
        {{1.5, 0.0, 1.5}, "lies in an opening", UP},
        {{1.5, 4.0, 1.5}, "lies in an opening", UP},
        {{1.5, 3.999, 1.5}, NULL, UP},
        {{0.5, 0.0, 1.5},
         "lies on a wall but does not face straight into the room (nx, ny, nz)",
         UP},
        {{0.5, 0.0, 1.5}, NULL, {0.0, 1.0, 0.0}},
        {{0.5, 0.0, 1.5},
         "lies on a wall but does not face straight into the room (nx, ny, nz)",
         {0.0, -1.0, 0.0}},
        {{0.5, 0.0, 1.5},
         "lies on a wall but does not face straight into the room (nx, ny, nz)",
         {0.0, 0.8, 0.6}},
        {{0.5, 0.001, 1.5}, NULL, UP},
        {{0.5, 1.5, 0.0}, NULL, UP},
        {{0.5, 1.5, 5e-5}, NULL, UP},
        {{0.5, 1.5, 0.0},
         "lies on the floor but does not face straight up (nx, ny, nz)",
         {0.0, 1.0, 0.0}},
        {{0.5, 1.5, 2.7},
         "lies on the ceiling but does not face straight down (nx, ny, nz)",
         UP},
        {{0.5, 1.5, 2.7}, NULL, {0.0, 0.0, -1.0}},
        {{3.0, 4.0, 2.7}, "", UP},
        {{3.0, 1.5, 0.0},
         "lies on a wall but does not face straight into the room (nx, ny, nz)",
         UP},
        {{0.5, 1.5, 2.8}, "lies outside the room", UP},
        {{5.3, 1.2, 1.0}, "lies inside a block", UP},
        {{6.9, 0.1, 1.0}, "lies outside the room", UP},
        {{1.7, 2.3, 0.7}, "lies on a surface", UP},
        {{1.2, 2.8, 0.7}, NULL, UP},
        {{1.7, 2.3, 0.71}, NULL, UP},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *fault =
            pp_position_receiver_fault(world, cases[i].at, cases[i].normal);
        if (!cases[i].fault)
            assert_null(fault);
        else if (cases[i].fault[0])
            assert_string_equal(fault, cases[i].fault);
        else /* in a corner, the message may name any of the faces that meet there */
            assert_non_null(fault);
    }

    struct pp_receiver receiver;
    struct pp_error err = {0};
    assert_int_equal(
        pp_position_place_receiver(&receiver, world, pp_vec(1.5, 1.0, NAN), &err),
        PP_OK);
    assert_near(receiver.position.z, 0.85, 0.0);
    assert_near(receiver.normal.z, 1.0, 0.0);
    assert_int_equal(
        pp_position_place_receiver(&receiver, world, pp_vec(1.5, 4.5, NAN), &err),
        PP_BAD_INPUT);
    assert_string_equal(
        err.message,
        "the point 1.5,4.5,0.85 lies outside the room; expected a point in "
        "the free space of the room");
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_grid_has_the_cells_that_the_plan_divides_into),
        cmocka_unit_test(cells_are_equal_and_no_larger_than_the_spacing),
        cmocka_unit_test(the_default_grid_is_half_a_metre_inside_half_a_metre),
        cmocka_unit_test(a_grid_keeps_its_margin_round_a_corner),
        cmocka_unit_test(a_tiny_room_is_measured_in_its_middle),
        cmocka_unit_test(a_line_has_points_at_both_its_ends),
        cmocka_unit_test(a_point_may_have_its_own_height_and_face_any_way),
        cmocka_unit_test(a_point_inside_an_object_is_rejected),
    };
    add_tests(tests, NULL, NULL);
}
