/* test_sense.c - rooms that are well formed but make no sense: their messages, and no
 * further messages.
 *
 * Single mistakes are in the files of tests/model/room/read/wrong; this file has
 * combinations, and consequences that must not be reported.
 */
#include <stdlib.h>
#include <time.h>

#include "model/room/world.h"
#include "tests/lib/room_of.h"
#include "model/room/position.h"

#define PLAN "<plan width=\"4.3\" depth=\"6.1\" height=\"2.9\"/>\n"
#define ROOM(parts) "<room version=\"1\">\n" PLAN parts "</room>"

/* Asserts exactly these mistakes of the room, each as "LINE words"; the message must
 * contain all words. */
static void assert_mistakes(const char *xml, int count, const char *const *expected)
{
    struct pp_mistakes mistakes;
    struct pp_world *world = pp_test_resolve(xml, &mistakes);
    pp_mistakes_sort(&mistakes);
    assert_null(world);
    bool same = mistakes.count == count;
    for (int i = 0; i < count && same; i++) {
        char *words;
        long line = strtol(expected[i], &words, 10);
        same = mistakes.list[i].line == line
               && strstr(mistakes.list[i].text, words + 1) != NULL;
    }
    for (int i = 0; i < mistakes.count && !same; i++)
        print_message("# line %d: %s\n", mistakes.list[i].line, mistakes.list[i].text);
    pp_mistakes_clear(&mistakes);
    if (!same)
        fail_msg("expected %d, first: %s", count, expected[0]);
}

#define assert_mistake(xml, ...)                                                       \
    do {                                                                               \
        static const char *const expected_[] = {__VA_ARGS__};                          \
        assert_mistakes(xml, sizeof expected_ / sizeof *expected_, expected_);         \
    } while (0)

static void all_mistakes_are_found_at_once(void **state)
{
    (void)state;
    assert_mistake(
        ROOM("<window wall=\"sooth\" left=\"0\" sill=\"1\" width=\"1\" height=\"1\"/>\n"
             "<window wall=\"east\" left=\"5.5\" sill=\"2.5\" width=\"1\" "
             "height=\"1\"/>\n"
             "<finish wall=\"roof\" reflectance=\"0.5\"/>\n"
             "<block x=\"4\" y=\"4\" width=\"1\" depth=\"1\" height=\"1\"/>\n"
             "<point x=\"9\" y=\"1\"/>\n"
             "<working-plane height=\"0.9\"/>\n"),
        "3 did you mean \"south\"", "4 to the right of wall \"east\"",
        "4 0.6 m above the top", "5 no wall \"roof\"", "6 overlaps the room",
        "7 (9, 1, 0.9) lies outside");
}

/* Parts that depend on an invalid plan are not reported; others are. */
static void a_bad_plan_does_not_drag_the_rest_along(void **state)
{
    (void)state;
    assert_mistake(
        "<room version=\"1\">\n<plan height=\"2.9\"><vertex x=\"0\" y=\"0\"/>"
        "<vertex x=\"4\" y=\"4\"/><vertex x=\"4\" y=\"0\"/><vertex x=\"0\" y=\"4\"/>"
        "</plan>\n"
        "<window wall=\"1\" left=\"0\" sill=\"1\" width=\"1\" height=\"1\"/>\n"
        "<window wall=\"5\" left=\"0\" sill=\"1\" width=\"1\" height=\"1\"/>\n"
        "<block x=\"1\" y=\"1\" width=\"1\" depth=\"1\" height=\"1\"/>\n"
        "<surface reflectance=\"0.5\"><vertex x=\"1\" y=\"1\" z=\"1\"/>"
        "<vertex x=\"2\" y=\"1\" z=\"1\"/><vertex x=\"3\" y=\"1\" z=\"1\"/></surface>\n"
        "<point x=\"2\" y=\"9\"/></room>",
        "2 crosses or touches itself", "4 no wall \"5\"; expected 1, 2, 3 or 4",
        "6 has no area");
}

