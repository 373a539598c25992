/* test_section_line.c - positions of the points of a section if the room file has
 * none. */
#include "studies/section_line.h"

#include <stdlib.h>

#include "tests/lib/room_of.h"

/* From the middle of the larger window straight to the back, 6.3 m in 26 steps of at
 * most 0.25 m, with each point in the middle of its step, on the working plane.
 * Tolerance: a centimetre. */
static void points_lie_square_to_the_largest_window_at_most_a_quarter_metre_apart(
    void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan width='4' depth='6.3' height='3'/>"
        "<window wall='south' left='0.4' sill='1' width='1.8' height='1.1'/>"
        "<window wall='east' left='1' sill='1' width='0.9' height='1.1'/></room>");
    struct pp_study_room room = {.world = world, .file = "test.xml"};
    assert_int_equal(pp_section_line(&room, &(struct pp_section_place){0}, NULL),
                     PP_OK);
    assert_int_equal(room.receiver_count, 26);
    assert_true(pp_section_line_is_straight(room.receivers, room.receiver_count));
    double step = 6.3 / 26.0;
    for (int i = 0; i < room.receiver_count; i++) {
        struct pp_vec3 at = room.receivers[i].position;
        assert_near(at.x, 0.4 + 0.9, 1e-9);
        assert_near(at.y, (i + 0.5) * step, 0.01);
        assert_near(at.z, world->working_plane_m, 1e-12);
    }
    free(room.receivers);
    pp_world_destroy(world);
}

/* Length of the section line in the room below, and x and y of its first point. */
static double line_at(const char *text, double first[2])
{
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan height='3'><vertex x='0' y='0'/><vertex x='8' y='0'/>"
        "<vertex x='8' y='3'/><vertex x='3' y='3'/><vertex x='3' y='7'/>"
        "<vertex x='0' y='7'/></plan>"
        "<window name='N' wall='5' left='1' sill='1' width='1.2' height='1.1'/>"
        "<rooflight name='R' x='4' y='1' width='2' depth='1'/></room>");
    struct pp_study_room room = {.world = world, .file = "test.xml"};
    struct pp_section_place place = {0};
    if (text)
        assert_int_equal(pp_section_place_read(&place, text, NULL), PP_OK);
    enum pp_status status = pp_section_line(&room, &place, NULL);
    double length = -1.0;
    if (status == PP_OK) {
        struct pp_vec3 a = room.receivers[0].position,
                       b = room.receivers[room.receiver_count - 1].position;
        first[0] = a.x;
        first[1] = a.y;
        length = pp_vec_length(pp_vec_sub(b, a)) * room.receiver_count
                 / (room.receiver_count - 1.0);
        free(room.receivers);
    }
    pp_world_destroy(world);
    return length;
}

/* The L-shaped room is 7 m long at x = 1, 3 m at x = 5, and 8 m at y = 2. The rooflight
 * is larger than the window, so the default line passes through its middle, x = 5,
 * perpendicular to the window wall, which faces north. */
static void a_section_is_at_the_requested_position(void **state)
{
    (void)state;
    double first[2];
    assert_near(line_at("x=1", first), 7.0, 0.03);
    assert_near(first[0], 1.0, 1e-9);
    assert_near(line_at("x=5", first), 3.0, 0.03);
    assert_near(line_at("y=2", first), 8.0, 0.03);
    assert_near(first[1], 2.0, 1e-9);
    assert_near(line_at("y=5", first), 3.0, 0.03);
    assert_near(line_at("N", first), 7.0, 0.03);
    assert_near(line_at(NULL, first), 3.0, 0.03);
    assert_near(first[0], 5.0, 1e-9);
    assert_near(line_at("R", first), 3.0, 0.03);
    assert_near(line_at("x=8.5", first), -1.0, 0.0);
    assert_near(line_at("y=-0.5", first), -1.0, 0.0);
    assert_near(line_at("W9", first), -1.0, 0.0);
}

static void a_place_is_x_or_y_or_a_name(void **state)
{
    (void)state;
    struct pp_section_place place;
    assert_int_equal(pp_section_place_read(&place, "x=2.1", NULL), PP_OK);
    assert_int_equal(place.kind, PP_SECTION_AT_X);
    assert_near(place.at_m, 2.1, 0.0);
    assert_int_equal(pp_section_place_read(&place, "W3", NULL), PP_OK);
    assert_int_equal(place.kind, PP_SECTION_THROUGH);
    assert_int_equal(pp_section_place_read(&place, "y=", NULL), PP_BAD_INPUT);
    assert_int_equal(pp_section_place_read(&place, "x=1m", NULL), PP_BAD_INPUT);
    assert_int_equal(pp_section_place_read(&place, "", NULL), PP_BAD_INPUT);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(
            points_lie_square_to_the_largest_window_at_most_a_quarter_metre_apart),
        cmocka_unit_test(a_section_is_at_the_requested_position),
        cmocka_unit_test(a_place_is_x_or_y_or_a_name),
    };
    add_tests(tests, NULL, NULL);
}
