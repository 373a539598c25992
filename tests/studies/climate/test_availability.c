/* test_availability.c - the hours in which a room has enough daylight
 * (studies/climate/availability.h), as figures and in a chart. */
#include <stdio.h>
#include <stdlib.h>

#include "tests/lib/room_of.h"
#include "tests/lib/sized.h"

#include "charts/availability_chart.h"
#include "studies/climate/availability.h"

static const char room[] =
    "<room version=\"1\" name=\"Hours\">\n"
    "<plan width=\"5.3\" depth=\"6.1\" height=\"2.9\"/>\n"
    "<window wall=\"south\" left=\"0.4\" sill=\"0.7\" width=\"1.9\" "
    "height=\"1.6\"/>\n"
    "</room>\n";

enum { HOURS = 10 };

/* Ten hours of a day from 8:00, of 1000, 2000 ... 10,000 lx, not in order. */
static void light_of(struct pp_diffuse_light *light, struct pp_diffuse_hour list[HOURS])
{
    for (int i = 0; i < HOURS; i++)
        list[i] = (struct pp_diffuse_hour){.date = {6, 21},
                                           .weekday = 3,
                                           .start_h = 8.0 + i,
                                           .length_h = 1.0,
                                           .lx = 1000.0 * (1 + 7 * i % HOURS)};
    *light = (struct pp_diffuse_light){
        .origin = PP_LIGHT_ILLUMINANCE, .count = HOURS, .list = list, .total_h = HOURS};
}

/* A report with one column of daylight factors: four points and an average. */
static void report_of(struct pp_report *report, const struct pp_world *world,
                      const double points[4], double average, double error)
{
    *report = (struct pp_report){.world = world,
                                 .receivers = world->receivers,
                                 .receiver_count = 4,
                                 .finished = true};
    struct pp_column *column = pp_report_add(report, PP_DF, "exact+bre", true);
    assert_non_null(column);
    for (int i = 0; i < 4; i++) {
        column->points[i] = pp_reading_of(points[i]);
        column->points[i].std_error = error;
    }
    column->average = pp_reading_of(average);
    column->average.std_error = error;
}

static struct pp_availability_question question_of(const struct pp_diffuse_light *light,
                                                   const struct pp_working_hours *hours,
                                                   int periods, const double *lx,
                                                   int illuminances)
{
    return (struct pp_availability_question){.light = light,
                                             .light_words = "a made-up day",
                                             .calendar_words = "all days",
                                             .period_count = periods,
                                             .periods = hours,
                                             .illuminance_count = illuminances,
                                             .illuminances_lx = lx};
}

/* ---- figures ---- */

static void two_per_cent_and_300_lx_need_15000(void **state)
{
    (void)state;
    assert_near(pp_availability_needed_lx(300.0, 0.02), 15000.0, 1e-9);
    assert_true(isinf(pp_availability_needed_lx(500.0, 0.0)));
}

/* Ten hours of 1000 ... 10,000 lx have 6000 or more in five. 150 lx require 6000 at 2.5
 * %, 3000 at 5 %, 75,000 at 0.2 %; where the daylight factor is zero, no illuminance is
 * enough. */
