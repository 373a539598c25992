/* test_size.c - the window that reaches a target: possible sizes, and the search among
 * them, with made-up values and with daylight factors. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "studies/room_value.h"
#include "studies/sizing/size.h"
#include "methods/evaluate.h"
#include "model/room/building.h"
#include "model/room/room_light.h"
#include "tests/lib/near.h"

/* ---- rooms ---- */

#define ROOM(windows)                                                                  \
    "<room version='1'><plan width='4.1' depth='5.3' height='2.7'/>"                   \
    "<finishes floor='0.3' walls='0.5' ceiling='0.7'/>" windows "</room>"

static struct pp_building *parse(const char *xml)
{
    struct pp_building *building = NULL;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "test");
    assert_int_equal(pp_building_parse(&building, xml, strlen(xml), &mistakes, NULL),
                     PP_OK);
    pp_mistakes_clear(&mistakes);
    return building;
}

static void assert_sound(const struct pp_room *room)
{
    bool sound;
    assert_int_equal(pp_room_is_sound(&sound, room, NULL), PP_OK);
    assert_true(sound);
}

static struct pp_opening_place place(const struct pp_room *room, int index)
{
    return pp_room_opening_at(room, index).place;
}

/* ---- made-up values ---- */

/* Area of all openings (m2) divided by 100 m2. */
static enum pp_status area(void *data, const struct pp_world *world,
                           struct pp_reading *reading, struct pp_error *err)
{
    (void)data, (void)err;
    double sum = 0.0;
    for (int i = 0; i < world->opening_count; i++)
        sum += world->openings[i].width_m * world->openings[i].height_m;
    *reading = pp_reading_of(sum / 100.0);
    return PP_OK;
}

/* Width of the first opening (m), rounded down to thirds of a metre, divided by 100 m. */
static enum pp_status thirds(void *data, const struct pp_world *world,
                             struct pp_reading *reading, struct pp_error *err)
{
    (void)data, (void)err;
    *reading =
        pp_reading_of(floor(3.0 * world->openings[0].width_m + 1e-9) / 3.0 / 100.0);
    return PP_OK;
}

/* A value that increases with the first opening's width up to 2.2 m and then
 * decreases. */
static enum pp_status tent(void *data, const struct pp_world *world,
                           struct pp_reading *reading, struct pp_error *err)
{
    (void)data, (void)err;
    double width_m = world->openings[0].width_m;
    *reading = pp_reading_of(fmin(width_m, 4.4 - width_m) / 100.0);
    return PP_OK;
}

static enum pp_status constant(void *data, const struct pp_world *world,
                               struct pp_reading *reading, struct pp_error *err)
{
    (void)data, (void)world, (void)err;
    *reading = pp_reading_of(0.02);
    return PP_OK;
}

/* The first opening's width divided by 100 m, with a deviation of at most 1 % and a
 * standard error of 1 %. */
static enum pp_status sampled(void *data, const struct pp_world *world,
                              struct pp_reading *reading, struct pp_error *err)
{
    (void)data, (void)err;
    double width_m = world->openings[0].width_m;
    double chance = fmod(fabs(sin(1e4 * width_m)) * 1e4, 2.0) - 1.0; /* -1 to 1 */
    *reading = pp_reading_of(width_m / 100.0 * (1.0 + 0.01 * chance));
    reading->std_error = 0.01 * width_m / 100.0;
    return PP_OK;
}

static struct pp_size_answer find(const struct pp_building *building,
                                  enum pp_size_change change, int opening_count,
                                  double target, pp_size_value *value)
{
    static const int openings[] = {0, 1, 2, 3};
    const struct pp_size_task task = {
        .room = pp_building_room((struct pp_building *)building, 0),
        .change = change,
        .openings = openings,
        .opening_count = opening_count,
        .target = target,
        .by_counts = value == thirds,
        .value = value};
    struct pp_size_answer answer;
    struct pp_error err = {0};
    if (pp_size_find(&answer, &task, &err) != PP_OK)
        fail_msg("%s", err.message);
    if (answer.room)
        assert_sound(answer.room);
    return answer;
}

