/* test_own_world.c - the world that a method assumes, and the error of a method as the
 * sum of the errors of this assumption and of its formula. */
#include "studies/research/validation/own_world.h"

#include <stdio.h>
#include <stdlib.h>

#include "methods/reflected/obstruction.h"
#include "methods/variant.h"
#include "model/room/room.h"
#include "model/room/room_light.h"
#include "studies/study_report.h"
#include "studies/research/validation/comparison.h"
#include "studies/research/validation/own_skylines.h"
#include "tests/lib/near.h"

/* A room by methods and simulated, also in the worlds that the methods assume. */
struct compared {
    struct pp_building *building;
    struct pp_study_room room;
    struct pp_study_options options;
    struct pp_report report;
    struct pp_own_worlds *worlds;
    struct pp_comparison *list;
    int count;
};

/* c must not move: its parts point to each other. */
static void load(struct compared *c, const char *xml, const char *methods)
{
    *c = (struct compared){.options = PP_STUDY_OPTIONS_NONE};
    struct pp_mistakes mistakes;
    struct pp_world *world;
    pp_mistakes_init(&mistakes, "test");
    assert_int_equal(pp_building_parse(&c->building, xml, strlen(xml), &mistakes, NULL),
                     PP_OK);
    struct pp_room *description = pp_building_room(c->building, 0);
    assert_int_equal(pp_world_create(&world, description, &mistakes, NULL), PP_OK);
    pp_mistakes_clear(&mistakes);
    struct pp_outside_light light;
    assert_int_equal(pp_room_light(&light, description, NULL), PP_OK);
    pp_study_room_init(&c->room, "test", c->building, 0, description, world, &light);
    c->options.methods = methods;
    c->options.samples = 256;
    c->options.threads = 1;
    assert_int_equal(pp_study_report_methods(&c->report, &c->room, &c->options, NULL),
                     PP_OK);
    assert_int_equal(pp_own_world_list(&c->worlds, description, &c->report, NULL),
                     PP_OK);
}

static void trace(struct compared *c)
{
    bool finished = true, by_clock = false;
    assert_int_equal(pp_study_report_traced(&c->report, &c->options, &by_clock, NULL),
                     PP_OK);
    assert_int_equal(
        pp_own_world_trace(c->worlds, &c->options, &finished, &by_clock, NULL), PP_OK);
    assert_true(finished);
    assert_int_equal(
        pp_comparison_of_report(&c->list, &c->count, &c->report, c->worlds, NULL),
        PP_OK);
}

static void clear(struct compared *c)
{
    free(c->list);
    pp_own_world_destroy(c->worlds);
    pp_report_clear(&c->report);
    pp_study_room_clear(&c->room);
    pp_building_destroy(c->building);
}

static const struct pp_comparison *find(const struct compared *c,
                                        enum pp_component component, const char *name)
{
    for (int i = 0; i < c->count; i++)
        if (c->list[i].component == component && strcmp(c->list[i].name, name) == 0)
            return &c->list[i];
    fail_msg("there is no %s", name);
    return NULL;
}

/* Report for the world in which a column has a component. */
static const struct pp_report *world_for(const struct compared *c,
                                         enum pp_component column, const char *name,
                                         enum pp_component component)
{
    const struct pp_column *found = pp_report_find(&c->report, column, name);
    assert_non_null(found);
    return pp_own_world_of(c->worlds, found, component);
}

/* A room 3.3 m by 5.1 m with a window in the south, on a site, with more outside. */
static const char *room_of(const char *site, const char *outside)
{
    static char xml[1024];
    snprintf(xml, sizeof xml,
             "<room version='1'><site %s/>"
             "<plan width='3.3' depth='5.1' height='2.7'/>"
             "<finishes floor='0.25' walls='0.55' ceiling='0.75'/>"
             "<window wall='south' left='0.7' sill='0.9' width='1.9' height='1.4'/>"
             "%s<point x='1.1' y='0.8'/><point x='2.1' y='3.9'/></room>",
             site, outside);
    return xml;
}

