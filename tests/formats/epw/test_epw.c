/* test_epw.c - weather files: the values read, and the messages for wrong files. */
#include "tests/lib/near.h"

#include "tests/lib/made_epw.h"

#include "model/geometry/vec.h"

static char said[1200];

/* Reads the file, which must be valid. */
static struct pp_epw *taken(struct made_epw *made)
{
    struct pp_epw *epw = epw_made(made, said, sizeof said);
    if (!epw)
        fail_msg("refused: %s", said);
    return epw;
}

/* Asserts that the file is rejected with a message for this line that contains these
 * words. */
static void assert_refused(struct made_epw *made, int line, const char *words)
{
    char wanted[16];
    struct pp_epw *epw = epw_made(made, said, sizeof said);
    snprintf(wanted, sizeof wanted, "%d: ", line);
    if (epw)
        fail_msg("taken; expected a mistake on line %d: %s", line, words);
    if (strncmp(said, wanted, strlen(wanted)) != 0 || !strstr(said, words))
        fail_msg("said \"%s\"; expected line %d: ...%s...", said, line, words);
    epw_end(made);
}

static void done(struct made_epw *made, struct pp_epw *epw)
{
    pp_epw_destroy(epw);
    epw_end(made);
}

/* ---- valid files ---- */

static void a_record_has_its_place_time_and_values(void **state)
{
    (void)state;
    struct made_epw made;
    epw_begin(&made);
    epw_header(&made, "No", "1,1,Data,Wednesday, 2/ 3,02/03");
    for (int hour = 1; hour <= 24; hour++)
        epw_record(&made, 1991, 2, 3, hour, 60, "213.4", "9999", "-0.0", "13425");
    struct pp_epw *epw = taken(&made);
    assert_string_equal(epw->place, "Brussels, BEL");
    assert_near(epw->latitude_rad, 50.90 * PP_RAD, 1e-15);
    assert_near(epw->longitude_rad, 4.53 * PP_RAD, 1e-15);
    assert_near(epw->time_zone_h, 1.0, 0.0);
    assert_int_equal(epw->record_count, 24);
    assert_int_equal(epw->summer_from.month, 3);
    assert_int_equal(epw->summer_to.day, 28);
    const struct pp_epw_record *record = &epw->records[13];
    assert_int_equal(record->year, 1991);
    assert_int_equal(record->weekday, 2);
    assert_near(record->start_h, 13.0, 0.0); /* hour 14 is from 13:00 */
    assert_near(record->dew_point_c, 7.5, 0.0);
    assert_near(record->global_w_m2, 213.4, 0.0);
    assert_true(isnan(record->direct_w_m2));
    assert_near(record->diffuse_w_m2, 0.0, 0.0);
    assert_near(record->diffuse_lx, 13425.0, 0.0);
    done(&made, epw);
}

/* Every code for a missing value, and an empty field. */
static void missing_values_are_nan(void **state)
{
    (void)state;
    static const char *const codes[] = {"999900", "999999", "999900.0", ""};
    struct made_epw made;
    epw_begin(&made);
    epw_header(&made, "No", "1,1,Data,,1/1,1/1");
    for (int hour = 1; hour <= 24; hour++)
        epw_record(&made, 2001, 1, 1, hour, 0, "9999.", "99999", "", codes[hour % 4]);
    struct pp_epw *epw = taken(&made);
    for (int i = 0; i < 24; i++) {
        const struct pp_epw_record *record = &epw->records[i];
        assert_true(isnan(record->diffuse_lx) && isnan(record->diffuse_w_m2)
                    && isnan(record->global_w_m2) && isnan(record->direct_w_m2));
        assert_int_equal(record->weekday, PP_WEEKDAY_UNKNOWN);
    }
    done(&made, epw);
}

/* Line ends of DOS and old Macintosh; a byte order mark; blank lines; DOS's end of
 * file; no end of the last line. */