static void a_width_is_the_area_wanted_over_the_height(void **state)
{
    (void)state;
    struct pp_building *building = parse(
        ROOM("<window wall='south' left='1.3' sill='0.9' width='1.3' height='1.2'/>"));
    struct pp_size_answer answer = find(building, PP_CHANGE_WIDTH, 1, 0.019, area);
    assert_int_equal(answer.verdict, PP_SIZE_REACHED);
    /* 1.9 / 1.2 = 1.58333, rounded up to a millimetre, about the middle at 1.95. */
    assert_near(place(answer.room, 0).width_m, 1.584, 1e-9);
    assert_near(place(answer.room, 0).left_m, 1.158, 1e-9);
    assert_true(place(answer.room, 0).sill_m == 0.9);
    assert_true(place(answer.room, 0).height_m == 1.2);
    assert_near(answer.reading.value, 0.01584 * 1.2, 1e-9);
    assert_near(answer.now.value, 0.0156, 1e-12);
    pp_size_answer_clear(&answer);

    answer = find(building, PP_CHANGE_WIDTH, 1, 0.007, area);
    assert_near(place(answer.room, 0).width_m, 0.584, 1e-9);
    pp_size_answer_clear(&answer);
    pp_building_destroy(building);
}

static void an_edge_at_the_walls_end_stays_and_the_other_goes_on(void **state)
{
    (void)state;
    struct pp_building *building = parse(
        ROOM("<window wall='south' left='0.2' sill='0.9' width='1' height='1'/>"));
    struct pp_size_answer answer = find(building, PP_CHANGE_WIDTH, 1, 0.02, area);
    assert_near(place(answer.room, 0).left_m, 0.0, 1e-9);
    assert_near(place(answer.room, 0).width_m, 2.0, 1e-9);
    pp_size_answer_clear(&answer);
    answer = find(building, PP_CHANGE_WIDTH, 1, 0.05, area);
    assert_int_equal(answer.verdict, PP_SIZE_OUT_OF_REACH);
    assert_true(answer.is_largest);
    assert_near(place(answer.room, 0).width_m, 4.1, 1e-9);
    assert_near(answer.reading.value, 0.041, 1e-9);
    pp_size_answer_clear(&answer);
    pp_building_destroy(building);
}

static void windows_grow_in_proportion_until_they_meet(void **state)
{
    (void)state;
    struct pp_building *building = parse(
        ROOM("<window wall='south' left='0.5' sill='0.9' width='1' height='1'/>"
             "<window wall='south' left='2.5' sill='0.9' width='0.5' height='1'/>"));
    struct pp_size_answer answer = find(building, PP_CHANGE_WIDTH, 2, 0.018, area);
    assert_near(place(answer.room, 0).width_m, 1.2, 0.0021);
    assert_near(place(answer.room, 1).width_m, 0.6, 0.002);
    pp_size_answer_clear(&answer);
    answer = find(building, PP_CHANGE_WIDTH, 2, 0.05, area);
    struct pp_opening_place a = place(answer.room, 0), b = place(answer.room, 1);
    /* Their sides, 1 m apart, meet at 2.33 times the widths, at two thirds of the way
     * from the wider one; then each extends to its end of the wall. */
    assert_near(a.left_m, 0.0, 1e-9);
    assert_near(a.left_m + a.width_m, 1.5 + 2.0 / 3.0, 0.003);
    assert_near(b.left_m, a.left_m + a.width_m, 0.003);
    assert_near(b.left_m + b.width_m, 4.1, 1e-9);
    pp_size_answer_clear(&answer);
    pp_building_destroy(building);
}

static void what_does_not_change_is_an_obstacle_and_stays_to_the_bit(void **state)
{
    (void)state;
    struct pp_building *building = parse(
        ROOM("<window wall='south' left='0.5' sill='0.9' width='1' height='1'/>"
             "<window wall='south' left='2.1' sill='1.7' width='0.7' height='0.6'/>"
             "<window wall='north' left='0.1' sill='0.3' width='0.7' height='0.6'/>"));
    struct pp_size_answer answer = find(building, PP_CHANGE_WIDTH, 1, 0.05, area);
    struct pp_opening_place a = place(answer.room, 0);
    assert_near(a.left_m, 0.0, 1e-9);
    assert_near(a.width_m, 2.1, 1e-9);
    for (int i = 1; i < 3; i++) {
        struct pp_opening_place was = place(pp_building_room(building, 0), i);
        struct pp_opening_place is = place(answer.room, i);
        assert_memory_equal(&was, &is, sizeof is);
    }
    pp_size_answer_clear(&answer);
    pp_building_destroy(building);
}