/* Two walls half a millimetre apart coincide within the accuracy of typed
 * dimensions. */
static void a_plan_does_not_come_too_near_to_itself(void **state)
{
    (void)state;
    assert_mistake(
        "<room version=\"1\">\n<plan height=\"2.9\"><vertex x=\"0\" y=\"0\"/>"
        "<vertex x=\"6\" y=\"0\"/><vertex x=\"6\" y=\"5\"/>"
        "<vertex x=\"3.0005\" y=\"5\"/><vertex x=\"3.0005\" y=\"2\"/>"
        "<vertex x=\"2\" y=\"2\"/><vertex x=\"3\" y=\"5\"/>"
        "<vertex x=\"0\" y=\"5\"/></plan></room>",
        "2 crosses or touches itself");
}

/* A clockwise plan is reversed after the message: its walls keep their names. */
static void a_clockwise_plan_keeps_its_walls(void **state)
{
    (void)state;
    assert_mistake(
        "<room version=\"1\">\n<plan height=\"2.9\"><vertex x=\"0\" y=\"0\"/>"
        "<vertex x=\"0\" y=\"6\"/><vertex x=\"4\" y=\"6\"/><vertex x=\"4\" y=\"0\"/>"
        "</plan>\n"
        "<window wall=\"1\" left=\"0\" sill=\"1\" width=\"6\" height=\"1\"/>\n"
        "<window wall=\"2\" left=\"0\" sill=\"1\" width=\"5\" height=\"1\"/>\n"
        "<window wall=\"3\" left=\"0\" sill=\"1\" width=\"5\" height=\"1\"/>\n"
        "<window wall=\"4\" left=\"0\" sill=\"1\" width=\"5\" height=\"1\"/>\n</room>",
        "2 its vertices are clockwise", "4 ends 1 m to the right",
        "6 ends 1 m to the right");
}

static void surfaces_stay_on_one_side_of_the_room_s_faces(void **state)
{
    (void)state;
    assert_mistake(
        ROOM("<surface reflectance=\"0.5\"><vertex x=\"1\" y=\"-0.5\" z=\"2\"/>"
             "<vertex x=\"2\" y=\"-0.5\" z=\"2\"/><vertex x=\"2\" y=\"0.5\" z=\"2\"/>"
             "</surface>\n"
             /* Through the edge at the corner, with both walls on one side of its
              * plane. */
             "<surface reflectance=\"0.5\"><vertex x=\"-1\" y=\"-1\" z=\"1\"/>"
             "<vertex x=\"1\" y=\"1\" z=\"1\"/><vertex x=\"1\" y=\"1\" z=\"2\"/>"
             "<vertex x=\"-1\" y=\"-1\" z=\"2\"/></surface>\n"),
        "3 intersects a wall of the room at (1.75", "4 in the room at");
}

static void a_reveal_may_not_reach_into_the_other_wing(void **state)
{
    (void)state;
    /* A gap of 0.3 m between the two wings of a U. */
    assert_mistake(
        "<room version=\"1\">\n<plan height=\"2.9\"><vertex x=\"0\" y=\"0\"/>"
        "<vertex x=\"6\" y=\"0\"/><vertex x=\"6\" y=\"5\"/><vertex x=\"3.3\" y=\"5\"/>"
        "<vertex x=\"3.3\" y=\"2\"/><vertex x=\"3\" y=\"2\"/><vertex x=\"3\" y=\"5\"/>"
        "<vertex x=\"0\" y=\"5\"/></plan>\n"
        "<window wall=\"6\" left=\"1\" sill=\"1\" width=\"1\" height=\"1\" "
        "reveal=\"0.4\"/>\n"
        "<window wall=\"6\" left=\"2.1\" sill=\"1\" width=\"0.5\" height=\"1\" "
        "reveal=\"0.2\"/>\n</room>",
        "3 inside another part of the room");
}

