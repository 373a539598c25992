/* test_epw_marks.c - weather files written by data loggers, converters and
 * spreadsheets. */
#include <string.h>

#include "tests/lib/made_epw.h"
#include "tests/lib/near.h"

/* One day of hourly records, with summer time and period in the header. */
static struct pp_epw *read_day(const char *summer, const char *period,
                               const char *global, const char *lx_by_day,
                               const char *lx_at_night)
{
    struct made_epw made;
    struct pp_epw *epw = NULL;
    struct pp_mistakes mistakes;
    struct pp_error err = {0};
    epw_begin(&made);
    epw_line(&made, EPW_LOCATION);
    fprintf(made.out, "HOLIDAYS/DAYLIGHT SAVINGS,No,%s,0\n", summer);
    fprintf(made.out, "DATA PERIODS,1,1,Data,,%s,%s\n", period, period);
    for (int hour = 1; hour <= 24; hour++) {
        const char *light = hour > 8 && hour < 18 ? global : "0";
        epw_record(&made, 2001, 6, 21, hour, 0, light, "0", light,
                   hour > 8 && hour < 18 ? lx_by_day : lx_at_night);
    }
    fclose(made.out);
    pp_mistakes_init(&mistakes, "made.epw");
    if (pp_epw_parse(&epw, made.text, made.length, &mistakes, &err) != PP_OK)
        fail_msg("%s: %s", err.message,
                 mistakes.count > 0 ? mistakes.list[0].text : "nothing");
    pp_mistakes_clear(&mistakes);
    free(made.text);
    return epw;
}

/* 9999 lx at night is not an illuminance, so 9999 lx by day is not either; without such
 * nights it is. */
static void illuminance_without_irradiance_is_a_mark(void **state)
{
    (void)state;
    struct pp_epw *epw = read_day("0,0", "6/21", "300", "9999", "9999");
    assert_true(isnan(epw->records[0].diffuse_lx));
    assert_true(isnan(epw->records[12].diffuse_lx));
    assert_near(epw->records[12].diffuse_w_m2, 300.0, 0.0);
    pp_epw_destroy(epw);
    epw = read_day("0,0", "6/21", "300", "9999", "0");
    assert_near(epw->records[12].diffuse_lx, 9999.0, 0.0);
    pp_epw_destroy(epw);
}

static void loggers_mark_missing_values_by_minus_999(void **state)
{
    (void)state;
    struct pp_epw *epw = read_day("0,0", "6/21", "-999", "-9999", "0");
    assert_true(isnan(epw->records[12].diffuse_w_m2));
    assert_true(isnan(epw->records[12].global_w_m2));
    assert_true(isnan(epw->records[12].diffuse_lx));
    assert_near(epw->records[0].diffuse_lx, 0.0, 0.0);
    pp_epw_destroy(epw);
}

/* A format into which a spreadsheet converts 6/21. */
static void days_of_a_spreadsheet_are_read(void **state)
{
    (void)state;
    struct pp_epw *epw = read_day("0,0", "21-Jun", "300", "30000", "0");
    assert_int_equal(epw->record_count, 24);
    pp_epw_destroy(epw);
}

/* In the calendar of 2001, 11 March, 29 April and 4 November are Sundays; in 2024 the
 * last Thursday of February is the 29th. */
static void days_of_the_week_in_a_month_are_days_of_a_year(void **state)
{
    (void)state;
    static const struct {
        const char *words;
        int year, month, day;
    } cases[] = {{"2nd Sunday in March", 2001, 3, 11},
                 {"Last Sunday in April", 2001, 4, 29},
                 {"1st Sunday in November", 2001, 11, 4},
                 {"last sunday in dec", 2001, 12, 30},
                 {"Last Thursday in February", 2024, 2, 29},
                 {"Last Thursday in February", 2023, 2, 23}};
    static const char *const wrong[] = {"",
                                        "Sunday in March",
                                        "0th Sunday in March",
                                        "5th Sunday in March",
                                        "2nd Someday in March",
                                        "2nd Sunday in Marchen",
                                        "2nd Sunday of March",
                                        "2nd Sunday in March 4"};
    struct pp_month_day date;
    for (int i = 0; i < (int)(sizeof cases / sizeof *cases); i++) {
        assert_true(pp_month_day_parse_words(cases[i].words, cases[i].year, &date));
        assert_int_equal(date.month, cases[i].month);
        assert_int_equal(date.day, cases[i].day);
    }
    for (int i = 0; i < (int)(sizeof wrong / sizeof *wrong); i++)
        assert_false(pp_month_day_parse_words(wrong[i], 2001, &date));
    struct pp_epw *epw = read_day("2nd Sunday in March,1st Sunday in November", "6/21",
                                  "300", "30000", "0");
    assert_int_equal(epw->summer_from.day, 11);
    assert_int_equal(epw->summer_to.month, 11);
    assert_string_equal(epw->summer_words, "");
    pp_epw_destroy(epw);
    epw = read_day("when the Duke returns,1st Sunday in November", "6/21", "300",
                   "30000", "0");
    assert_string_equal(epw->summer_words,
                        "when the Duke returns to 1st Sunday in November");
    pp_epw_destroy(epw);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(illuminance_without_irradiance_is_a_mark),
        cmocka_unit_test(loggers_mark_missing_values_by_minus_999),
        cmocka_unit_test(days_of_a_spreadsheet_are_read),
        cmocka_unit_test(days_of_the_week_in_a_month_are_days_of_a_year),
    };
    add_tests(tests, NULL, NULL);
}