static void heads_rise_and_sills_fall_and_the_height_does_first_one_then_the_other(
    void **state)
{
    (void)state;
    struct pp_building *building = parse(
        ROOM("<window wall='south' left='1' sill='0.9' width='2' height='1.2'/>"));
    struct pp_size_answer answer = find(building, PP_CHANGE_HEAD, 1, 0.03, area);
    assert_near(place(answer.room, 0).height_m, 1.5, 1e-9);
    assert_true(place(answer.room, 0).sill_m == 0.9);
    pp_size_answer_clear(&answer);

    answer = find(building, PP_CHANGE_SILL, 1, 0.03, area);
    assert_near(place(answer.room, 0).height_m, 1.5, 1e-9);
    assert_near(place(answer.room, 0).sill_m, 0.6, 1e-9);
    pp_size_answer_clear(&answer);

    /* 1.8 m up to the ceiling, and 0.3 m more below. */
    answer = find(building, PP_CHANGE_HEIGHT, 1, 0.042, area);
    assert_near(place(answer.room, 0).height_m, 2.1, 1e-9);
    assert_near(place(answer.room, 0).sill_m, 0.6, 1e-9);
    pp_size_answer_clear(&answer);

    answer = find(building, PP_CHANGE_HEIGHT, 1, 0.01, area);
    assert_near(place(answer.room, 0).height_m, 0.5, 1e-9);
    assert_near(place(answer.room, 0).sill_m, 0.9, 1e-9);
    pp_size_answer_clear(&answer);

    answer = find(building, PP_CHANGE_HEAD, 1, 0.04, area);
    assert_int_equal(answer.verdict, PP_SIZE_OUT_OF_REACH);
    assert_near(answer.reading.value, 0.036, 1e-9);
    pp_size_answer_clear(&answer);
    pp_building_destroy(building);
}

static void a_rooflight_has_width_and_depth(void **state)
{
    (void)state;
    struct pp_building *building =
        parse(ROOM("<rooflight x='1.1' y='2.3' width='0.8' depth='0.9'/>"));
    struct pp_size_answer answer = find(building, PP_CHANGE_HEIGHT, 1, 0.012, area);
    assert_near(place(answer.room, 0).height_m, 1.5, 1e-9);
    assert_near(place(answer.room, 0).sill_m, 2.0, 1e-9);
    pp_size_answer_clear(&answer);
    answer = find(building, PP_CHANGE_WIDTH, 1, 0.018, area);
    assert_near(place(answer.room, 0).width_m, 2.0, 1e-9);
    assert_near(place(answer.room, 0).left_m, 0.5, 1e-9);
    pp_size_answer_clear(&answer);

    struct pp_window_sizes *sizes;
    struct pp_error err;
    int first = 0;
    assert_int_equal(pp_window_sizes_create(&sizes, pp_building_room(building, 0),
                                            PP_CHANGE_SILL, &first, 1, &err),
                     PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "rooflight"));
    pp_building_destroy(building);
}

static void a_coarse_millimetre_is_divided(void **state)
{
    (void)state;
    struct pp_building *building = parse(
        ROOM("<window wall='south' left='1.3' sill='0.9' width='1.3' height='1.2'/>"));
    /* 61.83 mm: 62 mm would be 0.27 % too large. */
    struct pp_size_answer answer = find(building, PP_CHANGE_WIDTH, 1, 0.0007420, area);
    assert_int_equal(answer.verdict, PP_SIZE_REACHED);
    assert_true(answer.reading.value >= 0.0007420);
    assert_relative(answer.reading.value, 0.0007420, 0.0025);
    assert_near(place(answer.room, 0).width_m, 0.0619, 0.00011);
    pp_size_answer_clear(&answer);
    pp_building_destroy(building);
}