static void lines_end_as_they_like(void **state)
{
    (void)state;
    static const char *const ends[] = {"\n",       "\r\n",     "\r",
                                       "  \t\r\n", "\r\n\r\n", "\n \n"};
    for (int i = 0; i < 12; i++) {
        struct made_epw made;
        epw_begin(&made);
        if (i % 2)
            fputs("\xEF\xBB\xBF", made.out);
        made.end = ends[i / 2];
        epw_header(&made, "No", "1,1,Data,Friday,7/31,8/1");
        epw_day(&made, 2018, 7, 31, "5000");
        epw_day(&made, 2018, 8, 1, "7000");
        if (i % 3 == 1)
            fputs("\x1A", made.out);
        size_t whole = strlen(epw_bytes(&made));
        if (i % 3 == 2)
            whole -= strlen(made.end);
        struct pp_epw *epw = epw_parsed(made.text, whole, said, sizeof said);
        assert_non_null(epw);
        assert_int_equal(epw->record_count, 48);
        assert_near(epw->records[47].diffuse_lx, 7000.0, 0.0);
        assert_int_equal(epw->records[47].weekday, 5);
        done(&made, epw);
    }
}

/* The line number of a mistake does not depend on the kind of line ends. */
static void lines_are_counted_however_they_end(void **state)
{
    (void)state;
    static const char *const ends[] = {"\n", "\r\n", "\r"};
    for (int i = 0; i < 3; i++) {
        struct made_epw made;
        epw_begin(&made);
        made.end = ends[i];
        epw_header(&made, "No", "1,1,Data,Friday,7/31,7/31");
        epw_record(&made, 2018, 7, 31, 1, 0, "0", "0", "0", "0");
        epw_record(&made, 2018, 7, 31, 2, 0, "0", "0", "0", "dark");
        assert_refused(&made, 10,
                       "diffuse horizontal illuminance (field 19) is \"dark\"");
    }
}

/* 29 February may be in the file if the header says so or says nothing, and in a leap
 * year in any case. It may be missing if the header does not say that it is there. */
static void a_leap_day_may_be_there(void **state)
{
    (void)state;
    static const struct {
        const char *leap;
        int year;
        bool there;
    } cases[] = {{"Yes", 2024, true}, {"", 2024, true},  {"No", 2024, true},
                 {"Yes", 1991, true}, {"", 1991, true},  {"No", 2023, false},
                 {"No", 2024, false}, {"", 2024, false}, {"yes", 2000, true},
                 {"no", 1991, false}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct made_epw made;
        epw_begin(&made);
        epw_header(&made, cases[i].leap, "1,1,Data,Monday,2/27,3/1");
        epw_day(&made, cases[i].year, 2, 27, "1");
        epw_day(&made, cases[i].year, 2, 28, "1");
        if (cases[i].there)
            epw_day(&made, cases[i].year, 2, 29, "1");
        epw_day(&made, cases[i].year, 3, 1, "1");
        struct pp_epw *epw = taken(&made);
        assert_int_equal(epw->record_count, cases[i].there ? 96 : 72);
        assert_int_equal(epw->records[epw->record_count - 1].weekday,
                         cases[i].there ? 3 : 2);
        done(&made, epw);
    }
}

static void a_leap_day_against_the_header_is_a_mistake(void **state)
{
    (void)state;
    struct made_epw made;
    epw_begin(&made);
    epw_header(&made, "No", "1,1,Data,Monday,2/28,3/1");
    epw_day(&made, 1991, 2, 28, "1");
    epw_day(&made, 1991, 2, 29, "1");
    assert_refused(&made, 33, "1991 is not a leap year according to line 5");

    epw_begin(&made);
    epw_header(&made, "Yes", "1,1,Data,Monday,2/28,3/1");
    epw_day(&made, 1991, 2, 28, "1");
    epw_day(&made, 1991, 3, 1, "1");
    assert_refused(&made, 33, "the record for 29 February is missing");

    epw_begin(&made);
    epw_header(&made, "Maybe", "1,1,Data,Monday,2/28,3/1");
    assert_refused(&made, 5, "the leap year entry (field 2) is \"Maybe\"");
}

