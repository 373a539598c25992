/* test_section_line.c - where the points of a section lie that the room file has none
 * for. */
#include "studies/section_line.h"

#include <stdlib.h>

#include "tests/lib/room_of.h"

/* From the middle of the larger window straight to the back, 6.3 m in 26 steps of at most
 * 0.25 m, each point in the middle of its own, on the working plane. The wall is followed
 * to a centimetre. */
static void points_lie_square_to_the_largest_window_at_most_a_quarter_metre_apart(
    void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan width='4' depth='6.3' height='3'/>"
        "<window wall='south' left='0.4' sill='1' width='1.8' height='1.1'/>"
        "<window wall='east' left='1' sill='1' width='0.9' height='1.1'/></room>");
    struct pp_study_room room = {.world = world, .file = "test.xml"};
    assert_int_equal(pp_section_line(&room, NULL), PP_OK);
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

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(
            points_lie_square_to_the_largest_window_at_most_a_quarter_metre_apart),
    };
    add_tests(tests, NULL, NULL);
}