static void a_counted_value_has_the_smallest_millimetre_that_reaches_it(void **state)
{
    (void)state;
    struct pp_building *building = parse(
        ROOM("<window wall='south' left='1.3' sill='0.9' width='1.3' height='1.2'/>"));
    struct pp_size_answer answer = find(building, PP_CHANGE_WIDTH, 1, 0.0195, thirds);
    assert_int_equal(answer.verdict, PP_SIZE_REACHED);
    assert_near(place(answer.room, 0).width_m, 2.0, 1e-9);
    pp_size_answer_clear(&answer);
    pp_building_destroy(building);
}

static void a_value_that_falls_again_is_reached_on_its_way_up(void **state)
{
    (void)state;
    struct pp_building *building = parse(
        ROOM("<window wall='south' left='1.3' sill='0.9' width='1.3' height='1.2'/>"));
    struct pp_size_answer answer = find(building, PP_CHANGE_WIDTH, 1, 0.017, tent);
    assert_int_equal(answer.verdict, PP_SIZE_REACHED);
    assert_near(place(answer.room, 0).width_m, 1.7, 0.0011);
    pp_size_answer_clear(&answer);
    answer = find(building, PP_CHANGE_WIDTH, 1, 0.03, tent);
    assert_int_equal(answer.verdict, PP_SIZE_OUT_OF_REACH);
    assert_false(answer.is_largest);
    /* The best size tried is at most half a step of 4.1 m / 8 from the best one. */
    assert_near(answer.reading.value, 0.022, 0.003);
    pp_size_answer_clear(&answer);
    pp_building_destroy(building);
}

static void a_change_that_does_nothing_reaches_nothing(void **state)
{
    (void)state;
    struct pp_building *building = parse(
        ROOM("<window wall='south' left='1.3' sill='0.9' width='1.3' height='1.2'/>"));
    struct pp_size_answer answer = find(building, PP_CHANGE_HEAD, 1, 0.03, constant);
    assert_int_equal(answer.verdict, PP_SIZE_OUT_OF_REACH);
    assert_true(answer.reading.value == answer.now.value);
    pp_size_answer_clear(&answer);
    answer = find(building, PP_CHANGE_HEAD, 1, 0.01, constant);
    assert_int_equal(answer.verdict, PP_SIZE_SMALLEST_EXCEEDS);
    assert_near(place(answer.room, 0).height_m, PP_SIZE_LEAST_M, 1e-9);
    pp_size_answer_clear(&answer);
    pp_building_destroy(building);
}

static void a_sampled_value_is_within_half_a_standard_error_after_few_looks(
    void **state)
{
    (void)state;
    struct pp_building *building = parse(
        ROOM("<window wall='south' left='1.3' sill='0.9' width='1.3' height='1.2'/>"));
    for (double target = 0.0031; target < 0.04; target *= 1.17) {
        struct pp_size_answer answer =
            find(building, PP_CHANGE_WIDTH, 1, target, sampled);
        assert_int_equal(answer.verdict, PP_SIZE_REACHED);
        double width_m = place(answer.room, 0).width_m;
        /* Half a standard error, and at most one more by chance. */
        assert_near(width_m / 100.0, target, 1.6 * 0.01 * target);
        assert_in_range(answer.evaluations, 1, 25);
        pp_size_answer_clear(&answer);
    }
    pp_building_destroy(building);
}

/* Number of sizes tried with a first opening of more than 1.45 m. */
static int wide_tried;

/* The first opening's width divided by 100 m. */
static enum pp_status noted_width(void *data, const struct pp_world *world,
                                  struct pp_reading *reading, struct pp_error *err)
{
    (void)data, (void)err;
    wide_tried += world->openings[0].width_m > 1.45;
    *reading = pp_reading_of(world->openings[0].width_m / 100.0);
    return PP_OK;
}

/* The scan has steps of an eighth of the wall's 4.1 m: 1.45 m is one step beyond the
 * sufficient 0.93 m. */
