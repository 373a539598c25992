/* test_lumen_table.c - tables of the lumen method supplied by a user: valid tables are
 * read, mistakes are reported with their lines. */
#include "methods/lumen/lumen_table.h"
#include "methods/lumen/lumen_csv.h"
#include "tests/lib/near.h"

#include <stdio.h>
#include <stdlib.h>

static struct pp_lumen_table *table;
static struct pp_mistakes mistakes;

static enum pp_status parse(const char *text, size_t length)
{
    assert_int_equal(pp_lumen_table_create(&table, NULL), PP_OK);
    pp_mistakes_init(&mistakes, "table.csv");
    return pp_lumen_csv_parse(table, text, length, &mistakes, NULL);
}

static void done(void)
{
    pp_mistakes_clear(&mistakes);
    pp_lumen_table_destroy(table);
}

/* The first mistake is on this line and its message contains these words. */
static void refused(const char *text, int line, const char *words)
{
    assert_int_equal(parse(text, strlen(text)), PP_BAD_INPUT);
    assert_true(mistakes.count > 0);
    pp_mistakes_sort(&mistakes);
    if (mistakes.list[0].line != line || !strstr(mistakes.list[0].text, words))
        fail_msg("line %d: %s", mistakes.list[0].line, mistakes.list[0].text);
    done();
}

#define SIDE "Ev_over_Eh,depth_over_window_height,position_percent,1,2\n"
#define FIVE(light, depth, cu)                                                         \
    light "," depth ",10," cu "\n" light "," depth ",30," cu "\n" light "," depth      \
          ",50," cu "\n" light "," depth ",70," cu "\n" light "," depth ",90," cu "\n"

static const char good[] =
    "\xef\xbb\xbf# mine\r\n\r\n component , Ev_over_Eh,depth_over_window_height,"
    "position_percent,1,2\r\n"
    "ground,uniform,4,10,.2,.3\r\nground,,4,30,.2,.3\r\nground,ground,4,50,.2,.3\r\n"
    "ground,uniform,4,70,.2,.3\r\nground,uniform,4,90,.2,.3\r\n"
    "sky,0.4,4,10,0.5,0.7\r\nsky,0.4,4,30,0.4,0.6\r\nsky,0.4,4,50,0.3,0.5\r\n"
    "sky,0.4,4,70,0.2,0.4\r\nsky,0.4,4,90,0.1,0.3";

/* A table without reflectances is used for any reflectances; without averages the mean
 * of its values is used. */
static void plain_table_is_read(void **state)
{
    (void)state;
    double cu[PP_LUMEN_POSITIONS];
    char why[200];
    assert_int_equal(parse(good, sizeof good - 1), PP_OK);
    struct pp_lumen_query query = {0.396, true, {0.23, 0.99, 4.0, 2.0}};
    assert_true(pp_lumen_table_side(cu, table, &query, why, sizeof why));
    assert_near(cu[0], 0.7, 0.0);
    assert_near(cu[4], 0.3, 0.0);
    assert_near(cu[PP_LUMEN_AVERAGE], 0.5, 1e-12);
    /* Geometric interpolation in the reciprocal of the width: 4/3 is halfway from 1 to
     * 2. */
    query.at[PP_LUMEN_WIDTH] = 4.0 / 3.0;
    assert_true(pp_lumen_table_side(cu, table, &query, why, sizeof why));
    assert_near(cu[0], sqrt(0.5 * 0.7), 1e-12);
    assert_near(pp_lumen_table_at_depth(cu, 0.2),
                sqrt(sqrt(0.5 * 0.7) * sqrt(0.4 * 0.6)), 1e-12);
    assert_near(pp_lumen_table_at_depth(cu, 0.9), cu[4], 1e-12);
    query.ev_over_eh = NAN;
    assert_true(pp_lumen_table_side(cu, table, &query, why, sizeof why));
    assert_near(cu[2], sqrt(0.2 * 0.3), 1e-12);
    /* The program's own table for light from above is still used. */
    assert_near(pp_lumen_table_top(table, 0.0, 0.5, 0.5, why, sizeof why), 1.1111,
                1e-9);
    done();
}