static const char block[] =
    "<block x='-5' y='-13' width='11' depth='4' height='7' reflectance='0.35'/>";

/* ---- the sum ---- */

static void assumption_and_formula_make_the_whole(void **state)
{
    (void)state;
    struct compared c;
    load(&c, room_of("ground-reflectance='0.3'", block), "all");
    trace(&c);
    int split = 0;
    for (int i = 0; i < c.count; i++) {
        const struct pp_comparison *one = &c.list[i];
        if (one->points > 0)
            assert_near(one->of_bias.assumption + one->of_bias.formula, one->bias,
                        1e-14);
        if (isfinite(one->average))
            assert_near(one->of_average.assumption + one->of_average.formula,
                        one->average - one->traced_average, 1e-14);
        split += one->of_bias.assumption != 0.0 || one->of_average.assumption != 0.0;
    }
    assert_true(split > 10);
    clear(&c);
}

/* With one seed, light from the sky is identical for any ground: direct methods use the
 * room's own world. */
static void the_sky_component_has_no_other_ground(void **state)
{
    (void)state;
    struct compared c;
    load(&c, room_of("ground-reflectance='0.3'", block), "exact+bre");
    trace(&c);
    const struct pp_comparison *sc = find(&c, PP_SC, "exact");
    assert_false(sc->own_world);
    assert_near(sc->of_bias.assumption, 0.0, 0.0);
    assert_near(sc->of_bias.assumption_error, 0.0, 0.0);
    assert_true(find(&c, PP_ERC, "exact")->own_world);
    clear(&c);
}

/* In the world with the block and open ground only the externally reflected component
 * is required, since bre has a skyline in place of the block. This world is simulated
 * with direct light only, that of bre completely. */
static void only_required_components_of_a_world_are_simulated(void **state)
{
    (void)state;
    struct compared c;
    load(&c, room_of("ground-reflectance='0.3'", block), "exact+bre");
    assert_int_equal(pp_own_world_count(c.worlds), 2);
    trace(&c);
    const struct pp_report *direct = world_for(&c, PP_ERC, "exact", PP_ERC);
    const struct pp_report *whole = world_for(&c, PP_IRC, "bre", PP_IRC);
    assert_true(isnan(pp_report_find(direct, PP_DF, "traced")->points[0].value));
    assert_true(pp_report_find(direct, PP_ERC, "traced")->points[0].value > 0.0);
    assert_true(pp_report_find(whole, PP_DF, "traced")->points[0].value > 0.0);
    clear(&c);
}

/* ---- the ground ---- */

static void bre_in_the_world_that_it_was_made_for_assumes_nothing_wrong(void **state)
{
    (void)state;
    struct compared c;
    load(&c, room_of("ground-reflectance='0.1' ground='open'", ""), "exact+bre");
    assert_int_equal(pp_own_world_count(c.worlds), 0);
    trace(&c);
    const struct pp_comparison *bre = find(&c, PP_IRC, "bre");
    assert_false(bre->own_world);
    assert_near(bre->of_bias.assumption, 0.0, 0.0);
    assert_near(bre->of_average.assumption, 0.0, 0.0);
    assert_near(bre->of_bias.formula, bre->bias, 1e-14);
    assert_near(find(&c, PP_DF, "exact+bre")->of_bias.assumption, 0.0, 0.0);
    clear(&c);
}

/* Half of the ground's reflectance is missing. The ground provides 10 of about 50 parts
 * of the light on the window and most of the light on the ceiling, far more than the
 * noise. */
static void a_ground_brighter_than_bre_has_it_is_a_negative_assumption(void **state)
{
    (void)state;
    struct compared c;
    load(&c, room_of("ground-reflectance='0.2' ground='open'", ""), "exact+bre");
    assert_int_equal(pp_own_world_count(c.worlds), 1);
    trace(&c);
    const struct pp_comparison *bre = find(&c, PP_IRC, "bre");
    assert_true(bre->of_bias.assumption < -4.0 * bre->of_bias.assumption_error);
    assert_true(bre->of_average.assumption < -4.0 * bre->of_average.assumption_error);
    clear(&c);
}

