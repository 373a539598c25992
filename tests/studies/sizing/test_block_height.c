/* test_block_height.c - the maximum height of a block. */
#include "studies/sizing/block_height.h"

#include <math.h>
#include <stdio.h>

#include "tests/lib/dice.h"
#include "tests/lib/near.h"
#include "tests/lib/sight.h"

#define ROOM                                                                           \
    "<room name='Study' x='0' y='0' z='1.3'><plan width='4.2' depth='5.3' "            \
    "height='2.7'/><window name='W1' wall='south' left='0.9' sill='0.8' width='2.4' "  \
    "height='1.5'/></room>"
/* Practically infinite: the sky above it depends only on its altitude. */
#define TERRACE(state, height)                                                         \
    "<block name='Terrace' " state " x='-4000' y='-24' width='8000' depth='7' "        \
    "height='" height "'/>"

static struct pp_building *building_of(const char *inside)
{
    char xml[2048];
    struct pp_building *building;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "test");
    snprintf(xml, sizeof xml, "<building version='1'>%s</building>", inside);
    if (pp_building_parse(&building, xml, strlen(xml), &mistakes, NULL) != PP_OK)
        fail_msg("%s", mistakes.count ? mistakes.list[0].text : "no building");
    pp_mistakes_clear(&mistakes);
    return building;
}

static struct pp_block_height height_by(struct pp_building *building,
                                        struct pp_retained_sky_rule rule)
{
    const struct pp_block_height_task task = {
        .building = building, .block = "Terrace", .rule = rule, .most_m = 300.0};
    struct pp_block_height found;
    struct pp_error err;
    if (pp_block_height_find(&found, &task, &err) != PP_OK)
        fail_msg("%s", err.message);
    return found;
}

static struct pp_block_height height_in(struct pp_building *building, double keep)
{
    return height_by(building,
                     (struct pp_retained_sky_rule){.keep = keep, .enough = INFINITY});
}

/* Vertical sky component in front of an infinitely long obstruction of altitude a:
 *
 *    3/(7 pi) int int (1 + 2 sin g) cos^2 g cos z dg dz,  tan g_low = tan a cos z
 *
 * over azimuths z in front of the wall and altitudes g above the edge, by Simpson's
 * rule.
 */
static double component_over(double a)
{
    enum { N = 400 };
    double sum = 0.0;
    for (int i = 0; i <= N; i++) {
        double az = PP_PI * ((double)i / N - 0.5), low = atan(tan(a) * cos(az));
        double part = 0.0;
        for (int k = 0; k <= N; k++) {
            double g = low + (PP_PI / 2.0 - low) * k / N;
            part += (k == 0 || k == N ? 1
                     : k % 2          ? 4
                                      : 2)
                    * (1.0 + 2.0 * sin(g)) * cos(g) * cos(g) * cos(az);
        }
        part *= (PP_PI / 2.0 - low) / N / 3.0;
        sum += (i == 0 || i == N ? 1 : i % 2 ? 4 : 2) * part;
    }
    return 3.0 / (7.0 * PP_PI) * sum * PP_PI / N / 3.0;
}

/* The middle of the window is 1.3 + 0.8 + 0.75 m up, the front of the block 17 m
 * away. */
static void an_endless_terrace_may_rise_to_the_altitude_that_leaves_0_8(void **state)
{
    (void)state;
    struct pp_building *building = building_of(TERRACE("", "9") ROOM);
    struct pp_block_height found = height_in(building, 0.8);
    assert_int_equal(found.verdict, PP_BLOCK_HEIGHT_FOUND);
    assert_near(found.now_m, 9.0, 1e-12);
    double whole = component_over(0.0);
    assert_near(whole, 0.396177, 2e-6);
    assert_near(found.retained.list[0].before, whole, 2e-6);
    double altitude = atan2(found.height_m - 2.85, 17.0);
    assert_near(component_over(altitude), 0.8 * whole, 1e-5);
    assert_near(found.retained.list[0].after / found.retained.list[0].before, 0.8,
                1e-5);
    pp_block_height_clear(&found);
    pp_building_destroy(building);
}

/* Rays with a cosine density tested against every polygon: an independent
 * calculation. */
static void traced_sky_at_that_height_agrees(void **state)
{
    (void)state;
    struct pp_building *building = building_of(
        "<block name='Terrace' x='-7' y='-16' width='23' depth='7' height='5' "
        "roof='gable' pitch='35'/>"
        "<block x='-22' y='-20' width='9' depth='17' height='12'/>" ROOM);
    struct pp_block_height found = height_in(building, 0.8);
    assert_int_equal(found.verdict, PP_BLOCK_HEIGHT_FOUND);
    pp_building_set_block_height(building, "Terrace", found.height_m);
    assert_int_equal(pp_building_set_state(building, PP_STATE_PROPOSED, NULL), PP_OK);
    struct pp_mistakes mistakes;
    struct pp_world *world;
    pp_mistakes_init(&mistakes, "test");
    assert_int_equal(
        pp_world_create(&world, pp_building_room(building, 0), &mistakes, NULL), PP_OK);
    enum { RAYS = 200000 };
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
    assert_true(error < 4e-3 * mean);
    pp_world_destroy(world);
    pp_mistakes_clear(&mistakes);
    pp_block_height_clear(&found);
    pp_building_destroy(building);
}