static void nothing_is_read_outside_it(void **state)
{
    (void)state;
    double cu[PP_LUMEN_POSITIONS];
    char why[200];
    assert_int_equal(parse(good, sizeof good - 1), PP_OK);
    struct pp_lumen_query query = {0.396, true, {0.7, 0.5, 4.0, 2.2}};
    assert_false(pp_lumen_table_side(cu, table, &query, why, sizeof why));
    assert_string_equal(why, "is in a room whose ratio of width to window height is "
                             "2.2; the table covers 1 to 2");
    query.at[PP_LUMEN_WIDTH] = 1.5;
    query.at[PP_LUMEN_DEPTH] = 4.1;
    assert_false(pp_lumen_table_side(cu, table, &query, why, sizeof why));
    query.at[PP_LUMEN_DEPTH] = 4.0;
    query.overcast = false;
    query.ev_over_eh = 0.9;
    assert_false(pp_lumen_table_side(cu, table, &query, why, sizeof why));
    assert_string_equal(why,
                        "faces a sky whose Ev/Eh is 0.9; the table has no such value");
    done();
}

/* The table for the ground may have fewer depths than that for the sky, as in the
 * published part of the handbook. */
static void cells_left_out_are_no_numbers(void **state)
{
    (void)state;
    static const char text[] = SIDE FIVE("0.75", "1", ".8,.9")
        FIVE("0.75", "2", ".4,.5") FIVE("", "1", ".2,.3");
    double cu[PP_LUMEN_POSITIONS];
    char why[200];
    assert_int_equal(parse(text, sizeof text - 1), PP_OK);
    struct pp_lumen_query query = {NAN, false, {0.7, 0.5, 1.0, 1.5}};
    assert_true(pp_lumen_table_side(cu, table, &query, why, sizeof why));
    query.at[PP_LUMEN_DEPTH] = 1.5;
    assert_false(pp_lumen_table_side(cu, table, &query, why, sizeof why));
    assert_non_null(strstr(why, "missing from the table"));
    query.overcast = true;
    query.ev_over_eh = 0.396;
    assert_false(pp_lumen_table_side(cu, table, &query, why, sizeof why));
    assert_non_null(strstr(why, "overcast"));
    done();
}

static void table_for_light_from_above_is_read(void **state)
{
    (void)state;
    static const char text[] = "rcr,ceiling_reflectance,wall_reflectance,cu\n"
                               "1,.5,.5,.8\n2,.5,.5,.6\n";
    char why[200];
    assert_int_equal(parse(text, sizeof text - 1), PP_OK);
    assert_near(pp_lumen_table_top(table, 1.25, 0.5, 0.5, why, sizeof why), 0.75,
                1e-12);
    assert_true(isnan(pp_lumen_table_top(table, 0.5, 0.5, 0.5, why, sizeof why)));
    assert_true(isnan(pp_lumen_table_top(table, 1.5, 0.6, 0.5, why, sizeof why)));
    done();
}