static void the_own_world_is_the_room_of_a_file_that_says_so(void **state)
{
    (void)state;
    struct compared snow;
    load(&snow, room_of("ground-reflectance='0.8'", ""), "exact+bre");
    struct compared dark;
    load(&dark, room_of("ground-reflectance='0.1' ground='open'", ""), "exact+bre");
    trace(&snow);
    trace(&dark);
    const struct pp_report *own = world_for(&snow, PP_IRC, "bre", PP_IRC);
    assert_ptr_not_equal(own, &snow.report);
    for (int k = PP_SC; k < PP_COMPONENT_COUNT; k++) {
        const struct pp_column *a = pp_report_find(own, k, "traced");
        const struct pp_column *b = pp_report_find(&dark.report, k, "traced");
        assert_near(a->average.value, b->average.value, 0.0);
        assert_near(a->points[1].value, b->points[1].value, 0.0);
    }
    clear(&snow);
    clear(&dark);
}

/* ---- which world ---- */

static void a_pair_has_light_of_both_its_worlds(void **state)
{
    (void)state;
    struct compared c;
    load(&c, room_of("ground-reflectance='0.3'", block),
         "exact+bre,exact+split-flux,average-df");
    const struct pp_report *exact = world_for(&c, PP_ERC, "exact", PP_ERC);
    const struct pp_report *bre = world_for(&c, PP_IRC, "bre", PP_IRC);
    const struct pp_report *split_flux = world_for(&c, PP_IRC, "split-flux", PP_IRC);
    assert_int_equal(pp_own_world_count(c.worlds), 3);
    assert_ptr_equal(world_for(&c, PP_DF, "exact+bre", PP_SC), &c.report);
    assert_ptr_equal(world_for(&c, PP_DF, "exact+bre", PP_ERC), exact);
    assert_ptr_equal(world_for(&c, PP_DF, "exact+bre", PP_IRC), bre);
    assert_ptr_equal(world_for(&c, PP_DF, "exact+split-flux", PP_IRC), split_flux);
    assert_ptr_equal(world_for(&c, PP_DF, "average-df", PP_SC), bre);
    assert_true(exact != bre && exact != split_flux && bre != split_flux);
    assert_near(bre->light.ground_reflectance, 0.1, 0.0);
    assert_near(split_flux->light.ground_reflectance, 0.3, 0.0);
    assert_int_equal(exact->world->block_count, 1);
    assert_int_equal(bre->world->block_count, 0);
    assert_true(exact->world->ground_is_open && bre->world->ground_is_open);
    clear(&c);
}

static void a_variant_has_the_world_of_its_method(void **state)
{
    (void)state;
    struct pp_variant_list variants = {0};
    assert_int_equal(
        pp_variant_add(&variants, "irc = 0.8 W / (A (1 - R)) (C R_fw + 5 R_cw)", NULL),
        PP_OK);
    struct compared c;
    load(&c, room_of("ground-reflectance='0.3'", ""), "exact+bre");
    pp_report_clear(&c.report);
    pp_own_world_destroy(c.worlds);
    c.options.method_options.variants = &variants;
    assert_int_equal(pp_study_report_methods(&c.report, &c.room, &c.options, NULL),
                     PP_OK);
    assert_int_equal(pp_own_world_list(&c.worlds, c.room.room, &c.report, NULL), PP_OK);
    const struct pp_report *bre = world_for(&c, PP_IRC, "bre", PP_IRC);
    assert_ptr_not_equal(bre, &c.report);
    assert_ptr_equal(world_for(&c, PP_IRC, "bre-variant", PP_IRC), bre);
    assert_ptr_equal(world_for(&c, PP_DF, "exact+bre-variant", PP_IRC), bre);
    clear(&c);
    pp_variant_clear(&variants);
}

/* ---- what stands outside ---- */