/* A period that ends on 29 February, in a year without this day, followed by another
 * period. */
static void a_period_may_end_on_a_day_that_is_not_there(void **state)
{
    (void)state;
    struct made_epw made;
    epw_begin(&made);
    epw_header(&made, "", "2,1,Winter,Monday,2/28,2/29,Summer,Friday,6/2,6/2");
    epw_day(&made, 1991, 2, 28, "1");
    epw_day(&made, 1991, 6, 1, "1");
    assert_refused(
        &made, 33,
        "this is a record of 1 June, hour 1, but 2 June, hour 1 was expected");

    epw_begin(&made);
    epw_header(&made, "", "2,1,Winter,Monday,2/28,2/29,Spring,Friday,3/1,3/1");
    epw_day(&made, 1991, 2, 28, "1");
    epw_day(&made, 1991, 3, 1, "1");
    struct pp_epw *epw = taken(&made);
    assert_int_equal(epw->record_count, 48);
    assert_int_equal(epw->records[47].weekday, 4);
    done(&made, epw);

    epw_begin(&made);
    epw_header(&made, "", "1,1,Winter,Monday,2/28,2/29");
    epw_day(&made, 1991, 2, 28, "1");
    epw_day(&made, 1991, 3, 1, "1");
    assert_refused(&made, 33, "after the end of the last data period");

    epw_begin(&made);
    epw_header(&made, "", "1,1,Winter,Monday,2/28,2/29");
    epw_day(&made, 1991, 2, 28, "1");
    epw = taken(&made);
    assert_int_equal(epw->record_count, 24);
    done(&made, epw);
}

/* Four records an hour, with minutes from 15 to 60, or from 0, or up to the 0 of the
 * next hour. */
static void records_may_be_closer_than_an_hour(void **state)
{
    (void)state;
    static const int minutes[][4] = {
        {15, 30, 45, 60}, {0, 15, 30, 45}, {15, 30, 45, 0}};
    for (int k = 0; k < 3; k++) {
        struct made_epw made;
        epw_begin(&made);
        epw_header(&made, "No", "1,4,Data,Monday,5/5,5/5");
        for (int i = 0; i < 96; i++)
            epw_record(&made, 2019, 5, 5, 1 + i / 4, minutes[k][i % 4], "0", "0", "0",
                       "8");
        struct pp_epw *epw = taken(&made);
        assert_near(epw->record_h, 0.25, 0.0);
        assert_int_equal(epw->record_count, 96);
        assert_near(epw->records[38].start_h, 9.5, 1e-12);
        done(&made, epw);
    }
}

static void several_data_periods_follow_each_other(void **state)
{
    (void)state;
    struct made_epw made;
    epw_begin(&made);
    epw_header(&made, "No", "2,1,A,Monday,12/31,1/1,B,Sunday,6/30/2001,7/1/2001");
    epw_day(&made, 1999, 12, 31, "1");
    epw_day(&made, 2000, 1, 1, "2");
    epw_day(&made, 2001, 6, 30, "3");
    epw_day(&made, 2001, 7, 1, "4");
    struct pp_epw *epw = taken(&made);
    assert_int_equal(epw->record_count, 96);
    assert_int_equal(epw->records[24].weekday, 1);
    assert_int_equal(epw->records[48].weekday, 6);
    assert_int_equal(epw->records[95].weekday, 0);
    done(&made, epw);
}

/* The dates of the period in the header contain its years. */
static void a_period_may_take_years(void **state)
{
    (void)state;
    static const int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    struct made_epw made;
    epw_begin(&made);
    epw_header(&made, "No", "1,1,A,Monday,1/1/2001,12/31/2002");
    for (int year = 2001; year <= 2002; year++)
        for (int month = 1; month <= 12; month++)
            for (int day = 1; day <= days[month - 1]; day++)
                epw_day(&made, year, month, day, "1");
    struct pp_epw *epw = taken(&made);
    assert_int_equal(epw->record_count, 2 * 8760);
    done(&made, epw);
}

