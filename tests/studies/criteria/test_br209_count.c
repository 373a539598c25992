/* test_br209_count.c - counts of windows and rooms by BR 209, and their totals by floor
 * and house. */
#include "studies/criteria/br209_count.h"

#include <stdlib.h>

#include "studies/criteria/criteria.h"
#include "tests/lib/room_of.h"

enum { ROOMS = 5 };

/* A room with one window, whose sky component falls from 40 % to `now`. */
struct one_room {
    struct pp_world world;
    struct pp_study_room room;
    struct pp_finding sky;
    struct pp_answer answer;
};

static void make_room(struct one_room *one, struct pp_assessment *assessment,
                      char *address, double level_m, double now, bool is_new)
{
    *one = (struct one_room){.world = {.address = address, .placement.z = level_m}};
    one->room = (struct pp_study_room){.world = &one->world, .file = "sites/mill.xml"};
    one->sky = pp_finding_of(PP_FIGURE_RATIO, now / 0.4, 0.8, false, "W1, south");
    pp_finding_compares(&one->sky, PP_FIGURE_FACTOR, now, 0.4);
    one->answer = (struct pp_answer){.criterion = &pp_criterion_former_sky,
                                     .findings = {.list = &one->sky, .count = 1}};
    *assessment = (struct pp_assessment){.room = &one->room,
                                         .before = is_new ? NULL : &one->room,
                                         .is_new = is_new,
                                         .answers = {&one->answer, 1}};
}

static void floors_and_houses_have_their_sums(void **state)
{
    (void)state;
    struct one_room list[ROOMS];
    struct pp_assessment rooms[ROOMS];
    struct pp_br209_group *groups;
    struct pp_error err;
    char words[PP_BR209_WORDS], twelve[] = "12 Mill Lane", other[] = "14 Mill Lane";
    int count;
    make_room(&list[0], &rooms[0], twelve, 3.1, 0.36, false); /* loss of 10 % */
    make_room(&list[1], &rooms[1], other, 0.0, 0.22, false);  /* 45 % */
    make_room(&list[2], &rooms[2], twelve, 0.0, 0.30, false); /* 25 % */
    make_room(&list[3], &rooms[3], twelve, 0.2, 0.26, false); /* 35 %, same floor */
    make_room(&list[4], &rooms[4], twelve, 6.0, 0.10, true);  /* not a neighbour */
    assert_int_equal(pp_br209_count_groups(&groups, &count, rooms, ROOMS, &err), PP_OK);
    assert_int_equal(count, 4);
    pp_br209_count_group_words(words, groups, count, 0);
    assert_string_equal(words, "12 Mill Lane, floor at +0.00 m");
    assert_int_equal(groups[0].count.windows, 2);
    assert_int_equal(groups[0].count.windows_met, 0);
    assert_int_equal(groups[0].count.losses[1], 1);
    assert_int_equal(groups[0].count.losses[2], 1);
    assert_near(groups[1].level_m, 3.1, 0.0);
    assert_int_equal(groups[1].count.windows_met, 1);
    pp_br209_count_group_words(words, groups, count, 2);
    assert_string_equal(words, "12 Mill Lane, all floors");
    assert_int_equal(groups[2].count.windows, 3);
    assert_int_equal(groups[2].count.losses[0], 1);
    assert_false(groups[3].is_house);
    assert_int_equal(groups[3].count.losses[3], 1);
    free(groups);
    const struct pp_br209_count all = pp_br209_count_of(rooms, ROOMS);
    assert_int_equal(all.windows, 4);
    assert_int_equal(all.windows_met, 1);
}

static void a_house_without_an_address_needs_no_name(void **state)
{
    (void)state;
    struct one_room list[2];
    struct pp_assessment rooms[2];
    struct pp_br209_group *groups;
    struct pp_error err;
    char words[PP_BR209_WORDS];
    int count;
    make_room(&list[0], &rooms[0], NULL, 0.0, 0.36, false);
    make_room(&list[1], &rooms[1], NULL, 2.8, 0.36, false);
    assert_int_equal(pp_br209_count_groups(&groups, &count, rooms, 2, &err), PP_OK);
    assert_int_equal(count, 3);
    pp_br209_count_group_words(words, groups, count, 1);
    assert_string_equal(words, "floor at +2.80 m");
    free(groups);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(floors_and_houses_have_their_sums),
        cmocka_unit_test(a_house_without_an_address_needs_no_name),
    };
    add_tests(tests, NULL, NULL);
}