/* Skylines of a room; the caller owns its world. */
static struct pp_own_skylines skylines_of(const char *xml, struct compared *c)
{
    load(c, xml, "exact");
    struct pp_room *copy;
    struct pp_mistakes mistakes;
    struct pp_world *bare;
    struct pp_own_skylines skylines;
    pp_mistakes_init(&mistakes, "test");
    assert_int_equal(pp_room_copy(&copy, c->room.room, NULL), PP_OK);
    pp_room_clear_surroundings(copy, c->room.world);
    assert_int_equal(pp_world_create(&bare, copy, &mistakes, NULL), PP_OK);
    assert_int_equal(
        pp_own_skylines_of(&skylines, c->room.world, bare, &c->room.light, NULL),
        PP_OK);
    pp_world_destroy(bare);
    pp_room_destroy(copy);
    pp_mistakes_clear(&mistakes);
    return skylines;
}

static double angle_of(const struct compared *c, int opening)
{
    double angle_rad;
    assert_int_equal(pp_obstruction_angle(&angle_rad, c->room.world, &c->room.light,
                                          &c->room.world->openings[opening], NULL),
                     PP_OK);
    return angle_rad;
}

/* In the world with the skyline in place of the block, the formula uses the same
 * angle. */
static void a_block_becomes_the_skyline_of_the_same_angle(void **state)
{
    (void)state;
    struct compared c;
    load(&c, room_of("ground-reflectance='0.3'", block), "exact+bre");
    const struct pp_world *own = world_for(&c, PP_IRC, "bre", PP_IRC)->world;
    double before = angle_of(&c, 0), after;
    assert_int_equal(
        pp_obstruction_angle(&after, own, &c.room.light, &own->openings[0], NULL),
        PP_OK);
    assert_true(before > 5.0 * PP_RAD);
    assert_near(after, before, 1e-12);
    assert_near(own->skylines[0].reflectance, 0.2, 0.0);
    clear(&c);
}

static void windows_of_one_wall_have_one_skyline_by_their_areas(void **state)
{
    (void)state;
    struct compared c;
    struct pp_own_skylines found = skylines_of(
        room_of("latitude='52'",
                "<window wall='south' left='2.7' sill='1.1' width='0.5' height='1.0'/>"
                "<block x='2' y='-6' width='7' depth='2' height='5'/>"),
        &c);
    double large_m2 = 1.9 * 1.4, small_m2 = 0.5 * 1.0;
    double a = angle_of(&c, 0), b = angle_of(&c, 1);
    assert_true(fabs(a - b) > 1.0 * PP_RAD);
    assert_int_equal(found.count, 1);
    assert_near(found.list[0].angle_rad,
                (large_m2 * a + small_m2 * b) / (large_m2 + small_m2), 1e-12);
    assert_string_equal(found.list[0].wall, "south");
    pp_own_skylines_clear(&found);
    clear(&c);
}

static void a_far_skyline_of_a_fifth_is_the_formulas_own(void **state)
{
    (void)state;
    struct compared c;
    static const char *const skylines[] = {
        "<skyline wall='south' angle='23'/>",
        "<skyline wall='south' angle='23' reflectance='0.3'/>",
        "<skyline wall='south' angle='23' distance='11'/>",
        "<skyline wall='south' angle='23'/><skyline wall='west' angle='17'/>"};
    for (int i = 0; i < 4; i++) {
        struct pp_own_skylines found =
            skylines_of(room_of("latitude='52'", skylines[i]), &c);
        assert_int_equal(found.as_they_are, i == 0);
        assert_int_equal(found.count, 1);
        assert_near(found.list[0].angle_rad, 23.0 * PP_RAD, 1e-12);
        pp_own_skylines_clear(&found);
        clear(&c);
    }
}

/* `k-factor` covers a rooflight only with an unobstructed sky, and horizontal glass has
 * no wall to which a skyline could belong. */