static void a_block_keeps_clear_of_the_glass(void **state)
{
    (void)state;
    assert_mistake(
        ROOM("<window wall=\"south\" left=\"1\" sill=\"1\" width=\"1\" height=\"1\" "
             "reveal=\"0.5\"/>\n"
             "<block x=\"0\" y=\"-3\" width=\"3\" depth=\"2.6\" height=\"3\"/>\n"
             "<block x=\"0\" y=\"-3\" width=\"3\" depth=\"2.4\" height=\"3\"/>\n"),
        "4 extends into the reveal of the opening on line 3");
}

static void a_skyline_keeps_clear_of_the_room(void **state)
{
    (void)state;
    /* Wall 3 of the L-shape faces north; the other wing extends 3 m beyond it. */
    assert_mistake(
        "<room version=\"1\">\n<plan height=\"2.6\"><vertex x=\"0\" y=\"0\"/>"
        "<vertex x=\"6\" y=\"0\"/><vertex x=\"6\" y=\"3\"/><vertex x=\"2\" y=\"3\"/>"
        "<vertex x=\"2\" y=\"6\"/><vertex x=\"0\" y=\"6\"/></plan>\n"
        "<skyline wall=\"3\" angle=\"20\" distance=\"2.5\"/>\n"
        "<skyline wall=\"5\" angle=\"20\" distance=\"2.5\"/>\n</room>",
        "3 extend 3 m beyond that wall");
}

/* Adds the faces of a box from one corner to the other; if `solid`, its faces point
 * outwards. */
static int add_box(char *xml, size_t space, const double a[3], const double b[3],
                   bool solid, const char *name)
{
    static const int corners[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {1, 0, 4, 5},
                                      {3, 1, 5, 7}, {2, 3, 7, 6}, {0, 2, 6, 4}};
    static const char *const roles[] = {"floor", "ceiling", "wall",
                                        "wall",  "wall",    "wall"};
    int length = 0;
    for (int i = 0; i < 6; i++) {
        length += snprintf(xml + length, space - length,
                           "<face role=\"%s\" name=\"%s%d\">", roles[i], name, i);
        for (int k = 0; k < 4; k++) {
            int corner = corners[i][solid ? 3 - k : k];
            length += snprintf(xml + length, space - length,
                               "<vertex x=\"%g\" y=\"%g\" z=\"%g\"/>",
                               corner & 1 ? b[0] : a[0], corner & 2 ? b[1] : a[1],
                               corner & 4 ? b[2] : a[2]);
        }
        length += snprintf(xml + length, space - length, "</face>\n");
    }
    return length;
}

/* A pillar that does not reach the ceiling is part of a room; a second, separate room
 * is not. */
static void an_envelope_is_one_room_with_the_objects_in_it(void **state)
{
    (void)state;
    static const double room[2][3] = {{0, 0, 0}, {5, 4, 3}};
    static const double pillar[2][3] = {{2, 2, 0.1}, {2.4, 2.4, 2.5}};
    static const double other[2][3] = {{7, 0, 0}, {9, 4, 3}};
    char xml[8192];
    for (int k = 0; k < 2; k++) {
        int length = snprintf(xml, sizeof xml, "<room version=\"1\">\n<envelope>\n");
        length +=
            add_box(xml + length, sizeof xml - length, room[0], room[1], false, "a");
        length += add_box(xml + length, sizeof xml - length, k ? other[0] : pillar[0],
                          k ? other[1] : pillar[1], k == 0, "b");
        snprintf(xml + length, sizeof xml - length, "</envelope></room>");
        if (k == 1) {
            assert_mistake(xml, "2 2 separate rooms");
            continue;
        }
        struct pp_world *world = pp_test_world(xml);
        assert_near(pp_region_area(&world->plane), 5.0 * 4.0 - 0.16, 1e-12);
        assert_false(pp_position_in_room(world, pp_vec(2.2, 2.2, 1.0)));
        assert_true(pp_position_in_room(world, pp_vec(2.2, 2.2, 2.6)));
        pp_world_destroy(world);
    }
}

/* Every edge is shared by two faces, but the roof extends through the floor like a
 * funnel. */
