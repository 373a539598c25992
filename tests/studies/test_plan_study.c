/* test_plan_study.c - contours of a plan are only drawn where points are allowed. */
#include "studies/plan_study.h"

#include "model/room/position.h"
#include "model/room/section.h"
#include "tests/studies/research/compare/compared_room.h"

/* A cupboard in the back corner, a column, a partition, and a desk below the plane. */
static const char furnished[] =
    "<room version='1'><plan width='4' depth='6' height='2.7'/>"
    "<window wall='south' left='0.5' sill='0.9' width='3' height='1.5'/>"
    "<furniture x='2.5' y='5.4' width='1.5' depth='0.6' height='2.1'/>"
    "<furniture x='1' y='1' width='1.6' depth='0.8' height='0.74'/>"
    "<column x='3' y='3' width='0.4' depth='0.4'/>"
    "<partition from='0 3.5' to='1.6 3.5' height='2' thickness='0.1'/></room>";

static void the_open_plane_has_holes_where_something_stands_through_it(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(furnished);
    struct pp_region open;
    assert_int_equal(pp_section_open(&open, world, NULL), PP_OK);
    assert_near(pp_region_area(&open), 24.0 - 1.5 * 0.6 - 0.4 * 0.4 - 1.6 * 0.1, 1e-6);
    assert_true(pp_region_contains(&open, 1.5, 1.5)); /* over the desk */
    assert_false(pp_region_contains(&open, 3.0, 5.7));
    pp_region_clear(&open);
    world->working_plane_m = 2.05; /* above the partition */
    assert_int_equal(pp_section_open(&open, world, NULL), PP_OK);
    assert_near(pp_region_area(&open), 24.0 - 1.5 * 0.6 - 0.4 * 0.4, 1e-6);
    pp_region_clear(&open);
    pp_world_destroy(world);
}

static void where_nothing_is_open_it_is_the_plane(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan width='4' depth='6' height='2.7'/>"
        "<window wall='south' left='0.5' sill='0.9' width='3' height='1.5'/>"
        "<furniture x='0' y='0' width='4' depth='6' height='1.2'/>"
        "<point x='2' y='2' z='1.5'/></room>");
    struct pp_region open;
    assert_int_equal(pp_section_open(&open, world, NULL), PP_OK);
    assert_near(pp_region_area(&open), 24.0, 1e-9);
    pp_region_clear(&open);
    pp_world_destroy(world);
}

/* True if the position is more than a millimetre inside an object. */
static bool is_within(const struct pp_world *world, double x, double y)
{
    const double hair = 1e-3;
    bool all = true;
    for (int i = 0; i < 4; i++) {
        double dx = i % 2 ? hair : -hair, dy = i / 2 ? hair : -hair;
        all = all
              && pp_position_in_fitting(world,
                                        pp_vec(x + dx, y + dy, world->working_plane_m));
    }
    return all;
}

static void lie_outside(const struct pp_curve_list *curves,
                        const struct pp_world *world)
{
    for (int i = 0; i < curves->count; i++)
        for (int k = 0; k < curves->list[i].count; k++)
            if (is_within(world, curves->list[i].xy[k][0], curves->list[i].xy[k][1]))
                fail_msg("a curve runs through %g, %g", curves->list[i].xy[k][0],
                         curves->list[i].xy[k][1]);
}

/* By hand and simulated: the lowest position and the contours are outside the cupboard,
 * and the lowest position receives light. */
static void nothing_is_drawn_within_furniture(void **state)
{
    (void)state;
    struct pp_test_compared room;
    pp_test_compared_init(&room, furnished);
    const struct pp_world *world = room.study.world;
    for (int traced = 0; traced < 2; traced++) {
        struct pp_study_options options = PP_STUDY_OPTIONS_NONE;
        struct pp_plan_study study;
        struct pp_error err = {0};
        bool by_clock = false;
        options.simulate = traced;
        options.error = traced ? 0.05 : 0.0;
        if (pp_plan_study_make(&study, &room.study, &options, &by_clock, &err) != PP_OK)
            fail_msg("%s", err.message);
        const struct pp_daylight_plan *plan = &study.plan;
        assert_true(plan->contours.count > 3);
        assert_false(is_within(world, plan->lowest_xy[0], plan->lowest_xy[1]));
        assert_true(plan->lowest > 0.001);
        lie_outside(&plan->contours, world);
        lie_outside(&plan->no_sky, world);
        lie_outside(&plan->dark, world);
        pp_plan_study_clear(&study);
    }
    pp_test_compared_clear(&room);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_open_plane_has_holes_where_something_stands_through_it),
        cmocka_unit_test(where_nothing_is_open_it_is_the_plane),
        cmocka_unit_test(nothing_is_drawn_within_furniture),
    };
    add_tests(tests, NULL, NULL);
}