static void beyond_the_first_sufficient_size_only_the_largest_is_tried(void **state)
{
    (void)state;
    struct pp_building *building = parse(
        ROOM("<window wall='south' left='1.3' sill='0.9' width='0.6' height='1.2'/>"));
    wide_tried = 0;
    struct pp_size_answer answer =
        find(building, PP_CHANGE_WIDTH, 1, 0.0093, noted_width);
    assert_near(place(answer.room, 0).width_m, 0.93, 0.003);
    assert_near(answer.largest.value, 0.041, 1e-9);
    assert_int_equal(wide_tried, 1);
    pp_size_answer_clear(&answer);
    pp_building_destroy(building);
}

/* ---- numbers of windows ---- */

static void windows_stand_in_the_middle_of_their_shares_of_the_wall(void **state)
{
    (void)state;
    struct pp_building *building = parse(
        ROOM("<window wall='south' left='0.4' sill='0.9' width='0.7' height='1.2'/>"));
    struct pp_size_answer answer = find(building, PP_CHANGE_NUMBER, 1, 0.021, area);
    assert_int_equal(answer.verdict, PP_SIZE_REACHED);
    assert_int_equal(pp_room_opening_count(answer.room), 3);
    for (int i = 0; i < 3; i++) {
        assert_near(place(answer.room, i).left_m, 4.1 * (i + 0.5) / 3.0 - 0.35,
                    0.00051);
        assert_true(place(answer.room, i).width_m == 0.7);
    }
    pp_size_answer_clear(&answer);
    answer = find(building, PP_CHANGE_NUMBER, 1, 0.2, area);
    assert_int_equal(answer.verdict, PP_SIZE_OUT_OF_REACH);
    assert_int_equal(pp_room_opening_count(answer.room), 5); /* 4.1 / 0.7 = 5.9 */
    pp_size_answer_clear(&answer);
    answer = find(building, PP_CHANGE_NUMBER, 1, 0.001, area);
    assert_int_equal(answer.verdict, PP_SIZE_REACHED);
    assert_true(place(answer.room, 0).left_m
                == 0.4); /* its position is already the middle */
    pp_size_answer_clear(&answer);
    pp_building_destroy(building);
}

static void fewer_windows_leave_out_the_last(void **state)
{
    (void)state;
    struct pp_building *building = parse(
        ROOM("<window wall='south' left='0.4' sill='0.9' width='0.7' height='1.2'/>"
             "<window wall='south' left='1.4' sill='0.9' width='0.7' height='1.2'/>"
             "<window wall='south' left='2.4' sill='0.9' width='0.7' height='1.2'/>"
             "<window wall='east' left='1' sill='1' width='1' height='1'/>"));
    struct pp_size_answer answer = find(building, PP_CHANGE_NUMBER, 3, 0.018, area);
    assert_int_equal(answer.verdict, PP_SIZE_REACHED);
    assert_int_equal(pp_room_opening_count(answer.room), 2);
    assert_near(place(answer.room, 0).left_m, 1.7, 1e-9);
    assert_string_equal(pp_room_opening_at(answer.room, 1).wall, "east");
    pp_size_answer_clear(&answer);
    pp_building_destroy(building);
}

static void windows_that_are_not_alike_have_no_number(void **state)
{
    (void)state;
    struct pp_building *building = parse(
        ROOM("<window wall='south' left='0.4' sill='0.9' width='0.7' height='1.2'/>"
             "<window wall='south' left='1.4' sill='0.9' width='0.8' height='1.2'/>"
             "<window wall='east' left='1' sill='0.9' width='0.7' height='1.2'/>"));
    const int sizes_differ[] = {0, 1}, walls_differ[] = {0, 2};
    struct pp_window_sizes *sizes;
    struct pp_error err;
    const struct pp_room *room = pp_building_room(building, 0);
    assert_int_equal(
        pp_window_sizes_create(&sizes, room, PP_CHANGE_NUMBER, sizes_differ, 2, &err),
        PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "differ in size"));
    assert_int_equal(
        pp_window_sizes_create(&sizes, room, PP_CHANGE_NUMBER, walls_differ, 2, &err),
        PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "different walls"));
    pp_building_destroy(building);
}

/* ---- steps ---- */

static double low_edge(struct pp_opening_place p, enum pp_size_change change)
{
    return change == PP_CHANGE_WIDTH ? p.left_m : p.sill_m;
}

static double high_edge(struct pp_opening_place p, enum pp_size_change change)
{
    return change == PP_CHANGE_WIDTH ? p.left_m + p.width_m : p.sill_m + p.height_m;
}