/* Existing obstructions reduce the previous value: less must be retained, so the block
 * that replaces them may be higher than on an empty plot. */
static void before_is_the_site_as_existing(void **state)
{
    (void)state;
    struct pp_building *empty = building_of(TERRACE("state='proposed'", "9") ROOM);
    struct pp_building *built = building_of(
        TERRACE("state='proposed'", "9") "<block state='existing' x='-4000' "
                                         "y='-24' width='8000' depth='7' "
                                         "height='6.1'/>" ROOM);
    struct pp_block_height on_empty = height_in(empty, 0.8),
                           on_built = height_in(built, 0.8);
    assert_true(on_built.height_m > on_empty.height_m + 1.0);
    assert_near(on_built.retained.list[0].before,
                component_over(atan2(6.1 - 2.85, 17.0)), 2e-6);
    pp_block_height_clear(&on_empty);
    pp_block_height_clear(&on_built);
    pp_building_destroy(empty);
    pp_building_destroy(built);
}

static void behind_the_house_it_may_be_any_height(void **state)
{
    (void)state;
    struct pp_building *building = building_of(
        "<block name='Terrace' x='0' y='9' width='9' depth='7' height='5'/>" ROOM);
    struct pp_block_height found = height_in(building, 0.99);
    assert_int_equal(found.verdict, PP_BLOCK_HEIGHT_ANY);
    assert_near(found.retained.list[0].after, found.retained.list[0].before, 1e-12);
    pp_block_height_clear(&found);
    pp_building_destroy(building);
}

/* From a point on the plane behind the window, the sky above an infinitely long terrace
 * begins where the head of the window and the edge of the terrace are in line, at any
 * azimuth: at the depth d,
 *
 *    (head - plane) / d = (edge - plane) / (d + 17 m)
 *
 * At 0.8 of the room's 5.3 m, with the plane 0.85 m above the floor at 1.3 m, the edge
 * is 1.45 m (1 + 17 m / d) above the plane. The line is accurate to a millimetre, which
 * is 1.4 mm of height.
 */
static void the_no_sky_line_moves_as_similar_triangles_tell(void **state)
{
    (void)state;
    struct pp_building *building = building_of(TERRACE("", "9") ROOM);
    struct pp_block_height found = height_by(
        building, (struct pp_retained_sky_rule){
                      .of = PP_RETAINED_SKY_LIT_AREA, .keep = 0.8, .enough = INFINITY});
    assert_int_equal(found.verdict, PP_BLOCK_HEIGHT_FOUND);
    assert_int_equal(found.deciding, 0);
    assert_string_equal(found.retained.list[0].room, "Study");
    assert_near(found.retained.list[0].before, 4.2 * 5.3, 1e-6);
    assert_near(found.retained.list[0].now, 4.2 * 1.45 * 17.0 / (9.0 - 2.15 - 1.45),
                5e-3);
    assert_near(found.retained.list[0].after / found.retained.list[0].before, 0.8,
                1e-4);
    assert_near(found.height_m, 2.15 + 1.45 * (1.0 + 17.0 / (0.8 * 5.3)), 4e-3);
    pp_block_height_clear(&found);
    pp_building_destroy(building);
}

/* 27 % is less than 0.8 of the unobstructed value, 31.7 %; if 27 % is sufficient, the
 * terrace may be higher. */
static void a_window_with_enough_is_due_no_more(void **state)
{
    (void)state;
    struct pp_building *building = building_of(TERRACE("", "9") ROOM);
    struct pp_block_height found =
        height_by(building, (struct pp_retained_sky_rule){.keep = 0.8, .enough = 0.27});
    assert_int_equal(found.verdict, PP_BLOCK_HEIGHT_FOUND);
    double altitude = atan2(found.height_m - 2.85, 17.0);
    assert_near(component_over(altitude), 0.27, 5e-6);
    assert_near(altitude / PP_RAD, 25.0, 0.8); /* the rule of thumb of [BR209] */
    pp_block_height_clear(&found);
    pp_building_destroy(building);
}

/* Another block already hides more than allowed. */
static void where_a_neighbour_takes_it_no_height_will_do(void **state)
{
    (void)state;
    struct pp_building *building = building_of(
        TERRACE("", "9") "<block state='proposed' x='-40' y='-12' width='80' depth='4' "
                         "height='25'/>" ROOM);
    struct pp_block_height found = height_in(building, 0.8);
    assert_int_equal(found.verdict, PP_BLOCK_HEIGHT_NONE);
    assert_true(isnan(found.height_m));
    pp_block_height_clear(&found);
    pp_building_destroy(building);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_endless_terrace_may_rise_to_the_altitude_that_leaves_0_8),
        cmocka_unit_test(the_no_sky_line_moves_as_similar_triangles_tell),
        cmocka_unit_test(a_window_with_enough_is_due_no_more),
        cmocka_unit_test(traced_sky_at_that_height_agrees),
        cmocka_unit_test(before_is_the_site_as_existing),
        cmocka_unit_test(behind_the_house_it_may_be_any_height),
        cmocka_unit_test(where_a_neighbour_takes_it_no_height_will_do),
    };
    add_tests(tests, NULL, NULL);
}
