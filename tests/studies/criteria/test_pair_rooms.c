/* test_pair_rooms.c - matching the windows of a room with those of the same room
 * before. */
#include "studies/criteria/pair_rooms.h"

#include <stdio.h>
#include <stdlib.h>

#include "tests/lib/room_of.h"

#define PLAN "<plan width=\"4.1\" depth=\"6.3\" height=\"2.9\"/>"
#define ROOM                                                                           \
    PLAN "<window wall=\"south\" left=\"0.7\" sill=\"0.95\" width=\"2.6\" "            \
         "height=\"1.3\"/>"

static struct pp_world *world_of(const char *body)
{
    char text[8192];
    snprintf(text, sizeof text, "<room version=\"1\" name=\"Test\">%s</room>", body);
    return pp_test_world(text);
}

#define TWO(first, second)                                                             \
    PLAN "<window wall=\"south\" left=\"" first "\" sill=\"1\" width=\"1\" "           \
         "height=\"1.2\"/><window wall=\"south\" left=\"" second                       \
         "\" sill=\"1\" width=\"1\" height=\"1.2\"/>"

static void windows_are_paired_by_their_place(void **state)
{
    (void)state;
    struct pp_world *world = world_of(TWO("0.4", "2.2"));
    struct pp_world *before =
        world_of(TWO("2.2", "0.4") "<skyline wall=\"south\" angle=\"5\"/>");
    int *pairs;
    assert_int_equal(pp_pair_rooms(&pairs, world, before, NULL), PP_OK);
    assert_int_equal(pairs[0], 1);
    assert_int_equal(pairs[1], 0);
    free(pairs);
    pp_world_destroy(before);
    pp_world_destroy(world);
}

static void another_room_is_not_the_room_before(void **state)
{
    (void)state;
    static const struct {
        const char *before, *why;
    } cases[] = {
        {ROOM, "has 1 opening, but this room has 2"},
        {TWO("0.4", "2.3"), "no opening in the place of the opening on line 1"},
        {"<plan width=\"4.1\" depth=\"6.4\" height=\"2.9\"/>", "a different shape"},
        {"<plan height=\"2.9\"><vertex x=\"0\" y=\"0\"/><vertex x=\"4.1\" y=\"0\"/>"
         "<vertex x=\"4.1\" y=\"6.3\"/></plan>",
         "has 5 faces, but this room has 6"},
        {TWO("0.4", "2.2") "<working-plane height=\"0.7\"/>", "working plane"},
    };
    struct pp_world *world = world_of(TWO("0.4", "2.2"));
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct pp_world *before = world_of(cases[i].before);
        struct pp_error err;
        int *pairs;
        assert_int_equal(pp_pair_rooms(&pairs, world, before, &err), PP_BAD_INPUT);
        assert_null(pairs);
        if (!strstr(err.message, cases[i].why))
            fail_msg("\"%s\" does not say \"%s\"", err.message, cases[i].why);
        pp_world_destroy(before);
    }
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(windows_are_paired_by_their_place),
        cmocka_unit_test(another_room_is_not_the_room_before),
    };
    add_tests(tests, NULL, NULL);
}