static void hours_are_counted_by_what_they_need(void **state)
{
    (void)state;
    static const struct pp_working_hours hours[] = {{8.0, 18.0, PP_ALL_DAYS},
                                                    {9.5, 11.0, PP_ALL_DAYS}};
    static const double lx[] = {150.0}, points[] = {0.025, 0.05, 0.002, 0.0};
    struct pp_world *world = pp_test_world(room);
    struct pp_diffuse_hour list[HOURS];
    struct pp_diffuse_light light;
    struct pp_report report;
    struct pp_availability_sheet sheet;
    light_of(&light, list);
    report_of(&report, world, points, 0.021, NAN);
    struct pp_availability_question question = question_of(&light, hours, 2, lx, 1);
    assert_int_equal(pp_availability_fill(&sheet, &question, &report, NULL), PP_OK);

    assert_string_equal(sheet.periods[0].words, "8-18");
    assert_string_equal(sheet.periods[1].words, "9:30-11");
    assert_near(sheet.periods[0].hours, 10.0, 1e-12);
    assert_near(sheet.periods[1].hours, 1.5, 1e-12);
    assert_near(sheet.periods[0].light, 1.0, 0.0);
    assert_near(sheet.periods[0].half_lx, 6000.0, 0.0);
    assert_near(sheet.periods[0].most_lx, 2000.0, 0.0); /* reached in 9 of 10 hours */

    assert_int_equal(sheet.row_count, 6);
    static const double needs[] = {6000.0, 3000.0, 75000.0, INFINITY};
    static const double shares[] = {0.5, 0.8, 0.0, 0.0};
    for (int i = 0; i < 4; i++) {
        assert_int_equal(sheet.rows[i].place, i);
        if (i < 3)
            assert_relative(sheet.rows[i].needs_lx, needs[i], 1e-12);
        else
            assert_true(isinf(sheet.rows[i].needs_lx));
        assert_near(sheet.rows[i].share[0], shares[i], 1e-12);
        assert_true(isnan(sheet.rows[i].std_error[0]));
    }
    /* From 9:30: half an hour of 8000 lx (hour 2) and one of 5000. */
    assert_near(sheet.rows[0].share[1], 0.5 / 1.5, 1e-12);
    assert_near(sheet.rows[1].share[1], 1.0, 1e-12);

    /* The median of 0, 0.2, 2.5 and 5 % is 1.35 %: 11,111 lx. */
    assert_int_equal(sheet.rows[4].place, PP_PLACE_MEDIAN);
    assert_near(sheet.rows[4].df.value, 0.0135, 1e-15);
    assert_near(sheet.rows[4].share[0], 0.0, 0.0);
    assert_int_equal(sheet.rows[5].place, PP_PLACE_AVERAGE);
    assert_near(sheet.rows[5].needs_lx, 150.0 / 0.021, 1e-9);
    assert_near(sheet.rows[5].share[0], 0.3,
                1e-12); /* 7143 lx: exceeded by 8, 9 and 10 thousand */
    pp_availability_sheet_clear(&sheet);
    pp_report_clear(&report);
    pp_world_destroy(world);
}

/* 2.5 +- 0.5 % require 5000 to 7500 lx: 6 or 3 of ten hours, so 1.5 in each direction.
 * A reading without a value has no hours, and keeps its reason. */