static void faces_meet_in_their_edges_only(void **state)
{
    (void)state;
#define V(x, y, z) "<vertex x=\"" x "\" y=\"" y "\" z=\"" z "\"/>"
#define TIP V("2.5", "2", "-1")
    assert_mistake(
        "<room version=\"1\">\n<envelope>\n"
        "<face role=\"floor\" name=\"f\">" V("0", "0", "0") V("5", "0", "0")
            V("5", "4", "0")
                V("0", "4", "0") "</face>\n"
                                 "<face role=\"ceiling\" name=\"1\">" V("5", "0", "3")
                                     V("0", "0", "3") TIP
        "</face>\n"
        "<face role=\"ceiling\" name=\"2\">" V("5", "4", "3") V("5", "0", "3") TIP
        "</face>\n"
        "<face role=\"ceiling\" name=\"3\">" V("0", "4", "3") V("5", "4", "3") TIP
        "</face>\n"
        "<face role=\"ceiling\" name=\"4\">" V("0", "0", "3") V("0", "4", "3") TIP
        "</face>\n"
        "<face role=\"wall\" name=\"s\">" V("5", "0", "0") V("0", "0", "0") V("0", "0",
                                                                              "3")
            V("5", "0",
              "3") "</face>\n"
                   "<face role=\"wall\" name=\"e\">" V("5", "4", "0") V("5", "0", "0")
                       V("5", "0", "3")
                           V("5", "4",
                             "3") "</face>\n"
                                  "<face role=\"wall\" name=\"n\">" V("0", "4", "0")
                                      V("5", "4", "0") V("5", "4", "3")
                                          V("0", "4",
                                            "3") "</face>\n"
                                                 "<face role=\"wall\" name=\"w\">" V(
                                                     "0", "0", "0") V("0", "4", "0")
                                                     V("0", "4", "3")
                                                         V("0", "0",
                                                           "3") "</face>\n"
                                                                "</envelope></room>",
        "4 intersects the face on line 3", "5 intersects the face on line 3",
        "6 intersects the face on line 3", "7 intersects the face on line 3");
#undef V
#undef TIP
}

/* Lists whose comparison would take minutes are rejected quickly. */
static void far_too_many_parts_are_refused_at_once(void **state)
{
    (void)state;
    enum { WINDOWS = 40000 };
    size_t space = (size_t)WINDOWS * 128;
    char *xml = malloc(space);
    assert_non_null(xml);
    static const char *const walls[] = {"south", "nowhere"};
    for (int k = 0; k < 2; k++) {
        size_t length = snprintf(xml, space, "<room version=\"1\">\n" PLAN);
        for (int i = 0; i < WINDOWS; i++)
            length +=
                snprintf(xml + length, space - length,
                         "<window wall=\"%s\" left=\"0.1\" sill=\"1\" width=\"1\" "
                         "height=\"1\"/>",
                         walls[k]);
        snprintf(xml + length, space - length, "</room>");
        clock_t start = clock();
        assert_mistake(xml, "1 40000 openings");
        /* Reading alone takes far less than a second. */
        assert_true((double)(clock() - start) / CLOCKS_PER_SEC < 10.0);
    }
    free(xml);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_mistakes_are_found_at_once),
        cmocka_unit_test(a_bad_plan_does_not_drag_the_rest_along),
        cmocka_unit_test(a_plan_does_not_come_too_near_to_itself),
        cmocka_unit_test(a_clockwise_plan_keeps_its_walls),
        cmocka_unit_test(surfaces_stay_on_one_side_of_the_room_s_faces),
        cmocka_unit_test(a_reveal_may_not_reach_into_the_other_wing),
        cmocka_unit_test(a_block_keeps_clear_of_the_glass),
        cmocka_unit_test(a_skyline_keeps_clear_of_the_room),
        cmocka_unit_test(an_envelope_is_one_room_with_the_objects_in_it),
        cmocka_unit_test(faces_meet_in_their_edges_only),
        cmocka_unit_test(far_too_many_parts_are_refused_at_once),
    };
    add_tests(tests, NULL, NULL);
}