/* Asserts at some of the steps, the last included, that the room has no mistakes, and
 * that each window is inside that of the next of the steps tried. */
static void check_steps(const char *xml, enum pp_size_change change, int count)
{
    static const int openings[] = {0, 1, 2, 3};
    struct pp_building *building = parse(xml);
    const struct pp_room *room = pp_building_room(building, 0);
    struct pp_window_sizes *sizes;
    struct pp_error err = {0};
    if (pp_window_sizes_create(&sizes, room, change, openings, count, &err) != PP_OK)
        fail_msg("%s", err.message);
    int last = pp_window_sizes_count(sizes) - 1;
    struct pp_room *smaller = NULL;
    for (int step = 0; step <= last; step += step < last - 13 ? 13 : 1) {
        struct pp_room *larger;
        assert_int_equal(pp_window_sizes_room(&larger, sizes, step, &err), PP_OK);
        if (step % 10 == 0 || step == last)
            assert_sound(larger);
        for (int i = 0; i < count && smaller; i++) {
            struct pp_opening_place a = place(smaller, i), b = place(larger, i);
            assert_true(low_edge(b, change) <= low_edge(a, change));
            assert_true(high_edge(b, change) >= high_edge(a, change) - 1e-12);
        }
        pp_room_destroy(smaller);
        smaller = larger;
    }
    pp_room_destroy(smaller);

    struct pp_room *now;
    assert_int_equal(
        pp_window_sizes_room(&now, sizes, pp_window_sizes_now(sizes), &err), PP_OK);
    for (int i = 0; i < count; i++) {
        struct pp_opening_place was = place(room, i), is = place(now, i);
        assert_memory_equal(&was, &is, sizeof is);
    }
    pp_room_destroy(now);
    pp_window_sizes_destroy(sizes);
    pp_building_destroy(building);
}

static void each_size_can_be_and_lies_within_the_next(void **state)
{
    (void)state;
    static const char three[] =
        ROOM("<window wall='south' left='0.237' sill='0.9' width='1.13' height='1.2'/>"
             "<window wall='south' left='1.9001' sill='0.3' width='0.71' height='1.9'/>"
             "<window wall='east' left='0' sill='1.00037' width='3.3' height='0.8'/>");
    static const char gable[] =
        "<room version='1'><envelope>"
        "<face role='floor' name='f'><vertex x='0' y='0' z='0'/><vertex x='4' y='0' "
        "z='0'/><vertex x='4' y='3' z='0'/><vertex x='0' y='3' z='0'/></face>"
        "<face role='wall' name='front'><vertex x='0' y='0' z='0'/><vertex x='0' y='0' "
        "z='2'/><vertex x='2' y='0' z='3.7'/><vertex x='4' y='0' z='2'/>"
        "<vertex x='4' y='0' z='0'/></face>"
        "<face role='wall' name='back'><vertex x='0' y='3' z='0'/><vertex x='4' y='3' "
        "z='0'/><vertex x='4' y='3' z='2'/><vertex x='2' y='3' z='3.7'/>"
        "<vertex x='0' y='3' z='2'/></face>"
        "<face role='wall' name='left'><vertex x='0' y='0' z='0'/><vertex x='0' y='3' "
        "z='0'/><vertex x='0' y='3' z='2'/><vertex x='0' y='0' z='2'/></face>"
        "<face role='wall' name='right'><vertex x='4' y='0' z='0'/><vertex x='4' y='0' "
        "z='2'/><vertex x='4' y='3' z='2'/><vertex x='4' y='3' z='0'/></face>"
        "<face role='ceiling' name='r1'><vertex x='0' y='0' z='2'/><vertex x='0' y='3' "
        "z='2'/><vertex x='2' y='3' z='3.7'/><vertex x='2' y='0' z='3.7'/></face>"
        "<face role='ceiling' name='r2'><vertex x='4' y='0' z='2'/><vertex x='2' y='0' "
        "z='3.7'/><vertex x='2' y='3' z='3.7'/><vertex x='4' y='3' z='2'/></face>"
        "</envelope>"
        "<window wall='front' left='1.5' sill='1' width='0.9' height='1.3'/></room>";
    for (int change = PP_CHANGE_WIDTH; change <= PP_CHANGE_SILL; change++) {
        check_steps(three, (enum pp_size_change)change, 3);
        check_steps(gable, (enum pp_size_change)change, 1);
    }
}

