/* test_plot_envelope.c - the largest envelope on a plot. */
#include "studies/sizing/plot_envelope.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "studies/sizing/block_height.h"
#include "tests/lib/dice.h"
#include "tests/lib/near.h"
#include "tests/lib/sight.h"

#define ROOM                                                                           \
    "<room name='Study' x='0' y='0' z='1.3'><plan width='4.2' depth='5.3' "            \
    "height='2.7'/><window name='W1' wall='south' left='0.9' sill='0.8' width='2.4' "  \
    "height='1.5'/></room>"
#define ROOM_ABOVE                                                                     \
    "<room name='Attic' x='5' y='0' z='4.4'><plan width='3.1' depth='5.3' "            \
    "height='2.5'/><window name='W2' wall='south' left='0.7' sill='0.9' width='1.3' "  \
    "height='1.1'/></room>"
#define PLOT "<block name='Plot' x='-2' y='-16.5' width='11' depth='7' height='4'/>"

static struct pp_building *building_of(const char *inside)
{
    char xml[4096];
    struct pp_building *building;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "test");
    snprintf(xml, sizeof xml, "<building version='1'>%s</building>", inside);
    if (pp_building_parse(&building, xml, strlen(xml), &mistakes, NULL) != PP_OK)
        fail_msg("%s", mistakes.count ? mistakes.list[0].text : "no building");
    pp_mistakes_clear(&mistakes);
    return building;
}

static const struct pp_retained_sky_rule four_fifths = {.keep = 0.8,
                                                        .enough = INFINITY};

static struct pp_plot_envelope envelope_in(struct pp_building *building, double most_m)
{
    const struct pp_plot_envelope_task task = {
        .building = building, .block = "Plot", .rule = four_fifths, .most_m = most_m};
    struct pp_plot_envelope found;
    struct pp_error err;
    if (pp_plot_envelope_find(&found, &task, &err) != PP_OK)
        fail_msg("%s", err.message);
    return found;
}

/* For an infinitely long plot that is one cell deep, the envelope is a block of one
 * height; its plane meets the front edge of the block, 17 m in front of the middle of
 * the window at 2.85 m. */
static void over_an_endless_strip_it_is_as_high_as_a_block_may_be(void **state)
{
    (void)state;
    static const char strip[] =
        "<block name='Plot' x='-4000' y='-24' width='8000' depth='7' height='9'/>" ROOM;
    struct pp_building *building = building_of(strip), *same = building_of(strip);
    struct pp_plot_envelope found = envelope_in(building, 300.0);
    const struct pp_block_height_task task = {
        .building = same, .block = "Plot", .rule = four_fifths, .most_m = 300.0};
    struct pp_block_height block;
    assert_int_equal(pp_block_height_find(&block, &task, NULL), PP_OK);
    assert_int_equal(found.verdict, PP_PLOT_ENVELOPE_FOUND);
    assert_int_equal(found.cells.count, 12);
    for (int i = 0; i < found.cells.count; i++)
        assert_near(found.cells.list[i].height_m, block.height_m, 1e-4);
    assert_relative(found.volume_m3, 8000.0 * 7.0 * block.height_m, 1e-5);
    assert_near(tan(found.altitudes_rad[0]), (block.height_m - 2.85) / 17.0, 1e-5);
    assert_near(found.factor, 1.0, 1e-5);
    pp_block_height_clear(&block);
    pp_plot_envelope_clear(&found);
    pp_building_destroy(building);
    pp_building_destroy(same);
}

/* The middles of W1 and W2 are at z = 2.85 m and 5.85 m; rows of cells of 1 m begin 9.5
 * m in front of their wall. */
