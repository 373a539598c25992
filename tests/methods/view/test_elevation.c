/* test_elevation.c - an opening and obstructions as rectangles. */
#include "methods/view/elevation.h"

#include <stdio.h>

#include "tests/lib/room_of.h"

/* A block 2.3 m high beside the room, from 4.2 m in front of the window's plane to
 * `back` (m; below 0: in front of the plane). */
static struct pp_world *beside_block(double back)
{
    char xml[1000];
    snprintf(xml, sizeof xml,
             "<room version='1'><plan width='3.6' depth='5.1' height='2.7'/>"
             "<window wall='south' left='0.3' sill='0.7' width='3' height='1.9'/>"
             "<block x='3.8' y='-4.2' width='2.3' depth='%.17g' height='2.3'/>"
             "<point x='0.7' y='1.9'/></room>",
             back + 4.2);
    return pp_test_world(xml);
}

/* The cut is 1e-5 m in front of the plane; the block's rectangle moves as little. */
static void the_part_of_a_block_behind_the_glass_hides_nothing(void **state)
{
    (void)state;
    struct pp_world *across = beside_block(3.1), *ahead = beside_block(-1e-5);
    struct pp_elevation a, b;
    const struct pp_vec3 eye = across->receivers[0].position;
    assert_int_equal(pp_elevation_init(&a, across, &across->openings[0], eye, NULL),
                     PP_OK);
    assert_int_equal(pp_elevation_init(&b, ahead, &ahead->openings[0], eye, NULL),
                     PP_OK);
    assert_true(a.count > 1);
    assert_int_equal(a.count, b.count);
    for (int i = 0; i < a.count; i++) {
        assert_near(a.parts[i].left, b.parts[i].left, 1e-4);
        assert_near(a.parts[i].right, b.parts[i].right, 1e-4);
        assert_near(a.parts[i].low, b.parts[i].low, 1e-4);
        assert_near(a.parts[i].high, b.parts[i].high, 1e-4);
    }
    pp_elevation_clear(&a);
    pp_elevation_clear(&b);
    pp_world_destroy(across);
    pp_world_destroy(ahead);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_part_of_a_block_behind_the_glass_hides_nothing),
    };
    add_tests(tests, NULL, NULL);
}
