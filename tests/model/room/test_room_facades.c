/* test_room_facades.c - a room as part of a larger house: which walls are extended, and
 * how far. */
#include "model/room/room_facades.h"
#include "model/room/room_parts.h"
#include "tests/lib/room_of.h"

/* A copy of the room with its walls extended by 20 m. */
static struct pp_room *in_a_house(const char *xml, int *added)
{
    struct pp_mistakes mistakes;
    struct pp_building *building = NULL;
    struct pp_world *world = NULL;
    struct pp_room *room = NULL;
    pp_mistakes_init(&mistakes, "test");
    assert_int_equal(pp_building_parse(&building, xml, strlen(xml), &mistakes, NULL),
                     PP_OK);
    const struct pp_room *read = pp_building_room(building, 0);
    assert_int_equal(pp_world_create(&world, read, &mistakes, NULL), PP_OK);
    assert_int_equal(pp_room_copy(&room, read, NULL), PP_OK);
    assert_int_equal(pp_room_facades_add(room, world, 20.0, added, NULL), PP_OK);
    pp_world_destroy(world);
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
    return room;
}

#define BOX "<room version='1'><plan width='4' depth='5' height='2.7'/>"
#define SOUTH "<window wall='south' left='1' sill='0.8' width='2' height='1.5'/>"

/* Beyond the corner between south and east each wall would be in front of the other's
 * windows. Seen from outside the corner is to the right of the south wall and to the
 * left of the east wall. */
static void walls_with_windows_go_on_but_not_round_a_corner(void **state)
{
    (void)state;
    int added;
    struct pp_room *room = in_a_house(
        BOX SOUTH "<window wall='east' left='1' sill='0.8' width='1' height='1.5'/>"
                  "<window wall='east' left='3' sill='0.8' width='1' height='1.5'/>"
                  "</room>",
        &added);
    assert_int_equal(added, 2);
    assert_int_equal(room->facade_count, 2);
    for (int i = 0; i < 2; i++) {
        const struct pp_facade_part *facade = &room->facades[i];
        assert_string_equal(facade->wall, i ? "east" : "south");
        assert_near(facade->left_m, i ? 0.0 : 20.0, 0.0);
        assert_near(facade->right_m, i ? 20.0 : 0.0, 0.0);
        assert_near(facade->up_m, 20.0, 0.0);
        assert_near(facade->down_m, 20.0, 0.0);
    }
    pp_room_destroy(room);
}

static void walls_of_opposite_windows_go_on_to_all_sides(void **state)
{
    (void)state;
    int added;
    struct pp_room *room = in_a_house(
        BOX SOUTH "<window wall='north' left='1' sill='0.8' width='1' height='1.5'/>"
                  "</room>",
        &added);
    assert_int_equal(added, 2);
    for (int i = 0; i < 2; i++) {
        assert_near(room->facades[i].left_m, 20.0, 0.0);
        assert_near(room->facades[i].right_m, 20.0, 0.0);
    }
    pp_room_destroy(room);
}

/* A façade in the file is kept, even if it does not extend the wall. */
static void a_wall_with_a_facade_in_the_file_is_not_changed(void **state)
{
    (void)state;
    int added;
    struct pp_room *room =
        in_a_house(BOX SOUTH "<facade wall='south'/></room>", &added);
    assert_int_equal(added, 0);
    assert_int_equal(room->facade_count, 1);
    assert_near(room->facades[0].up_m, 0.0, 0.0);
    pp_room_destroy(room);
}

static void above_a_rooflight_there_is_no_house(void **state)
{
    (void)state;
    int added;
    struct pp_room *room = in_a_house(
        BOX SOUTH "<rooflight x='1' y='2' width='1' depth='1'/></room>", &added);
    assert_int_equal(added, 1);
    assert_near(room->facades[0].up_m, 0.0, 0.0);
    assert_near(room->facades[0].left_m, 20.0, 0.0);
    pp_room_destroy(room);
    room =
        in_a_house(BOX "<rooflight x='1' y='2' width='1' depth='1'/></room>", &added);
    assert_int_equal(added, 0);
    pp_room_destroy(room);
}

/* An L-shaped room: the inner walls, 3 and 4, meet in a corner that points inwards;
 * extended beyond it they would pass through the room. */
static void beside_an_inner_corner_a_wall_ends(void **state)
{
    (void)state;
    int added;
    struct pp_room *room = in_a_house(
        "<room version='1'><plan height='2.7'><vertex x='0' y='0'/><vertex x='7' "
        "y='0'/>"
        "<vertex x='7' y='3'/><vertex x='4' y='3'/><vertex x='4' y='6'/>"
        "<vertex x='0' y='6'/></plan>"
        "<window wall='3' left='0.5' sill='0.9' width='1.9' height='1.5'/></room>",
        &added);
    assert_int_equal(added, 1);
    /* Wall 3 runs from (7, 3) to (4, 3) and faces north: seen from outside the inner
     * corner is to its right. */
    assert_near(room->facades[0].left_m, 20.0, 0.0);
    assert_near(room->facades[0].right_m, 0.0, 0.0);
    pp_room_destroy(room);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(walls_with_windows_go_on_but_not_round_a_corner),
        cmocka_unit_test(walls_of_opposite_windows_go_on_to_all_sides),
        cmocka_unit_test(a_wall_with_a_facade_in_the_file_is_not_changed),
        cmocka_unit_test(above_a_rooflight_there_is_no_house),
        cmocka_unit_test(beside_an_inner_corner_a_wall_ends),
    };
    add_tests(tests, NULL, NULL);
}