static void every_cell_ends_below_the_lowest_plane(void **state)
{
    (void)state;
    struct pp_building *building = building_of(PLOT ROOM ROOM_ABOVE);
    struct pp_plot_envelope found = envelope_in(building, 300.0);
    assert_int_equal(found.verdict, PP_PLOT_ENVELOPE_FOUND);
    assert_int_equal(found.cells.count, 77);
    double volume_m3 = 0.0;
    for (int i = 0; i < found.cells.count; i++) {
        double before_m = 15.5 - found.cells.rows_of[i];
        double first = 2.85 + before_m * tan(found.altitudes_rad[0]),
               second = 5.85 + before_m * tan(found.altitudes_rad[1]);
        assert_near(found.cells.list[i].height_m, fmin(first, second), 1e-9);
        volume_m3 += fmin(first, second);
    }
    assert_near(found.volume_m3, volume_m3, 1e-6);
    pp_plot_envelope_clear(&found);
    pp_building_destroy(building);
}

/* Ratio of the window's value to its previous value, with the heights found for the
 * cells times `by`. */
static double share_with(struct pp_building *building, struct pp_plot_envelope *found,
                         int window, double by)
{
    struct pp_building_cell *cells = calloc(found->cells.count, sizeof *cells);
    for (int i = 0; i < found->cells.count; i++) {
        cells[i] = found->cells.list[i];
        cells[i].height_m *= by;
    }
    assert_int_equal(
        pp_building_divide_block(building, "Plot", cells, found->cells.count, NULL),
        PP_OK);
    assert_int_equal(pp_building_set_state(building, PP_STATE_PROPOSED, NULL), PP_OK);
    struct pp_retained_sky retained;
    assert_int_equal(pp_retained_sky_list(&retained, &four_fifths, building, NULL),
                     PP_OK);
    double share = retained.list[window].now / found->retained.list[window].before;
    pp_retained_sky_clear(&retained);
    free(cells);
    return share;
}

static void one_window_has_just_its_due_and_none_has_less(void **state)
{
    (void)state;
    struct pp_building *building = building_of(PLOT ROOM ROOM_ABOVE);
    struct pp_plot_envelope found = envelope_in(building, 300.0);
    assert_int_equal(found.retained.count, 2);
    int decides = found.deciding;
    assert_near(share_with(building, &found, decides, 1.0), 0.8, 1e-5);
    assert_true(share_with(building, &found, 1 - decides, 1.0) > 0.8);
    assert_true(share_with(building, &found, decides, 1.01) < 0.799);
    pp_plot_envelope_clear(&found);
    pp_building_destroy(building);
}

/* Rays with a cosine density from the middle of W1, tested against every polygon: an
 * independent calculation. */
static void traced_sky_over_the_cells_agrees(void **state)
{
    (void)state;
    struct pp_building *building = building_of(PLOT ROOM);
    struct pp_plot_envelope found = envelope_in(building, 300.0);
    share_with(building, &found, 0, 1.0);
    struct pp_mistakes mistakes;
    struct pp_world *world;
    pp_mistakes_init(&mistakes, "test");
    assert_int_equal(
        pp_world_create(&world, pp_building_room(building, 0), &mistakes, NULL), PP_OK);
    enum { RAYS = 60000 };
    struct pp_vec3 eye = {2.1, -1e-6, 1.55};
    double sum = 0.0, squares = 0.0;
    struct dice dice = {7};
    for (int i = 0; i < RAYS; i++) {
        double r = sqrt(between(&dice, 0.0, 1.0)),
               az = between(&dice, 0.0, 2.0 * PP_PI);
        struct pp_vec3 u = {r * cos(az), -sqrt(1.0 - r * r), r * sin(az)};
        bool hidden = u.z <= 0.0;
        for (int k = world->face_count; k < world->surface_count && !hidden; k++)
            hidden = sight_meets(&world->surfaces[k].outline, eye, u) > 0.0;
        double value = hidden ? 0.0 : 3.0 / 7.0 * (1.0 + 2.0 * u.z);
        sum += value;
        squares += value * value;
    }
    double mean = sum / RAYS,
           error = sqrt((squares / RAYS - mean * mean) / (RAYS - 1.0));
    assert_near(mean, 0.8 * found.retained.list[0].before, 3.0 * error);
    assert_true(error < 1e-2 * mean);
    pp_world_destroy(world);
    pp_mistakes_clear(&mistakes);
    pp_plot_envelope_clear(&found);
    pp_building_destroy(building);
}

