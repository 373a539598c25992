/* test_self_occlusion.c - which faces and objects in the room can hide parts of an
 * opening. */
#include <string.h>

#include "methods/view/elevation.h"
#include "tests/lib/room_of.h"

#define BOX "<room version='1'><plan width='6' depth='5' height='2.8'/>"
/* An L-shaped room: a wing of 3 m to the south in the west, one of 4 m to the east in
 * the north. Walls: 1 south, 2 east of the south wing, 3 south of the east wing, 4
 * east, 5 north, 6 west. */
#define L                                                                              \
    "<room version='1'><plan height='2.8'><vertex x='0' y='0'/><vertex x='3' y='0'/>"  \
    "<vertex x='3' y='3'/><vertex x='7' y='3'/><vertex x='7' y='6'/>"                  \
    "<vertex x='0' y='6'/></plan>"
#define WINDOW(wall, left)                                                             \
    "<window wall='" wall "' left='" left "' sill='0.9' width='1.6' height='1.5' "     \
    "reveal='0.1'/>"

static void nothing_hides_the_windows_of_an_empty_box(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(BOX WINDOW("south", "1") WINDOW(
        "east", "0.2") "<rooflight x='2' y='2' width='1' depth='1'/></room>");
    assert_int_equal(world->opening_count, 3);
    assert_true(world->is_empty);
    for (int i = 0; i < world->opening_count; i++) {
        assert_true(world->openings[i].faces_open_in);
        assert_true(world->openings[i].faces_open_out);
    }
    pp_world_destroy(world);
}

static void only_free_standing_objects_make_a_room_less_empty(void **state)
{
    (void)state;
    static const struct {
        const char *what;
        bool is_empty;
    } cases[] = {
        {"<door wall='north' left='1' width='0.9' height='2'/>", true},
        {"<block x='0' y='-9' width='6' depth='3' height='8'/>", true},
        {"<furniture x='1' y='3' width='1' depth='0.5' height='2'/>", false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char xml[600];
        snprintf(xml, sizeof xml, "%s%s%s</room>", BOX, WINDOW("south", "1"),
                 cases[i].what);
        struct pp_world *world = pp_test_world(xml);
        assert_int_equal(world->is_empty, cases[i].is_empty);
        pp_world_destroy(world);
    }
}

/* Surfaces south of wall 3 are behind its plane, surfaces east of wall 2 behind that of
 * wall 2; only wall 2 faces a wing. */
static void a_wing_hides_on_the_side_on_which_it_lies(void **state)
{
    (void)state;
    static const struct {
        const char *window;
        bool in, out;
    } cases[] = {
        {WINDOW("1", "0.5"), false, true}, {WINDOW("2", "0.5"), false, false},
        {WINDOW("4", "0.5"), false, true}, {WINDOW("5", "4.5"), true, true},
        {WINDOW("5", "0.5"), false, true}, {WINDOW("6", "0.5"), true, true},
        {WINDOW("6", "3.5"), false, true},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char xml[600];
        snprintf(xml, sizeof xml, "%s%s</room>", L, cases[i].window);
        struct pp_world *world = pp_test_world(xml);
        assert_int_equal(world->openings[0].faces_open_in, cases[i].in);
        assert_int_equal(world->openings[0].faces_open_out, cases[i].out);
        pp_world_destroy(world);
    }
}

/* The view is the same if all faces are tested. */
static void a_view_is_that_of_all_faces_held_before_it(void **state)
{
    (void)state;
    static const char *const windows[] = {WINDOW("1", "0.5"), WINDOW("2", "0.9"),
                                          WINDOW("4", "0.5"), WINDOW("5", "4.5"),
                                          WINDOW("6", "0.5"), WINDOW("6", "3.5")};
    int seen = 0;
    for (size_t w = 0; w < sizeof windows / sizeof *windows; w++) {
        char xml[800];
        snprintf(xml, sizeof xml, "%s%s<grid spacing='0.7' margin='0.3'/></room>", L,
                 windows[w]);
        struct pp_world *world = pp_test_world(xml);
        for (int i = 0; i < world->receiver_count; i++) {
            struct pp_vec3 point = world->receivers[i].position;
            struct pp_opening unknown = world->openings[0];
            struct pp_elevation known, all;
            unknown.faces_open_in = unknown.faces_open_out = false;
            assert_int_equal(
                pp_elevation_init(&known, world, world->openings, point, NULL), PP_OK);
            assert_int_equal(pp_elevation_init(&all, world, &unknown, point, NULL),
                             PP_OK);
            assert_int_equal(known.count, all.count);
            if (known.count > 0)
                assert_memory_equal(known.parts, all.parts,
                                    (size_t)known.count * sizeof *known.parts);
            seen += known.count > 0;
            pp_elevation_clear(&known);
            pp_elevation_clear(&all);
        }
        pp_world_destroy(world);
    }
    assert_true(seen > 100);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_hides_the_windows_of_an_empty_box),
        cmocka_unit_test(only_free_standing_objects_make_a_room_less_empty),
        cmocka_unit_test(a_wing_hides_on_the_side_on_which_it_lies),
        cmocka_unit_test(a_view_is_that_of_all_faces_held_before_it),
    };
    add_tests(tests, NULL, NULL);
}