/* ---- daylight factors ---- */

static struct pp_outside_light light_of(struct pp_building *building)
{
    struct pp_outside_light light;
    assert_int_equal(pp_room_light(&light, pp_building_room(building, 0), NULL), PP_OK);
    return light;
}

static enum pp_status by_method(void *data, const struct pp_world *world,
                                struct pp_reading *reading, struct pp_error *err)
{
    return pp_room_value(data, world, reading, err);
}

/* Daylight factor of a room by a method, without pp_room_value. */
static double told(const struct pp_room *room, const char *method,
                   const struct pp_receiver *point)
{
    struct pp_mistakes mistakes;
    struct pp_world *world;
    struct pp_outside_light light;
    pp_mistakes_init(&mistakes, "test");
    assert_int_equal(pp_world_create(&world, room, &mistakes, NULL), PP_OK);
    assert_int_equal(pp_room_light(&light, room, NULL), PP_OK);
    pp_mistakes_clear(&mistakes);
    struct pp_report report = {.world = world,
                               .light = light,
                               .receivers = point,
                               .receiver_count = point ? 1 : 0};
    assert_int_equal(pp_methods_evaluate(&report, method, NULL), PP_OK);
    const struct pp_column *df = pp_report_find(&report, PP_DF, method);
    double value = point ? df->points[0].value : df->average.value;
    pp_report_clear(&report);
    pp_world_destroy(world);
    return value;
}

static const char two_sided[] =
    "<room version='1'><plan width='4.1' depth='6.3' height='2.9'/>"
    "<finishes floor='0.3' walls='0.6' ceiling='0.8'/>"
    "<window wall='south' left='1.1' sill='0.9' width='1.7' height='1.4' "
    "glazing='clear-double' frame-factor='0.8' maintenance='0.9'/>"
    "<window wall='north' left='0.7' sill='1.2' width='0.8' height='1.1' "
    "glazing='clear-double' frame-factor='0.8'/>"
    "<skyline wall='south' angle='17'/>"
    "<working-plane height='0.85'/></room>";

static void continuous_methods_reach_the_target_within_half_a_per_cent(void **state)
{
    (void)state;
    static const struct {
        const char *method;
        double target;
        enum pp_size_change change;
        bool point;
    } cases[] = {
        {"exact+bre", 0.013, PP_CHANGE_WIDTH, false},
        {"exact+bre", 0.027, PP_CHANGE_HEIGHT, false},
        {"exact+split-flux", 0.02, PP_CHANGE_WIDTH, true},
        {"brs-table+bre", 0.016, PP_CHANGE_WIDTH, true},
        {"average-df", 0.011, PP_CHANGE_HEAD, false},
        {"average-df", 0.017, PP_CHANGE_SILL, false},
    };
    const struct pp_receiver point = {{1.9, 2.7, 0.85}, {0.0, 0.0, 1.0}, 0, 0.0};
    const int both[] = {0, 1};
    struct pp_building *building = parse(two_sided);
    const struct pp_outside_light light = light_of(building);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct pp_room_value value = {.light = &light,
                                      .method = cases[i].method,
                                      .points = &point,
                                      .point_count = cases[i].point};
        const struct pp_size_task task = {.room = pp_building_room(building, 0),
                                          .change = cases[i].change,
                                          .openings = both,
                                          .opening_count = 1 + (int)(i % 2),
                                          .target = cases[i].target,
                                          .value = by_method,
                                          .data = &value};
        struct pp_size_answer answer;
        assert_int_equal(pp_size_find(&answer, &task, NULL), PP_OK);
        assert_int_equal(answer.verdict, PP_SIZE_REACHED);
        double df = told(answer.room, cases[i].method, cases[i].point ? &point : NULL);
        assert_relative(df, cases[i].target, 0.005);
        pp_size_answer_clear(&answer);
    }
    pp_building_destroy(building);
}

