/* test_hidden_blocks.c - many blocks in front of a window: hidden blocks do not change
 * the result, in any order in the file. */
#include "tests/lib/near.h"

#include <stdio.h>
#include <stdlib.h>

#include "methods/evaluate.h"
#include "tests/lib/room_of.h"

static const char *const direct_methods =
    "exact,waldram,pepper-pot,protractor,brs-table";

struct blocks_room {
    struct pp_world *world;
    struct pp_outside_light light;
    struct pp_report report;
};

/* Results of the methods for a room with `blocks` in front of it. */
static void answer(struct blocks_room *room, const char *glazing, const char *blocks)
{
    size_t size = strlen(blocks) + 500;
    char *xml = malloc(size);
    assert_non_null(xml);
    snprintf(xml, size,
             "<room version='1'><plan width='3.1' depth='4.3' height='2.7'/>"
             "<window wall='south' left='0.35' sill='0.8' width='2.4' height='1.5' "
             "glazing='%s'/><line from='0.7 0.4' to='2.3 3.9' points='3'/>%s</room>",
             glazing, blocks);
    *room = (struct blocks_room){0};
    room->world = pp_test_lit_world(&room->light, xml);
    room->report = (struct pp_report){.world = room->world,
                                      .light = room->light,
                                      .receivers = room->world->receivers,
                                      .receiver_count = room->world->receiver_count};
    struct pp_error err = {0};
    if (pp_methods_evaluate(&room->report, direct_methods, &err) != PP_OK)
        fail_msg("%s", err.message);
    free(xml);
}

static void clear(struct blocks_room *room)
{
    pp_report_clear(&room->report);
    pp_world_destroy(room->world);
}

/* Asserts that both rooms have the same figures, and that not all are zero. */
static void assert_same(const struct blocks_room *a, const struct blocks_room *b,
                        double tolerance)
{
    assert_int_equal(a->report.column_count, 10);
    assert_int_equal(b->report.column_count, 10);
    for (int c = 0; c < 10; c++) {
        const struct pp_column *one = &a->report.columns[c],
                               *other = &b->report.columns[c];
        double sum = 0.0;
        for (int i = 0; i < a->report.receiver_count; i++) {
            assert_near(one->points[i].value, other->points[i].value, tolerance);
            sum += one->points[i].value;
        }
        assert_true(sum > 1e-5);
        assert_near(one->average.value, other->average.value, 1e-4 * sum);
    }
}

static uint64_t next(uint64_t *row, uint64_t below)
{
    *row = *row * 6364136223846793005u + 1442695040888963407u;
    return (*row >> 33) % below;
}

/* Writes a block, by its number. */
static int write_block(char *text, int number, double first_y)
{
    uint64_t row = 977 + 31 * (uint64_t)number;
    next(&row, 7);
    return sprintf(text,
                   "<block x='%.2f' y='%.2f' width='0.61' depth='0.43' height='%.3f' "
                   "rotate='%d' reflectance='0.%d'/>",
                   -9.0 + 0.01 * (double)next(&row, 1900),
                   first_y - 0.01 * (double)next(&row, 1500),
                   0.9 + 0.01 * (double)next(&row, 160), (int)next(&row, 90),
                   2 + 3 * (int)next(&row, 2));
}

enum { COUNT = 40, BLOCK_TEXT = 160 };

/* A row of houses without gaps, higher than all blocks behind them: these are hidden
 * from all heights below the roofs. A single long house would not be suitable, since
 * tables and protractors sort obstructions by the distance of their nearest corner. */
static void blocks_behind_a_higher_house_change_no_figure(void **state)
{
    (void)state;
    enum { HOUSES = 80 };
    char *row = malloc(HOUSES * BLOCK_TEXT),
         *all = malloc((HOUSES + COUNT) * BLOCK_TEXT);
    assert_non_null(row);
    assert_non_null(all);
    int length = 0;
    for (int i = 0; i < HOUSES; i++)
        length += sprintf(row + length,
                          "<block x='%.2f' y='-7' width='0.83' depth='0.9' "
                          "height='2.93'/>",
                          -30.0 + 0.83 * i);
    length = 0;
    for (int i = 0; i < COUNT; i++)
        length += write_block(all + length, i, -7.5);
    strcpy(all + length, row);
    struct blocks_room alone, together;
    answer(&alone, "clear-single", row);
    answer(&together, "clear-single", all);
    /* A fifth of the tolerance of quadrature through glass. */
    assert_same(&alone, &together, 2e-7);
    clear(&alone);
    clear(&together);
    free(row);
    free(all);
}

/* The nearest of blocks with two reflectances counts, not the first block in the
 * file. */
static void the_order_of_the_blocks_in_the_file_changes_no_figure(void **state)
{
    (void)state;
    char *forward = malloc(COUNT * BLOCK_TEXT), *backward = malloc(COUNT * BLOCK_TEXT);
    assert_non_null(forward);
    assert_non_null(backward);
    int length[2] = {0};
    for (int i = 0; i < COUNT; i++) {
        length[0] += write_block(forward + length[0], i, -2.5);
        length[1] += write_block(backward + length[1], COUNT - 1 - i, -2.5);
    }
    struct blocks_room one, other;
    answer(&one, "none", forward);
    answer(&other, "none", backward);
    assert_same(&one, &other, 1e-12);
    clear(&one);
    clear(&other);
    free(forward);
    free(backward);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(blocks_behind_a_higher_house_change_no_figure),
        cmocka_unit_test(the_order_of_the_blocks_in_the_file_changes_no_figure),
    };
    add_tests(tests, NULL, NULL);
}