static void errors_of_daylight_factors_become_errors_of_hours(void **state)
{
    (void)state;
    static const struct pp_working_hours hours = {8.0, 18.0, PP_ALL_DAYS};
    static const double lx[] = {150.0, 300.0}, points[] = {0.025, 0.03, NAN, 0.05};
    struct pp_world *world = pp_test_world(room);
    struct pp_diffuse_hour list[HOURS];
    struct pp_diffuse_light light;
    struct pp_report report;
    struct pp_availability_sheet sheet;
    light_of(&light, list);
    report_of(&report, world, points, 0.025, 0.005);
    report.columns[0].points[2] = pp_reading_none("a fine day");
    struct pp_availability_question question = question_of(&light, &hours, 1, lx, 2);
    assert_int_equal(pp_availability_fill(&sheet, &question, &report, NULL), PP_OK);
    assert_int_equal(sheet.row_count, 12);
    assert_near(sheet.rows[0].std_error[0], 0.15, 1e-12);
    assert_string_equal(sheet.rows[4].df.why, "a fine day");
    assert_true(isnan(sheet.rows[4].needs_lx) && isnan(sheet.rows[4].share[0]));
    /* The median of the three values. */
    assert_near(sheet.rows[8].df.value, 0.03, 0.0);
    assert_near(sheet.rows[8].df.std_error, 0.005, 0.0);
    pp_availability_sheet_clear(&sheet);
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void hours_without_data_are_refused(void **state)
{
    (void)state;
    static const struct pp_working_hours night = {20.0, 23.0, PP_ALL_DAYS};
    struct pp_diffuse_hour list[HOURS];
    struct pp_diffuse_light light;
    struct pp_availability_sheet sheet;
    struct pp_error err;
    light_of(&light, list);
    struct pp_availability_question question = question_of(&light, &night, 1, NULL, 0);
    assert_int_equal(pp_availability_fill(&sheet, &question, NULL, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "from 20 to 23"));
    pp_availability_sheet_clear(&sheet);
}

/* ---- the chart ---- */

static char *drawn(const struct pp_availability_sheet *sheet,
                   enum pp_chart_format format, enum pp_paper paper, bool landscape,
                   size_t *length)
{
    const struct pp_sheet paper_sheet = {.format = format,
                                         .paper = paper,
                                         .landscape = landscape,
                                         .dpi = 40,
                                         .title = "Hours"};
    const unsigned char *bytes;
    struct pp_canvas *canvas;
    assert_int_equal(pp_canvas_create(&canvas, &paper_sheet, NULL), PP_OK);
    assert_int_equal(pp_availability_chart_draw(canvas, sheet, NULL), PP_OK);
    assert_int_equal(pp_canvas_finish(canvas, &bytes, length, NULL), PP_OK);
    char *copy = malloc(*length + 1);
    assert_non_null(copy);
    memcpy(copy, bytes, *length);
    copy[*length] = '\0';
    pp_canvas_destroy(canvas);
    return copy;
}

/* First stroke of the next path of an SVG that begins with a straight one: from its M
 * to its L. */
static const char *next_stroke(const char *at, double xy[4])
{
    while ((at = strstr(at, " d=\"M ")) != NULL) {
        at += 4;
        if (sscanf(at, "M %lf %lf L %lf %lf", &xy[0], &xy[1], &xy[2], &xy[3]) == 4)
            return at;
    }
    return NULL;
}

/* Longest horizontal stroke whose path continues, as that of a scale with its ticks
 * does: the scale of outdoor illuminance. */
static void find_scale(const char *svg, double xy[4])
{
    double one[4], longest = 0.0;
    for (const char *at = svg; (at = next_stroke(at, one)) != NULL;)
        if (one[1] == one[3] && one[2] - one[0] > longest
            && strchr(at, 'L')[1 + strcspn(strchr(at, 'L') + 1, "MCL\"")] == 'M') {
            longest = one[2] - one[0];
            memcpy(xy, one, sizeof one);
        }
}

/* 90 lx at 2 % require 4500 of the 10,000 lx at the end of the scale: the line is at
 * 0.45 of its length, to the last digit printed by cairo, and longer than 100 units. */
static void required_illuminance_is_marked_at_its_place_on_the_scale(void **state)
{
    (void)state;
    static const struct pp_working_hours hours = {8.0, 18.0, PP_ALL_DAYS};
    static const double lx[] = {90.0}, points[] = {0.02, 0.02, 0.02, 0.02};
    struct pp_world *world = pp_test_world(room);
    struct pp_diffuse_hour list[HOURS];
    struct pp_diffuse_light light;
    struct pp_report report;
    struct pp_availability_sheet sheet;
    light_of(&light, list);
    report_of(&report, world, points, 0.02, NAN);
    struct pp_availability_question question = question_of(&light, &hours, 1, lx, 1);
    assert_int_equal(pp_availability_fill(&sheet, &question, &report, NULL), PP_OK);

    size_t length;
    char *svg = drawn(&sheet, PP_CHART_SVG, PP_PAPER_A4, true, &length);
    double scale[4] = {0}, one[4];
    bool found = false;
    find_scale(svg, scale);
    double wanted = scale[0] + 0.45 * (scale[2] - scale[0]);
    for (const char *at = svg; (at = next_stroke(at, one)) != NULL;)
        found |= one[0] == one[2] && fabs(one[0] - wanted) < 0.005
                 && fabs(one[3] - one[1]) > 100.0;
    assert_true(found);
    assert_non_null(strstr(svg, "<title"));
    free(svg);
    pp_availability_sheet_clear(&sheet);
    pp_report_clear(&report);
    pp_world_destroy(world);
}

/* The largest numbers of periods and illuminances, with and without a room, drawn twice
 * in three formats; at full size also on every paper size in both orientations. */
static void the_chart_fits_any_sheet_and_is_reproducible(void **state)
{
    (void)state;
    static const double lx[] = {10, 50, 100, 110, 120, 130, 140, 200},
                        points[] = {0.02, 0.03, 0.01, 0.0};
    struct pp_working_hours hours[PP_PERIODS_MOST];
    struct pp_world *world = pp_test_world(room);
    struct pp_diffuse_hour list[HOURS];
    struct pp_diffuse_light light;
    struct pp_report report;
    light_of(&light, list);
    report_of(&report, world, points, 0.02, NAN);
    for (int i = 0; i < PP_PERIODS_MOST; i++)
        hours[i] = (struct pp_working_hours){8.0, 10.5 + i, PP_ALL_DAYS};
    for (int with_room = 0; with_room < 2; with_room++) {
        struct pp_availability_sheet sheet;
        struct pp_availability_question question =
            question_of(&light, hours, PP_PERIODS_MOST, lx, PP_ILLUMINANCES_MOST);
        assert_int_equal(
            pp_availability_fill(&sheet, &question, with_room ? &report : NULL, NULL),
            PP_OK);
        for (int i = 0; i < PP_SIZED(24, 3, 3); i++) {
            size_t first, second;
            enum pp_chart_format format = (enum pp_chart_format)(i % 3);
            enum pp_paper paper = (enum pp_paper)(i / 3 % 4);
            char *a = drawn(&sheet, format, paper, i < 12, &first);
            char *b = drawn(&sheet, format, paper, i < 12, &second);
            assert_int_equal(first, second);
            assert_memory_equal(a, b, first);
            free(a);
            free(b);
        }
        pp_availability_sheet_clear(&sheet);
    }
    pp_report_clear(&report);
    pp_world_destroy(world);
}

/* A room without daylight or without a value also has a chart. */
static void a_dark_room_has_its_chart(void **state)
{
    (void)state;
    static const struct pp_working_hours hours = {8.0, 18.0, PP_ALL_DAYS};
    static const double lx[] = {300.0}, points[] = {0.0, 0.0, 0.0, 0.0};
    struct pp_world *world = pp_test_world(room);
    struct pp_diffuse_hour list[HOURS];
    struct pp_diffuse_light light;
    light_of(&light, list);
    for (int k = 0; k < 2; k++) {
        struct pp_report report;
        struct pp_availability_sheet sheet;
        report_of(&report, world, points, 0.0, NAN);
        if (k)
            report.columns[0].average = pp_reading_none("no reason");
        for (int i = 0; k && i < HOURS; i++)
            list[i].lx = 0.0; /* and all hours dark */
        struct pp_availability_question question =
            question_of(&light, &hours, 1, lx, 1);
        assert_int_equal(pp_availability_fill(&sheet, &question, &report, NULL), PP_OK);
        size_t length;
        char *pdf = drawn(&sheet, PP_CHART_PDF, PP_PAPER_A5, false, &length);
        assert_memory_equal(pdf, "%PDF", 4);
        free(pdf);
        pp_availability_sheet_clear(&sheet);
        pp_report_clear(&report);
    }
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_per_cent_and_300_lx_need_15000),
        cmocka_unit_test(hours_are_counted_by_what_they_need),
        cmocka_unit_test(errors_of_daylight_factors_become_errors_of_hours),
        cmocka_unit_test(hours_without_data_are_refused),
        cmocka_unit_test(required_illuminance_is_marked_at_its_place_on_the_scale),
        cmocka_unit_test(the_chart_fits_any_sheet_and_is_reproducible),
        cmocka_unit_test(a_dark_room_has_its_chart),
    };
    add_tests(tests, NULL, NULL);
}
