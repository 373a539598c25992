/* test_street_of_blocks.c - a street of blocks, each with another reflectance: the
 * convex parts of a view agree with its outlines, and their number stays small. */
#include "methods/view/visible.h"

#include <stdio.h>

#include "tests/lib/dice.h"
#include "tests/lib/room_of.h"

enum { BLOCKS = 60 };

static const struct pp_vec3 eye = {1.9, 2.3, 0.85};

/* A room with 60 blocks in front of it, the farthest first. */
static struct pp_world *street(void)
{
    char xml[200 * (BLOCKS + 2)];
    struct dice dice = {5};
    int at = snprintf(xml, sizeof xml,
                      "<room version='1'><plan width='4.2' depth='5.1' height='2.9'/>"
                      "<window wall='south' left='0.7' sill='0.9' width='2.3' "
                      "height='1.4' glazing='none'/>");
    for (int i = 0; i < BLOCKS; i++) {
        /* one after the other, since compilers evaluate arguments in different
         * orders */
        const double turn_deg = between(&dice, 0.0, 20.0);
        const double height_m = between(&dice, 4.0, 16.0);
        const double x_m = between(&dice, -40.0, 40.0);
        at += snprintf(xml + at, sizeof xml - (size_t)at,
                       "<block x='%.2f' y='%.2f' width='3.1' depth='2.3' "
                       "height='%.2f' rotate='%.0f' reflectance='%.3f'/>",
                       x_m, -6.0 - (BLOCKS - i), height_m, turn_deg, 0.1 + 0.01 * i);
    }
    snprintf(xml + at, sizeof xml - (size_t)at, "</room>");
    return pp_test_world(xml);
}

/* Area of the patches that show the sky, or an obstruction with this reflectance. */
static double area_of(const struct pp_visible *visible, bool hidden, double reflectance)
{
    double sum = 0.0;
    for (int i = 0; i < visible->patch_count; i++) {
        const struct pp_visible_patch *patch = &visible->patches[i];
        if (patch->hidden == hidden
            && (!hidden || fabs(patch->reflectance - reflectance) < 1e-9))
            sum += pp_region_area(&patch->region);
    }
    return sum;
}

/* GEOS calculates the outlines by overlays, without convex parts. */
static void parts_have_the_areas_of_the_outlines(void **state)
{
    (void)state;
    struct pp_world *world = street();
    struct pp_visible parts, outlines, sky;
    const struct pp_opening *opening = &world->openings[0];
    assert_int_equal(pp_visible_in_parts(&parts, world, opening, eye, NULL), PP_OK);
    assert_int_equal(pp_visible_through(&outlines, world, opening, eye, NULL), PP_OK);
    assert_int_equal(pp_visible_sky(&sky, world, opening, eye, NULL), PP_OK);
    int seen = 0;
    for (int i = 0; i < BLOCKS; i++) {
        double area = area_of(&outlines, true, 0.1 + 0.01 * i);
        assert_near(area_of(&parts, true, 0.1 + 0.01 * i), area, 1e-11);
        seen += area > 0.0;
    }
    assert_true(seen > 15);
    double open = area_of(&outlines, false, 0.0);
    assert_true(open > 0.1);
    assert_near(area_of(&parts, false, 0.0), open, 1e-11);
    assert_near(area_of(&sky, false, 0.0), open, 1e-11);
    pp_visible_clear(&parts);
    pp_visible_clear(&outlines);
    pp_visible_clear(&sky);
    pp_world_destroy(world);
}

/* The nearest blocks are cut out first, so that those behind them add few parts. In the
 * order of the file there would be six times as many parts. */
static void parts_stay_few_if_the_farthest_block_stands_first(void **state)
{
    (void)state;
    struct pp_world *world = street();
    struct pp_visible parts;
    assert_int_equal(pp_visible_in_parts(&parts, world, &world->openings[0], eye, NULL),
                     PP_OK);
    int count = 0;
    for (int i = 0; i < parts.patch_count; i++)
        count += parts.patches[i].region.count;
    assert_true(count < 2 * BLOCKS);
    pp_visible_clear(&parts);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_have_the_areas_of_the_outlines),
        cmocka_unit_test(parts_stay_few_if_the_farthest_block_stands_first),
    };
    add_tests(tests, NULL, NULL);
}