static void before_a_rooflight_a_block_stays_where_it_is(void **state)
{
    (void)state;
    struct compared c;
    static const char rooflight[] =
        "<rooflight x='1.2' y='2.2' width='0.8' depth='0.9'/>";
    char outside[256];
    struct pp_own_skylines low = skylines_of(room_of("latitude='52'", rooflight), &c);
    assert_true(low.as_they_are);
    assert_int_equal(low.count, 0);
    pp_own_skylines_clear(&low);
    clear(&c);
    snprintf(outside, sizeof outside, "%s%s", rooflight, block);
    struct pp_own_skylines high = skylines_of(room_of("latitude='52'", outside), &c);
    assert_true(high.as_they_are);
    pp_own_skylines_clear(&high);
    clear(&c);
}

/* The west window of an L-shaped room faces a wing of the room itself. The wing remains
 * when the surroundings are removed, and is not counted as a skyline in addition. */
static void what_the_rooms_own_walls_hide_is_not_hidden_twice(void **state)
{
    (void)state;
    static const char plan[] =
        "<room version='1'><plan height='2.9'>"
        "<vertex x='0' y='0'/><vertex x='6.1' y='0'/><vertex x='6.1' y='5.3'/>"
        "<vertex x='3.1' y='5.3'/><vertex x='3.1' y='2.9'/><vertex x='0' y='2.9'/>"
        "</plan><window wall='4' left='0.4' sill='0.9' width='1.6' height='1.5'/>%s"
        "</room>";
    char xml[640];
    struct compared c;
    snprintf(xml, sizeof xml, plan, "");
    struct pp_own_skylines alone = skylines_of(xml, &c);
    double wing_rad = angle_of(&c, 0);
    assert_true(alone.as_they_are);
    assert_int_equal(alone.count, 0);
    pp_own_skylines_clear(&alone);
    clear(&c);
    snprintf(xml, sizeof xml, plan,
             "<block x='-12' y='-3' width='4' depth='15' height='8'/>");
    struct pp_own_skylines both = skylines_of(xml, &c);
    assert_int_equal(both.count, 1);
    assert_true(wing_rad > 3.0 * PP_RAD);
    assert_true(both.list[0].angle_rad > 3.0 * PP_RAD);
    assert_true(both.list[0].angle_rad < angle_of(&c, 0) - 1.0 * PP_RAD);
    pp_own_skylines_clear(&both);
    clear(&c);
}

/* The extension of the wall beyond the room counts as surroundings, like a block. */
static void a_facade_is_removed_with_the_surroundings(void **state)
{
    (void)state;
    struct compared c;
    load(&c,
         room_of("ground-reflectance='0.3'",
                 "<facade wall='south' left='6' right='5' up='9'/>"),
         "exact+bre");
    const struct pp_world *own = world_for(&c, PP_IRC, "bre", PP_IRC)->world;
    const struct pp_world *exact = world_for(&c, PP_ERC, "exact", PP_ERC)->world;
    assert_int_equal(own->surface_count, c.room.world->face_count);
    assert_int_equal(exact->surface_count, c.room.world->surface_count);
    assert_true(exact->surface_count > own->surface_count);
    clear(&c);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(assumption_and_formula_make_the_whole),
        cmocka_unit_test(the_sky_component_has_no_other_ground),
        cmocka_unit_test(only_required_components_of_a_world_are_simulated),
        cmocka_unit_test(bre_in_the_world_that_it_was_made_for_assumes_nothing_wrong),
        cmocka_unit_test(a_ground_brighter_than_bre_has_it_is_a_negative_assumption),
        cmocka_unit_test(the_own_world_is_the_room_of_a_file_that_says_so),
        cmocka_unit_test(a_pair_has_light_of_both_its_worlds),
        cmocka_unit_test(a_variant_has_the_world_of_its_method),
        cmocka_unit_test(a_block_becomes_the_skyline_of_the_same_angle),
        cmocka_unit_test(windows_of_one_wall_have_one_skyline_by_their_areas),
        cmocka_unit_test(a_far_skyline_of_a_fifth_is_the_formulas_own),
        cmocka_unit_test(before_a_rooflight_a_block_stays_where_it_is),
        cmocka_unit_test(a_facade_is_removed_with_the_surroundings),
        cmocka_unit_test(what_the_rooms_own_walls_hide_is_not_hidden_twice),
    };
    add_tests(tests, NULL, NULL);
}
