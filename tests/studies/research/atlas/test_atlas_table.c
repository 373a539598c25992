/* test_atlas_table.c - files of the atlas: complete, truncated and wrong. */
#include "studies/research/atlas/atlas_table.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "tests/lib/near.h"

/* Writes a temporary file with this text; `path` receives its name. */
static void write_text(char path[64], const char *text)
{
    snprintf(path, 64, "test_atlas_table-%d.csv", (int)getpid());
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

static enum pp_status read_text(struct pp_atlas_table *table, const char *text,
                                struct pp_error *err)
{
    char path[64];
    write_text(path, text);
    enum pp_status status = pp_atlas_table_read(table, path, err);
    remove(path);
    return status;
}

static const char whole[] =
    "# atlas\nroom,point,df.bre\n0,0,0.0125\n0,-1,\n1,0,2.5e-3\n"
    "1,-1,0.02\n";

static void numbers_are_read_by_name_and_an_empty_one_is_missing(void **state)
{
    (void)state;
    struct pp_atlas_table table;
    assert_int_equal(read_text(&table, whole, NULL), PP_OK);
    int column = pp_atlas_table_find(&table, "df.bre");
    assert_int_equal(table.row_count, 4);
    assert_int_equal(column, 2);
    assert_int_equal(pp_atlas_table_find(&table, "df.sphere"), -1);
    assert_near(pp_atlas_table_value(&table, 0, column), 0.0125, 0.0);
    assert_true(isnan(pp_atlas_table_value(&table, 1, column)));
    assert_near(pp_atlas_table_value(&table, 2, column), 0.0025, 0.0);
    assert_true(isnan(pp_atlas_table_value(&table, 0, -1)));
    pp_atlas_table_clear(&table);
}

/* For a file truncated at any byte, only rows of complete rooms are read. */
static void a_room_that_is_still_being_written_is_left_out(void **state)
{
    (void)state;
    const size_t first = (size_t)(strstr(whole, "1,0,") - whole), all = strlen(whole);
    for (size_t length = first; length <= all; length++) {
        char text[sizeof whole];
        struct pp_atlas_table table;
        snprintf(text, sizeof text, "%.*s", (int)length, whole);
        assert_int_equal(read_text(&table, text, NULL), PP_OK);
        assert_int_equal(table.row_count, length == all ? 4 : 2);
        pp_atlas_table_clear(&table);
    }
}

static void text_instead_of_a_number_is_reported_with_its_line(void **state)
{
    (void)state;
    static const struct {
        const char *text, *message;
    } cases[] = {
        {"# x\nroom,point,a\n0,0,1\n0,-1,1..2\n",
         ":4: a is \"1..2\"; expected a number"},
        {"room,point,a\n0,-1\n", ":2: 2 fields; expected 3"},
        {"room,point,a\n0,-1,1,2\n", ":2: 4 fields; expected 3"},
        {"room,point,a\n0,0,1\n,-1,1\n", ":3: the room has no number"},
        {"room,point,a\n1e10,-1,1\n", ":2: the room has no number"},
        {"room,point,a\n0,,1\n", ":2: the point has no number"},
        {"room,x\n", ":1: no columns"},
        {"# nothing\n", ": the file is empty; expected an atlas"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct pp_atlas_table table;
        struct pp_error err;
        assert_int_equal(read_text(&table, cases[i].text, &err), PP_BAD_INPUT);
        assert_non_null(strstr(err.message, cases[i].message));
        pp_atlas_table_clear(&table);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_read_by_name_and_an_empty_one_is_missing),
        cmocka_unit_test(a_room_that_is_still_being_written_is_left_out),
        cmocka_unit_test(text_instead_of_a_number_is_reported_with_its_line),
    };
    add_tests(tests, NULL, NULL);
}
