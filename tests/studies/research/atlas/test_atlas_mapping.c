/* test_atlas_mapping.c - maps of atlases with known errors. */
#include "studies/research/atlas/atlas_mapping.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "tests/lib/near.h"

/* Writes an atlas of `rooms` rooms and reads it; the function prints points and figures
 * of room i. */
static void make_table(struct pp_atlas_table *table, int rooms,
                       void (*print)(FILE *file, int room))
{
    char path[64];
    snprintf(path, sizeof path, "test_atlas_mapping-%d.csv", (int)getpid());
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs("room,point,depth-width,ground,depth,true.df,se.df,sc.exact,erc.exact,"
          "df.exact+bre,df.average-df,own.df.exact+bre\n",
          file);
    for (int i = 0; i < rooms; i++)
        print(file, i);
    assert_int_equal(fclose(file), 0);
    assert_int_equal(pp_atlas_table_read(table, path, NULL), PP_OK);
    remove(path);
}

static void map_of(struct pp_atlas_map *map, const struct pp_atlas_table *table,
                   enum pp_atlas_mapping_kind kind, const char *method)
{
    assert_int_equal(pp_atlas_mapping_of(map, table, kind, method, NULL), PP_OK);
}

/* Each of 100 rooms has one point with a ground of 0.22, for which the method gives
 * 0.505 + 0.01 i times the true value of 2 %; the true value in the method's own world
 * is twice that. The rooms are not in the order of the ratios. The figures for the
 * average are 1.7 times too high. */
static void print_rising(FILE *file, int room)
{
    double said = 2.0 * (0.505 + 0.01 * (room * 37 % 100));
    fprintf(file, "%d,0,1.1,0.22,1.2,2,0.02,1.5,0.5,%.10g,,4\n", room, said);
    fprintf(file, "%d,-1,1.1,0.22,,3,0.03,2,1,,5.1,\n", room);
}

/* 100 ratios from 0.505 in steps of 0.01: quantiles are the means of the 5th, 50th and
 * 95th and the respective next ratio. */
static void quantiles_are_those_of_ranked_ratios(void **state)
{
    (void)state;
    struct pp_atlas_table table;
    struct pp_atlas_map map;
    make_table(&table, 100, print_rising);
    map_of(&map, &table, PP_MAP_GROUND, "exact+bre");
    assert_false(map.averages);
    assert_int_equal(map.rooms, 100);
    const struct pp_atlas_quantiles *cell = &map.real[3]; /* 0.2 to 0.25 */
    assert_int_equal(cell->rooms, 100);
    assert_near(cell->low, 0.55, 1e-9);
    assert_near(cell->median, 1.0, 1e-9);
    assert_near(cell->high, 1.45, 1e-9);
    for (int k = 0; k < map.across.count; k++)
        assert_int_equal(map.real[k].rooms, k == 3 ? 100 : 0);
    assert_near(map.own[3].median, 0.5, 1e-9);
    pp_atlas_table_clear(&table);
}

static void rows_stand_in_the_class_of_their_numbers(void **state)
{
    (void)state;
    struct pp_atlas_table table;
    struct pp_atlas_map map;
    make_table(&table, 100, print_rising);
    map_of(&map, &table, PP_MAP_DEPTH, "df.exact+bre"); /* 1.2 is in 1 to 1.5, */
    assert_int_equal(map.real[3 * PP_ATLAS_CLASSES + 2].rooms,
                     100);                         /* 1.1 in 1 to 1.33 */
    map_of(&map, &table, PP_MAP_ERC, "exact+bre"); /* 0.5 of 1.5 + 0.5 */
    assert_int_equal(map.real[2].rooms, 100);
    pp_atlas_table_clear(&table);
}

