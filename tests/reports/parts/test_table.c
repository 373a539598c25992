/* test_table.c - the layout of a table of results in lines of a given width. */
#include "tests/lib/near.h"

#include <stdio.h>
#include <stdlib.h>

#include "reports/parts/table.h"

static void add(struct pp_table *table, const char *group, const char *heading,
                const char *cell)
{
    struct pp_table_column *column = pp_table_add(table, group, group, heading);
    assert_non_null(column);
    for (int row = 0; row < table->row_count; row++)
        snprintf(column->cells[row], PP_CELL_BYTES, "%s", cell);
}

/* The table as printed; the caller frees it. */
static char *printed(struct pp_table *table, int width)
{
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    assert_non_null(out);
    pp_table_print(table, width, out);
    assert_int_equal(fclose(out), 0);
    return text;
}

static void shows(struct pp_table *table, int width, const char *expected)
{
    char *text = printed(table, width);
    assert_string_equal(text, expected);
    free(text);
    pp_table_clear(table);
}

static const char one[] = "one", two[] = "two";

static struct pp_table two_groups(void)
{
    struct pp_table table;
    pp_table_init(&table, 2);
    add(&table, NULL, "y", "0.50");
    table.key_count = 1;
    table.last_label = "mean";
    add(&table, one, "exact", "12.30");
    add(&table, one, "brs-table", "1.25");
    add(&table, two, "exact+bre", "-");
    return table;
}

static void columns_stand_side_by_side_while_the_line_lasts(void **state)
{
    (void)state;
    struct pp_table table = two_groups();
    shows(&table, 40,
          "         one            two\n"
          "         ------------   -----\n"
          "                 brs-   exact\n"
          "     y   exact  table    +bre\n"
          "  ---------------------------\n"
          "  0.50   12.30   1.25       -\n"
          "  ---------------------------\n"
          "  mean   12.30   1.25       -\n");
}

static void a_group_that_does_not_fit_is_printed_below_with_the_keys(void **state)
{
    (void)state;
    struct pp_table table = two_groups();
    shows(&table, 28,
          "         one\n"
          "         ------------\n"
          "                 brs-\n"
          "     y   exact  table\n"
          "  -------------------\n"
          "  0.50   12.30   1.25\n"
          "  -------------------\n"
          "  mean   12.30   1.25\n"
          "\n"
          "         two\n"
          "         -----\n"
          "         exact\n"
          "     y    +bre\n"
          "  ------------\n"
          "  0.50       -\n"
          "  ------------\n"
          "  mean       -\n");
}

static void titles_of_narrow_groups_keep_apart(void **state)
{
    (void)state;
    static const char long_one[] = "illuminance", long_two[] = "daylight factor";
    struct pp_table table;
    pp_table_init(&table, 1);
    add(&table, NULL, "x", "0.5");
    table.key_count = 1;
    add(&table, long_one, "lx", "0");
    add(&table, long_one, "+-", "0");
    add(&table, long_two, "DF %", "0.1");
    shows(&table, 60,
          "        illuminance   daylight factor\n"
          "        -----------   ---------------\n"
          "    x        lx  +-              DF %\n"
          "  -----------------------------------\n"
          "  0.5         0   0               0.1\n");
}

static void a_group_too_wide_for_any_line_is_broken(void **state)
{
    (void)state;
    struct pp_table table;
    pp_table_init(&table, 1);
    add(&table, NULL, "y", "0.5");
    table.key_count = 1;
    for (int i = 0; i < 9; i++)
        add(&table, one, "exact", "12.30");
    char *text = printed(&table, 40);
    int length = 0;
    for (const char *c = text; *c; c++) {
        length = *c == '\n' ? 0 : length + 1;
        assert_true(length <= 40);
    }
    int cells = 0;
    for (const char *c = text; (c = strstr(c, "12.30")) != NULL; c++)
        cells++;
    assert_int_equal(cells, 9);
    free(text);
    pp_table_clear(&table);
}

/* Keys of 11 and 21 columns, figures and verdicts of 6 and 10, and gaps of 9: 57
 * columns. In a line of 51 the longer key is shortened by 6 columns in its middle,
 * where multi-byte letters remain complete; "year" and "winter" at its end are kept. */
static void keys_are_shortened_in_the_middle_until_the_table_fits(void **state)
{
    (void)state;
    struct pp_table table;
    pp_table_init(&table, 2);
    add(&table, NULL, "room", "Living room");
    add(&table, NULL, "of",
        "s\xc3\xbc"
        "d, l\xc3\xa4ngs 12, winter");
    snprintf(table.columns[1].cells[1], PP_CELL_BYTES,
             "s\xc3\xbc"
             "d, l\xc3\xa4ngs 12, year");
    table.key_count = 2;
    add(&table, one, "figure", "11.1 %");
    add(&table, one, "verdict", "not judged");
    table.columns[3].is_words = table.columns[0].is_words = table.columns[1].is_words =
        true;
    pp_table_fit(&table, 51);
    shows(&table, 51,
          "                                 one\n"
          "                                 ------------------\n"
          "  room         of                figure  verdict\n"
          "  -------------------------------------------------\n"
          "  Living room  s\xc3\xbc"
          "d, l.. winter   11.1 %  not judged\n"
          "  Living room  s\xc3\xbc"
          "d, l..2, year   11.1 %  not judged\n");
}

/* Two windows whose names differ only in their middle cannot be shortened there: the
 * table is not changed and continues below. */
static void keys_that_would_become_the_same_are_left_whole(void **state)
{
    (void)state;
    struct pp_table table;
    pp_table_init(&table, 2);
    add(&table, NULL, "of", "window 1234 of the south");
    snprintf(table.columns[0].cells[1], PP_CELL_BYTES, "window 5678 of the south");
    table.key_count = 1;
    add(&table, one, "exact", "12.30");
    pp_table_fit(&table, 20);
    assert_string_equal(table.columns[0].cells[0], "window 1234 of the south");
    assert_string_equal(table.columns[0].cells[1], "window 5678 of the south");
    pp_table_clear(&table);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_stand_side_by_side_while_the_line_lasts),
        cmocka_unit_test(a_group_that_does_not_fit_is_printed_below_with_the_keys),
        cmocka_unit_test(titles_of_narrow_groups_keep_apart),
        cmocka_unit_test(a_group_too_wide_for_any_line_is_broken),
        cmocka_unit_test(keys_are_shortened_in_the_middle_until_the_table_fits),
        cmocka_unit_test(keys_that_would_become_the_same_are_left_whole),
    };
    add_tests(tests, NULL, NULL);
}
