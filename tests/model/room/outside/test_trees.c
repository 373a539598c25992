/* test_trees.c - the crowns of trees, and their seasons. */
#include "model/room/outside/trees.h"

#include <math.h>

#include "model/room/build/device_states.h"
#include "model/room/surface_materials.h"
#include "tests/lib/room_of.h"

#define ROOM(site, inside)                                                             \
    "<room version='1'><site " site "><tree x='2' y='-7' height='9' crown-base='3' "   \
    "crown-width='5' transmittance='0.2' winter-transmittance='0.6'/></site>"          \
    "<plan width='4.2' depth='5.3' height='2.7'/>" inside "</room>"

static void a_crown_has_the_cross_section_of_its_circle(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(ROOM("ground-level='-2'", ""));
    assert_int_equal(world->outer_pane_count, 14);
    double area = 0.0, low = INFINITY, high = -INFINITY;
    for (int i = 0; i < 14; i++) {
        const struct pp_polygon *face = &world->outer_panes[i].outline;
        area += fabs(face->normal.z) > 0.5 ? face->area_m2 : 0.0;
        for (int k = 0; k < face->count; k++) {
            low = fmin(low, face->vertices[k].z);
            high = fmax(high, face->vertices[k].z);
        }
    }
    assert_near(area, 2.0 * PP_PI * 2.5 * 2.5, 1e-9);
    assert_near(low, 1.0, 1e-12);
    assert_near(high, 7.0, 1e-12);
    pp_world_destroy(world);
}

/* A ray through the crown crosses two faces; one from within, one. */
static void a_ray_is_dimmed_once_for_a_crown(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(ROOM("", ""));
    struct pp_vec3 south = pp_vec(0.0, -1.0, 0.0), up = pp_vec(0.0, 0.0, 1.0);
    double through =
        pp_surface_materials_past_outer_panes(world, pp_vec(2.1, 1.0, 4.0), south);
    assert_near(through, 0.2, 1e-12);
    assert_near(
        pp_surface_materials_past_outer_panes(world, pp_vec(2.1, 1.0, 1.0), south), 1.0,
        0.0);
    assert_near(
        pp_surface_materials_past_outer_panes(world, pp_vec(2.1, -7.1, 4.0), up),
        sqrt(0.2), 1e-12);
    struct pp_world *bare;
    assert_int_equal(pp_trees_in_season(&bare, world, true, NULL), PP_OK);
    assert_near(
        pp_surface_materials_past_outer_panes(bare, pp_vec(2.1, 1.0, 4.0), south), 0.6,
        1e-12);
    pp_device_states_destroy(bare);
    pp_world_destroy(world);
}

static void the_south_has_winter_half_a_year_later(void **state)
{
    (void)state;
    struct pp_world *north = pp_test_world(ROOM("latitude='52'", ""));
    struct pp_world *south = pp_test_world(ROOM("latitude='-34'", ""));
    struct pp_world *own = pp_test_world(ROOM("bare-from='2' bare-to='3'", ""));
    for (int month = 1; month <= 12; month++) {
        assert_int_equal(pp_trees_are_bare(north, month), month >= 11 || month <= 4);
        assert_int_equal(pp_trees_are_bare(south, month), month >= 5 && month <= 10);
        assert_int_equal(pp_trees_are_bare(own, month), month == 2 || month == 3);
    }
    assert_true(pp_trees_change(north));
    pp_world_destroy(north);
    pp_world_destroy(south);
    pp_world_destroy(own);
}

/* A room at x = 10 in its building, turned by 90 degrees: y of the room is -x. */
static void trees_of_a_building_stand_at_their_place(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<building version='1'><site><tree x='3' y='3' height='9' crown-width='2' "
        "transmittance='0.2'/></site><room x='10' y='0' rotate='90'><plan width='4' "
        "depth='5' height='2.7'/></room></building>");
    assert_int_equal(world->tree_count, 1);
    assert_near(world->trees[0].foot.x, 3.0, 1e-9);
    assert_near(world->trees[0].foot.y, 7.0, 1e-9);
    pp_world_destroy(world);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_crown_has_the_cross_section_of_its_circle),
        cmocka_unit_test(a_ray_is_dimmed_once_for_a_crown),
        cmocka_unit_test(the_south_has_winter_half_a_year_later),
        cmocka_unit_test(trees_of_a_building_stand_at_their_place),
    };
    add_tests(tests, NULL, NULL);
}