/* Latin-1 is converted to UTF-8, and UTF-8 is kept; quotes and commas in a name. */
static void a_place_is_named_in_utf8(void **state)
{
    (void)state;
    static const char *const names[][2] = {
        {"Z\xFCrich,-,CHE", "Z\xC3\xBCrich, CHE"},
        {"Z\xC3\xBCrich,,CHE", "Z\xC3\xBCrich, CHE"},
        {"\"Bonn, am Rhein\",NW,DEU", "Bonn, am Rhein, NW, DEU"}};
    for (int i = 0; i < 3; i++) {
        struct made_epw made;
        epw_begin(&made);
        fprintf(made.out, "LOCATION,%s,x,1,47.4,8.5,1,400\n", names[i][0]);
        epw_line(&made, "DATA PERIODS,1,1,Data,Monday,1/1,1/1");
        epw_day(&made, 2001, 1, 1, "0");
        struct pp_epw *epw = taken(&made);
        assert_string_equal(epw->place, names[i][1]);
        done(&made, epw);
    }
}

/* ---- rejected files ---- */

static void a_file_that_is_cut_off_is_refused(void **state)
{
    (void)state;
    struct made_epw made;
    epw_begin(&made);
    epw_header(&made, "No", "1,1,Data,Monday,1/1,12/31");
    epw_day(&made, 2001, 1, 1, "0");
    epw_day(&made, 2001, 1, 2, "0");
    assert_refused(
        &made, 56,
        "but a record of 3 January, hour 1 was expected: the file is incomplete");

    epw_begin(&made);
    epw_header(&made, "No", "1,1,Data,Monday,1/1,12/31");
    epw_record(&made, 2001, 1, 1, 1, 0, "0", "0", "0", "0");
    fputs("2001,1,1,2,0,?9,3.1,2.2,80,101000,0,0,31", made.out);
    assert_refused(&made, 10, "the record has 13 fields; expected 35");

    epw_begin(&made);
    epw_line(&made, EPW_LOCATION);
    epw_line(&made, "DESIGN CONDITIONS,0");
    assert_refused(&made, 2, "expected a DATA PERIODS line");
}

static void hours_out_of_order_are_refused(void **state)
{
    (void)state;
    struct made_epw made;
    epw_begin(&made);
    epw_header(&made, "No", "1,1,Data,Monday,1/1,12/31");
    epw_day(&made, 2001, 1, 1, "0");
    epw_record(&made, 2001, 1, 2, 2, 0, "0", "0", "0", "0");
    assert_refused(
        &made, 33,
        "this is a record of 2 January, hour 2, but 2 January, hour 1 was expected");

    epw_begin(&made);
    epw_header(&made, "No", "1,1,Data,Monday,1/1,1/1");
    epw_day(&made, 2001, 1, 1, "0");
    epw_day(&made, 2001, 1, 2, "0");
    assert_refused(&made, 33, "after the end of the last data period on line 8");

    epw_begin(&made);
    epw_header(&made, "No", "1,2,Data,Monday,1/1,1/1");
    epw_record(&made, 2001, 1, 1, 1, 30, "0", "0", "0", "0");
    epw_record(&made, 2001, 1, 1, 1, 30, "0", "0", "0", "0");
    assert_refused(&made, 10, "minute 30 (field 5) follows minute 30");
}

