/* test_beams.c - areas along beams do not depend on the order or the number of
 * look-ups. */
#include "methods/fast/beams.h"

#include "tests/lib/dice.h"
#include "tests/lib/room_of.h"

static struct pp_world *room_before_a_block(void)
{
    return pp_test_world(
        "<room version='1'><plan width='3.7' depth='5.9' height='2.9'/>"
        "<window wall='south' left='0.6' sill='0.7' width='1.9' height='1.6'/>"
        "<window wall='east' left='1.1' sill='1.2' width='0.8' height='1.1'/>"
        "<block x='-2' y='-9' width='5' depth='3' height='7'/></room>");
}

/* Direction upwards and out of the south wall. */
static struct pp_vec3 direction(struct dice *dice)
{
    return pp_vec_unit(pp_vec(between(dice, -1.0, 1.0), -between(dice, 0.05, 1.0),
                              between(dice, 0.05, 1.5)));
}

/* Looks up more directions than the store can keep, each twice, and compares with the
 * areas calculated directly. */
static void areas_are_those_of_the_beam(void **state)
{
    (void)state;
    struct pp_world *world = room_before_a_block();
    struct pp_beams *beams;
    assert_int_equal(pp_beams_create(&beams, world, false, NULL), PP_OK);
    assert_ptr_equal(pp_beams_world(beams), world);
    int lit = 0, hidden = 0;
    for (int outside = 0; outside < 2; outside++) {
        struct pp_beam *beam;
        struct pp_kept_beam *kept;
        struct pp_beam_space space = {0};
        assert_int_equal(pp_beam_create(&beam, world, world->openings, outside, NULL),
                         PP_OK);
        for (int time = 0; time < 2; time++) {
            struct dice dice = {5};
            for (int i = 0; i < 20000; i++) {
                struct pp_vec3 u = direction(&dice);
                struct pp_beam_areas areas, again;
                assert_int_equal(
                    pp_beams_of(&kept, beams, world->openings, outside, NULL), PP_OK);
                assert_int_equal(pp_kept_beam_areas(&again, kept, u, NULL), PP_OK);
                if (time == 1 && i % 10 > 0)
                    continue;
                assert_int_equal(pp_beam_areas(&areas, beam, &space, u, NULL), PP_OK);
                assert_memory_equal(&again, &areas, sizeof areas);
                lit += areas.sky > 0.0;
                hidden += areas.reflecting > 0.0;
            }
        }
        pp_beam_space_clear(&space);
        pp_beam_destroy(beam);
    }
    assert_true(lit > 1000 && hidden > 1000);
    pp_beams_destroy(beams);
    pp_world_destroy(world);
}

/* A stored mean is used only for its own opening, glass and view. */
static void means_are_of_an_opening_a_view_and_a_glass(void **state)
{
    (void)state;
    struct pp_world *world = room_before_a_block();
    struct pp_beams *beams;
    struct pp_kept_beam *south, *bare, *east;
    assert_int_equal(pp_beams_create(&beams, world, false, NULL), PP_OK);
    assert_int_equal(pp_beams_of(&south, beams, world->openings, true, NULL), PP_OK);
    assert_int_equal(pp_beams_of(&bare, beams, world->openings, false, NULL), PP_OK);
    assert_int_equal(pp_beams_of(&east, beams, world->openings + 1, true, NULL), PP_OK);
    const struct pp_glass single = pp_glass_clear_single(), none = pp_glass_none();
    const double values[2] = {0.02, 0.003};
    double means[2];
    assert_false(pp_kept_beam_means(means, south, &single));
    pp_kept_beam_keep_means(south, &single, values);
    assert_true(pp_kept_beam_means(means, south, &single));
    assert_memory_equal(means, values, sizeof means);
    assert_false(pp_kept_beam_means(means, south, &none));
    assert_false(pp_kept_beam_means(means, bare, &single));
    assert_false(pp_kept_beam_means(means, east, &single));
    for (int panes = 2; panes < 9; panes++) {
        struct pp_glass glass = pp_glass_panes(panes, 1.52, 0.02);
        pp_kept_beam_keep_means(south, &glass, values);
    }
    assert_true(pp_kept_beam_means(means, south, &single));
    pp_beams_destroy(beams);
    pp_world_destroy(world);
}

/* With a limit on the work, the budget is reported as exhausted after some
 * directions. */
static void a_space_that_is_spent_has_no_more_areas(void **state)
{
    (void)state;
    struct pp_world *world = room_before_a_block();
    struct pp_beam *beam;
    struct pp_beam_space space = {.work_budget = 40};
    struct pp_beam_areas areas;
    struct dice dice = {5};
    assert_int_equal(pp_beam_create(&beam, world, world->openings, true, NULL), PP_OK);
    int directions = 0;
    while (!pp_beam_budget_exhausted(&space) && ++directions < 1000)
        assert_int_equal(pp_beam_areas(&areas, beam, &space, direction(&dice), NULL),
                         PP_OK);
    assert_true(directions > 3 && directions < 1000);
    pp_beam_space_clear(&space);
    pp_beam_destroy(beam);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(areas_are_those_of_the_beam),
        cmocka_unit_test(means_are_of_an_opening_a_view_and_a_glass),
        cmocka_unit_test(a_space_that_is_spent_has_no_more_areas),
    };
    add_tests(tests, NULL, NULL);
}