static void counting_methods_have_the_smallest_window_that_is_not_below(void **state)
{
    (void)state;
    static const char *const methods[] = {"waldram+bre", "pepper-pot+bre"};
    const struct pp_receiver point = {{1.9, 2.3, 0.85}, {0.0, 0.0, 1.0}, 0, 0.0};
    const int first = 0;
    struct pp_building *building = parse(two_sided);
    const struct pp_outside_light light = light_of(building);
    for (int i = 0; i < 2; i++) {
        struct pp_room_value value = {
            .light = &light, .method = methods[i], .points = &point, .point_count = 1};
        const struct pp_size_task task = {.room = pp_building_room(building, 0),
                                          .change = PP_CHANGE_HEAD,
                                          .openings = &first,
                                          .opening_count = 1,
                                          .target = 0.0213,
                                          .by_counts = true,
                                          .value = by_method,
                                          .data = &value};
        struct pp_size_answer answer;
        assert_int_equal(pp_size_find(&answer, &task, NULL), PP_OK);
        assert_int_equal(answer.verdict, PP_SIZE_REACHED);
        assert_true(told(answer.room, methods[i], &point) >= 0.0213);
        struct pp_opening_place smaller = place(answer.room, 0);
        smaller.height_m -= 0.001;
        pp_room_set_place(answer.room, 0, smaller);
        assert_true(told(answer.room, methods[i], &point) < 0.0213);
        pp_size_answer_clear(&answer);
    }
    pp_building_destroy(building);
}

static void a_method_without_value_for_the_room_gives_a_reason(void **state)
{
    (void)state;
    struct pp_building *building =
        parse(ROOM("<sky type='uniform'/><window wall='south' left='1.3' sill='0.9' "
                   "width='1.3' height='1.2'/>"));
    const struct pp_outside_light light = light_of(building);
    struct pp_room_value value = {.light = &light, .method = "exact+bre"};
    const int first = 0;
    const struct pp_size_task task = {.room = pp_building_room(building, 0),
                                      .openings = &first,
                                      .opening_count = 1,
                                      .target = 0.02,
                                      .value = by_method,
                                      .data = &value};
    struct pp_size_answer answer;
    assert_int_equal(pp_size_find(&answer, &task, NULL), PP_OK);
    assert_int_equal(answer.verdict, PP_SIZE_NO_VALUE);
    assert_non_null(strstr(answer.reading.why, "bre"));
    assert_null(answer.room);
    pp_size_answer_clear(&answer);
    pp_building_destroy(building);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_width_is_the_area_wanted_over_the_height),
        cmocka_unit_test(an_edge_at_the_walls_end_stays_and_the_other_goes_on),
        cmocka_unit_test(windows_grow_in_proportion_until_they_meet),
        cmocka_unit_test(what_does_not_change_is_an_obstacle_and_stays_to_the_bit),
        cmocka_unit_test(
            heads_rise_and_sills_fall_and_the_height_does_first_one_then_the_other),
        cmocka_unit_test(a_rooflight_has_width_and_depth),
        cmocka_unit_test(a_coarse_millimetre_is_divided),
        cmocka_unit_test(a_counted_value_has_the_smallest_millimetre_that_reaches_it),
        cmocka_unit_test(a_value_that_falls_again_is_reached_on_its_way_up),
        cmocka_unit_test(a_change_that_does_nothing_reaches_nothing),
        cmocka_unit_test(
            a_sampled_value_is_within_half_a_standard_error_after_few_looks),
        cmocka_unit_test(beyond_the_first_sufficient_size_only_the_largest_is_tried),
        cmocka_unit_test(windows_stand_in_the_middle_of_their_shares_of_the_wall),
        cmocka_unit_test(fewer_windows_leave_out_the_last),
        cmocka_unit_test(windows_that_are_not_alike_have_no_number),
        cmocka_unit_test(each_size_can_be_and_lies_within_the_next),
        cmocka_unit_test(continuous_methods_reach_the_target_within_half_a_per_cent),
        cmocka_unit_test(counting_methods_have_the_smallest_window_that_is_not_below),
        cmocka_unit_test(a_method_without_value_for_the_room_gives_a_reason),
    };
    add_tests(tests, NULL, NULL);
}