static void text_instead_of_numbers_is_named(void **state)
{
    (void)state;
    static const struct {
        const char *global, *direct, *diffuse, *lx, *words;
    } cases[] = {
        {"x1", "0", "0", "0", "global horizontal irradiance (field 14) is \"x1\""},
        {"0", "0", "-3", "0", "diffuse horizontal irradiance (field 16) is \"-3\""},
        {"0", "0", "0", "nan", "field 19) is \"nan\""},
        {"0", "0", "0", "1e400", "field 19) is \"1e400\""},
        {"0", "0", "0", "500000", "or 999900 for a missing value"},
        {"3000", "0", "0", "0", "0 to 2000, or 9999 for a missing value"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct made_epw made;
        epw_begin(&made);
        epw_header(&made, "No", "1,1,Data,Monday,1/1,1/1");
        epw_record(&made, 2001, 1, 1, 1, 0, cases[i].global, cases[i].direct,
                   cases[i].diffuse, cases[i].lx);
        assert_refused(&made, 9, cases[i].words);
    }
}

static void times_that_are_none_are_named(void **state)
{
    (void)state;
    static const struct {
        int year, month, day, hour, minute;
        const char *words;
    } cases[] = {{99, 1, 1, 1, 0, "the year (field 1) is \"99\""},
                 {2001, 13, 1, 1, 0, "the month (field 2) is \"13\""},
                 {2001, 4, 31, 1, 0, "the day (field 3) is \"31\""},
                 {2001, 1, 1, 0, 0, "the hour (field 4) is \"0\""},
                 {2001, 1, 1, 25, 0, "the hour (field 4) is \"25\""},
                 {2001, 1, 1, 1, 61, "the minute (field 5) is \"61\""}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct made_epw made;
        epw_begin(&made);
        epw_header(&made, "No", "1,1,Data,Monday,1/1,1/1");
        epw_record(&made, cases[i].year, cases[i].month, cases[i].day, cases[i].hour,
                   cases[i].minute, "0", "0", "0", "0");
        assert_refused(&made, 9, cases[i].words);
    }
}

/* One wrong header line each; the rest of the file is valid. */
static void header_lines_that_are_wrong_are_named(void **state)
{
    (void)state;
    static const struct {
        const char *location, *periods;
        int line;
        const char *words;
    } cases[] = {
        {"LOCATION,A,B,C,D,1,91,4,1,0", "1,1,D,,1/1,1/1", 1, "the latitude (field 7)"},
        {"LOCATION,A,B,C,D,1,51,x,1,0", "1,1,D,,1/1,1/1", 1, "the longitude (field 8)"},
        {"LOCATION,A,B,C,D,1,51,4", "1,1,D,,1/1,1/1", 1,
         "the time zone (field 9) is \"\""},
        {"LOCATE,A", "1,1,D,,1/1,1/1", 1, "expected LOCATION"},
        {EPW_LOCATION, "0,1,D,,1/1,1/1", 2, "the number of data periods"},
        {EPW_LOCATION, "1,7,D,,1/1,1/1", 2, "that divides 60"},
        {EPW_LOCATION, "1,2.5,D,,1/1,1/1", 2, "that divides 60"},
        {EPW_LOCATION, "2,1,D,,1/1,1/1", 2, "has 7 fields; expected 11"},
        {EPW_LOCATION, "1,1,D,Moonday,1/1,1/1", 2, "starts on \"Moonday\""},
        {EPW_LOCATION, "1,1,D,,1/32,1/1", 2, "from \"1/32\" to \"1/1\""},
        {EPW_LOCATION, "1,1,D,,1/1,1.Jan", 2, "expected two dates as MONTH/DAY"},
        {EPW_LOCATION, "1,1,D,,1/1/2001,1/1/2000", 2, "ends before it begins"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct made_epw made;
        epw_begin(&made);
        epw_line(&made, cases[i].location);
        fprintf(made.out, "DATA PERIODS,%s\n", cases[i].periods);
        epw_day(&made, 2001, 1, 1, "0");
        assert_refused(&made, cases[i].line, cases[i].words);
    }
    struct made_epw made;
    epw_begin(&made);
    epw_line(&made, EPW_LOCATION);
    epw_day(&made, 2001, 1, 1, "0");
    assert_refused(&made, 2, "the records begin here; expected a DATA PERIODS line");

    epw_begin(&made);
    epw_line(&made, EPW_LOCATION);
    epw_line(&made, EPW_LOCATION);
    assert_refused(&made, 2, "a second LOCATION");

    epw_begin(&made);
    epw_line(&made, EPW_LOCATION);
    epw_line(&made, "WEATHER,1");
    assert_refused(&made, 2, "starts with \"WEATHER\"");
}

/* Empty files, UTF-16, a NUL byte, files of other kinds, and a line that is too long. */
static void bytes_that_are_no_text_are_rejected(void **state)
{
    (void)state;
    static const struct {
        const char *bytes;
        size_t length;
        const char *words;
    } cases[] = {{"", 0, "1: the file is empty"},
                 {" \r\n\t\n", 5, "1: the file is empty"},
                 {"\xEF\xBB\xBF", 3, ": this is not a weather file"},
                 {"\xFF\xFEL\0O\0", 6, "1: the file is UTF-16"},
                 {"LOCATION,a\nDE\0SIGN", 18, "2: there is a NUL byte"},
                 {"<room version=\"1\">\n</room>", 26, "1: this is not a weather file"},
                 {"1,2,3\n", 6, "1: this is not a weather file"}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        assert_null(epw_parsed(cases[i].bytes, cases[i].length, said, sizeof said));
        if (!strstr(said, cases[i].words))
            fail_msg("said \"%s\"; expected %s", said, cases[i].words);
    }
    struct made_epw made;
    epw_begin(&made);
    epw_line(&made, EPW_LOCATION);
    for (int i = 0; i < 70000; i++)
        fputc(',', made.out);
    assert_refused(&made, 2, "there is a line of more than 65536 bytes");
}

/* A file with only mistakes: a limited number is reported. */
static void mistakes_are_reported_up_to_a_limit(void **state)
{
    (void)state;
    struct made_epw made;
    struct pp_mistakes mistakes;
    struct pp_epw *epw;
    epw_begin(&made);
    epw_header(&made, "No", "1,1,Data,Monday,1/1,1/2");
    epw_day(&made, 2001, 1, 1, "?");
    epw_day(&made, 2001, 1, 2, "?");
    pp_mistakes_init(&mistakes, "made.epw");
    const char *bytes = epw_bytes(&made);
    assert_int_equal(pp_epw_parse(&epw, bytes, made.length, &mistakes, NULL),
                     PP_BAD_INPUT);
    assert_int_equal(mistakes.count, 20);
    assert_true(mistakes.truncated);
    pp_mistakes_clear(&mistakes);
    epw_end(&made);
}

static void a_missing_file_is_named(void **state)
{
    (void)state;
    struct pp_mistakes mistakes;
    struct pp_epw *epw;
    struct pp_error err;
    pp_mistakes_init(&mistakes, "none.epw");
    assert_int_equal(pp_epw_read(&epw, "no/such.epw", &mistakes, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "no/such.epw: cannot be opened"));
    assert_int_equal(pp_epw_read(&epw, ".", &mistakes, &err), PP_BAD_INPUT);
    assert_int_equal(mistakes.count, 0);
    pp_mistakes_clear(&mistakes);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_record_has_its_place_time_and_values),
        cmocka_unit_test(missing_values_are_nan),
        cmocka_unit_test(lines_end_as_they_like),
        cmocka_unit_test(lines_are_counted_however_they_end),
        cmocka_unit_test(a_leap_day_may_be_there),
        cmocka_unit_test(a_leap_day_against_the_header_is_a_mistake),
        cmocka_unit_test(a_period_may_end_on_a_day_that_is_not_there),
        cmocka_unit_test(records_may_be_closer_than_an_hour),
        cmocka_unit_test(several_data_periods_follow_each_other),
        cmocka_unit_test(a_period_may_take_years),
        cmocka_unit_test(a_place_is_named_in_utf8),
        cmocka_unit_test(a_file_that_is_cut_off_is_refused),
        cmocka_unit_test(hours_out_of_order_are_refused),
        cmocka_unit_test(text_instead_of_numbers_is_named),
        cmocka_unit_test(times_that_are_none_are_named),
        cmocka_unit_test(header_lines_that_are_wrong_are_named),
        cmocka_unit_test(bytes_that_are_no_text_are_rejected),
        cmocka_unit_test(mistakes_are_reported_up_to_a_limit),
        cmocka_unit_test(a_missing_file_is_named),
    };
    add_tests(tests, NULL, NULL);
}