/* An L-shape of 8 m by 8 m less 4 m by 4 m, rotated by 30 degrees: 48 cells of 1 m2. */
static void cells_fill_an_l_that_is_turned(void **state)
{
    (void)state;
    struct pp_building *building = building_of(
        "<block name='Plot' x='1' y='-20' rotate='30' height='4'><vertex x='0' y='0'/>"
        "<vertex x='8' y='0'/><vertex x='8' y='4'/><vertex x='4' y='4'/>"
        "<vertex x='4' y='8'/><vertex x='0' y='8'/></block>" ROOM);
    struct pp_plot_cells cells;
    assert_int_equal(pp_plot_cells_lay(&cells, building, "Plot", NULL), PP_OK);
    assert_int_equal(cells.columns, 8);
    assert_int_equal(cells.rows, 8);
    assert_int_equal(cells.count, 48);
    double area_m2 = 0.0;
    for (int i = 0; i < cells.count; i++) {
        area_m2 += cells.list[i].width_m * cells.list[i].depth_m;
        assert_true(cells.columns_of[i] < 4 || cells.rows_of[i] < 4);
    }
    assert_near(area_m2, 48.0, 1e-9);
    assert_near(cells.list[0].corner.x, 1.0, 1e-12);
    assert_near(cells.list[0].corner.y, -20.0, 1e-12);
    struct pp_vec3 far = pp_plot_cells_corner(&cells.list[7], 2);
    assert_near(far.x, 1.0 + 8.0 * cos(PP_PI / 6.0) - 1.0 * sin(PP_PI / 6.0), 1e-9);
    assert_near(far.y, -20.0 + 8.0 * sin(PP_PI / 6.0) + 1.0 * cos(PP_PI / 6.0), 1e-9);
    pp_plot_cells_clear(&cells);
    pp_building_destroy(building);
}

static void behind_the_house_it_is_as_high_as_may_be(void **state)
{
    (void)state;
    struct pp_building *building = building_of(
        "<block name='Plot' x='0' y='9' width='9' depth='7' height='5'/>" ROOM);
    struct pp_plot_envelope found = envelope_in(building, 25.0);
    assert_int_equal(found.verdict, PP_PLOT_ENVELOPE_ANY);
    assert_near(found.volume_m3, 9.0 * 7.0 * 25.0, 1e-9);
    pp_plot_envelope_clear(&found);
    pp_building_destroy(building);
}

static void where_a_neighbour_takes_it_nothing_may_stand(void **state)
{
    (void)state;
    struct pp_building *building = building_of(
        "<block name='Plot' state='proposed' x='-2' y='-30' width='9' depth='7' "
        "height='5'/><block state='proposed' x='-40' y='-12' width='80' depth='4' "
        "height='25'/>" ROOM);
    struct pp_plot_envelope found = envelope_in(building, 300.0);
    assert_int_equal(found.verdict, PP_PLOT_ENVELOPE_NONE);
    assert_near(found.volume_m3, 0.0, 0.0);
    pp_plot_envelope_clear(&found);
    pp_building_destroy(building);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(over_an_endless_strip_it_is_as_high_as_a_block_may_be),
        cmocka_unit_test(every_cell_ends_below_the_lowest_plane),
        cmocka_unit_test(one_window_has_just_its_due_and_none_has_less),
        cmocka_unit_test(traced_sky_over_the_cells_agrees),
        cmocka_unit_test(cells_fill_an_l_that_is_turned),
        cmocka_unit_test(behind_the_house_it_is_as_high_as_may_be),
        cmocka_unit_test(where_a_neighbour_takes_it_nothing_may_stand),
    };
    add_tests(tests, NULL, NULL);
}