static void mistakes_are_named_by_line(void **state)
{
    (void)state;
    refused("", 0, "the file is empty");
    refused("# only\n", 0, "the file is empty");
    refused(SIDE, 0, "no lines");
    refused("Ev_over_Ehh,depth_over_window_height,position_percent,1\n", 1,
            "did you mean \"Ev_over_Eh\"");
    refused("Ev_over_Eh,depth_over_window_height,1\n0.4,1,.2\n", 1,
            "lacks the column \"position_percent\"");
    refused("Ev_over_Eh,depth_over_window_height,position_percent\n", 1, "width");
    refused("Ev_over_Eh,depth_over_window_height,position_percent,2,1\n", 1, "ascend");
    refused("Ev_over_Eh,depth_over_window_height,position_percent,inf,9\n", 1,
            "ascend");
    refused("Ev_over_Eh,depth_over_window_height,position_percent,-1\n", 1,
            "unknown column");
    refused("Ev_over_Eh,Ev_over_Eh,depth_over_window_height,position_percent,1\n", 1,
            "duplicate column");
    refused("Ev_over_Eh,wall_reflectance,depth_over_window_height,position_percent,1\n",
            1, "both or neither");
    refused("rcr,cu,1\n", 1, "ceiling_reflectance");
    refused("rcr,ceiling_reflectance,wall_reflectance,cu,component\n", 1,
            "unexpected column \"component\"");
    refused(SIDE "0.4,1,10,.2\n", 2, "4 fields on this line; expected 5");
    refused(SIDE "0.4,1,10,.2,.3,.4\n", 2, "6 fields");
    refused(SIDE "\n0.4,1,10,.2,\n", 3, "a coefficient is missing");
    refused(SIDE "0.4,1,10,.2,nan\n", 2, "expected a number above 0");
    refused(SIDE "0.4,1,10,.2,-.1\n", 2, "above 0");
    refused(SIDE "0.4,1,10,.2,20\n", 2, "up to 2");
    refused(SIDE "0.4,1,10,0,.1\n", 2, "above 0");
    refused(SIDE "0.4,1,20,.2,.1\n", 2, "10, 30, 50, 70 or 90");
    refused(SIDE "0.4,0,10,.2,.1\n", 2, "depth_over_window_height");
    refused(SIDE "0.4,inf,10,.2,.1\n", 2, "depth_over_window_height");
    refused(SIDE "clear,1,10,.2,.1\n", 2, "Ev_over_Eh is \"clear\"");
    refused(SIDE "0.4,1,10,.2,.1\n0.4,1,10,.2,.1\n", 3, "duplicate line");
    refused("component," SIDE "sky,uniform,1,10,.2,.1\n", 2, "component");
    refused("component," SIDE "moon,0.4,1,10,.2,.1\n", 2, "component is \"moon\"");
    refused("rcr,ceiling_reflectance,wall_reflectance,cu\n1,1.1,.5,.5\n", 2, "up to 1");
    refused("rcr,ceiling_reflectance,wall_reflectance,cu\n1,.1,.5,.5\n1,.1,.5,.4\n", 3,
            "duplicate line");
    refused("1,2,3\n4,5,6\n", 1, "lacks the column");
}

static void all_mistakes_are_named_at_once(void **state)
{
    (void)state;
    static const char text[] = SIDE "x,1,10,.2,.1\n0.4,1,11,.2,.1\n0.4,1,30,.2,y\n";
    assert_int_equal(parse(text, sizeof text - 1), PP_BAD_INPUT);
    assert_int_equal(mistakes.count, 3);
    done();
}

static void bytes_that_are_no_text_are_rejected(void **state)
{
    (void)state;
    assert_int_equal(parse("Ev\0h", 4), PP_BAD_INPUT);
    done();
    char *line = malloc(100001);
    assert_non_null(line);
    memset(line, ',', 100000);
    assert_int_equal(parse(line, 100000), PP_BAD_INPUT);
    done();
    memset(line, '7', 100000);
    assert_int_equal(parse(line, 100000), PP_BAD_INPUT);
    done();
    free(line);
}

/* Rejects more values than an axis can have. */
static void too_long_axes_are_refused(void **state)
{
    (void)state;
    char text[8000] = SIDE;
    for (int i = 1; i < 40; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "0.4,%d,10,.1,.2\n",
                 i);
    refused(text, PP_LUMEN_AXIS_MOST + 2, "more than 24 different room depths");
}

/* Every truncation of a valid table, and every table with one byte changed, is either
 * read or rejected. */
static void damaged_tables_do_no_harm(void **state)
{
    (void)state;
    char *text = malloc(sizeof good);
    assert_non_null(text);
    for (size_t length = 0; length < sizeof good; length++) {
        memcpy(text, good, length);
        enum pp_status status = parse(text, length);
        assert_true(status == PP_OK || mistakes.count > 0);
        done();
    }
    static const char bytes[] = {',', '\n', '-', 'e', '9', '\0', '#'};
    for (size_t at = 0; at < sizeof good - 1; at++) {
        memcpy(text, good, sizeof good);
        text[at] = bytes[at % sizeof bytes];
        enum pp_status status = parse(text, sizeof good - 1);
        assert_true(status == PP_OK || mistakes.count > 0);
        done();
    }
    free(text);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plain_table_is_read),
        cmocka_unit_test(nothing_is_read_outside_it),
        cmocka_unit_test(cells_left_out_are_no_numbers),
        cmocka_unit_test(table_for_light_from_above_is_read),
        cmocka_unit_test(mistakes_are_named_by_line),
        cmocka_unit_test(all_mistakes_are_named_at_once),
        cmocka_unit_test(bytes_that_are_no_text_are_rejected),
        cmocka_unit_test(too_long_axes_are_refused),
        cmocka_unit_test(damaged_tables_do_no_harm),
    };
    add_tests(tests, NULL, NULL);
}