static void a_method_of_averages_is_held_against_averages(void **state)
{
    (void)state;
    struct pp_atlas_table table;
    struct pp_atlas_map map;
    struct pp_error err;
    make_table(&table, 100, print_rising);
    map_of(&map, &table, PP_MAP_GROUND, "average-df");
    assert_true(map.averages);
    assert_near(map.real[3].median, 1.7, 1e-9);
    assert_int_equal(
        pp_atlas_mapping_of(&map, &table, PP_MAP_DEPTH, "average-df", &err),
        PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "only an average"));
    pp_atlas_table_clear(&table);
}

/* The method is exact at eight points in each of 10 of 21 rooms, and gives twice the
 * true value at one point in each of 11: most points are correct, most rooms are
 * not. */
static void print_uneven(FILE *file, int room)
{
    for (int i = 0; i < (room < 10 ? 8 : 1); i++)
        fprintf(file, "%d,%d,1.1,0.22,1.2,2,0.02,1.5,0.5,%d,,\n", room, i,
                room < 10 ? 2 : 4);
    fprintf(file, "%d,-1,1.1,0.22,,3,0.03,2,1,,,\n", room);
}

static void median_of_an_even_number_of_rooms_is_between_the_middle_two(void **state)
{
    (void)state;
    struct pp_atlas_table table;
    struct pp_atlas_map map;
    make_table(&table, 20, print_uneven);
    map_of(&map, &table, PP_MAP_GROUND, "exact+bre");
    assert_int_equal(map.real[3].rooms, 20);
    assert_near(map.real[3].median, 1.5, 1e-12);
    pp_atlas_table_clear(&table);
}

static void a_room_counts_once_however_many_points_it_has(void **state)
{
    (void)state;
    struct pp_atlas_table table;
    struct pp_atlas_map map;
    make_table(&table, 21, print_uneven);
    map_of(&map, &table, PP_MAP_GROUND, "exact+bre");
    assert_int_equal(map.real[3].rooms, 21);
    assert_near(map.real[3].median, 2.0, 1e-12);
    assert_near(map.real[3].low, 1.0, 1e-12);
    pp_atlas_table_clear(&table);
}

/* Rooms 0 to 8 have a true value known to 1 %, the others to 11 %; one room is dark. */
static void print_blind(FILE *file, int room)
{
    fprintf(file, "%d,0,1.1,0.22,1.2,%d,%g,1.5,0.5,2,,\n", room, room == 11 ? 0 : 2,
            room < 9 ? 0.02 : 0.22);
    fprintf(file, "%d,-1,1.1,0.22,,3,0.03,2,1,,,\n", room);
}

static void truth_that_is_not_known_is_left_out_and_few_rooms_give_no_median(
    void **state)
{
    (void)state;
    struct pp_atlas_table table;
    struct pp_atlas_map map;
    make_table(&table, 12, print_blind);
    map_of(&map, &table, PP_MAP_GROUND, "exact+bre");
    assert_int_equal(map.blind, 3);
    assert_int_equal(map.real[3].rooms, 9);
    assert_true(isnan(map.real[3].median));
    pp_atlas_table_clear(&table);
}

static void an_unknown_method_is_named(void **state)
{
    (void)state;
    struct pp_atlas_table table;
    struct pp_atlas_map map;
    struct pp_error err;
    make_table(&table, 1, print_rising);
    assert_int_equal(pp_atlas_mapping_of(&map, &table, PP_MAP_ERC, "exact+bra", &err),
                     PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "no method \"exact+bra\""));
    pp_atlas_table_clear(&table);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quantiles_are_those_of_ranked_ratios),
        cmocka_unit_test(rows_stand_in_the_class_of_their_numbers),
        cmocka_unit_test(a_method_of_averages_is_held_against_averages),
        cmocka_unit_test(median_of_an_even_number_of_rooms_is_between_the_middle_two),
        cmocka_unit_test(a_room_counts_once_however_many_points_it_has),
        cmocka_unit_test(
            truth_that_is_not_known_is_left_out_and_few_rooms_give_no_median),
        cmocka_unit_test(an_unknown_method_is_named),
    };
    add_tests(tests, NULL, NULL);
}
