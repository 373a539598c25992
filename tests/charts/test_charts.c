/* test_charts.c - section, plan and availability charts: their contents, their true
 * scales, and unusual data. */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "charts/sheet/axis.h"
#include "api/chart_kind.h"
#include "charts/room/plan_chart.h"
#include "charts/room/room_plan.h"
#include "charts/section/section_chart.h"
#include "charts/sheet/style.h"
#include "tests/lib/room_of.h"

#define ROOM                                                                           \
    "<plan width=\"3.2\" depth=\"7.4\" height=\"2.7\"/>"                               \
    "<window wall=\"south\" left=\"0.4\" sill=\"0.9\" width=\"2.4\" height=\"1.4\" "   \
    "reveal=\"0.2\"/><skyline wall=\"south\" angle=\"22\" distance=\"15\"/>"
#define LINE "<line from=\"1.6 6.9\" to=\"1.6 0.5\" points=\"9\"/>"

static struct pp_world *world_of(struct pp_outside_light *light, const char *name,
                                 const char *body)
{
    char text[4096];
    snprintf(text, sizeof text, "<room version=\"1\" name=\"%s\">%s</room>", name,
             body);
    return pp_test_lit_world(light, text);
}

static struct pp_report report_of(const struct pp_world *world,
                                  const struct pp_outside_light *light)
{
    return (struct pp_report){.world = world,
                              .light = *light,
                              .receivers = world->receivers,
                              .receiver_count = world->receiver_count,
                              .finished = true};
}

static void add_columns(struct pp_report *report)
{
    static const char *const names[] = {"exact+bre", "brs-table+bre", "traced"};
    for (int c = 0; c < 3; c++) {
        struct pp_column *column = pp_report_add(report, PP_DF, names[c], true);
        assert_non_null(column);
        for (int i = 0; i < report->receiver_count; i++) {
            double y = report->receivers[i].position.y;
            column->points[i] = pp_reading_of(0.004 + 0.09 * exp(-y / (1.4 + 0.1 * c)));
            if (c == 2)
                column->points[i].std_error = 0.0004;
        }
    }
    struct pp_column *average = pp_report_add(report, PP_DF, "average-df", false);
    average->average = pp_reading_of(0.0213);
}

static char *finish(struct pp_canvas *canvas, size_t *length)
{
    const unsigned char *bytes;
    struct pp_error err;
    if (pp_canvas_finish(canvas, &bytes, length, &err) != PP_OK)
        fail_msg("%s", err.message);
    char *copy = malloc(*length + 1);
    memcpy(copy, bytes, *length);
    copy[*length] = 0;
    pp_canvas_destroy(canvas);
    return copy;
}

static struct pp_canvas *canvas_of(enum pp_chart_format format, enum pp_paper paper,
                                   bool landscape)
{
    struct pp_sheet sheet = {.format = format,
                             .paper = paper,
                             .landscape = landscape,
                             .title = "Test",
                             .description = "A test"};
    struct pp_canvas *canvas;
    assert_int_equal(pp_canvas_create(&canvas, &sheet, 0), PP_OK);
    return canvas;
}

static char *section(const struct pp_report *report, enum pp_section_scale scale,
                     enum pp_chart_format format, size_t *length)
{
    static const char *const notes[] = {"Clear single glass."};
    struct pp_section_chart chart = {report, scale, notes, 1};
    struct pp_error err;
    struct pp_canvas *canvas = canvas_of(format, PP_PAPER_A4, false);
    if (pp_section_chart_draw(canvas, &chart, &err) != PP_OK)
        fail_msg("%s", err.message);
    return finish(canvas, length);
}

/* Text of a PDF, white space as single blanks; NULL if pdftotext is not installed. */
static char *words_of(const char *pdf, size_t length)
{
    if (system("command -v pdftotext >/dev/null") != 0)
        return 0;
    char name[] = "test_charts.XXXXXX", command[64];
    int fd = mkstemp(name);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, pdf, length), (ssize_t)length);
    close(fd);
    snprintf(command, sizeof command, "pdftotext -layout %s -", name);
    FILE *pipe = popen(command, "r");
    char *words = calloc(1, 65536);
    size_t count = 0;
    for (int c; (c = getc(pipe)) != EOF && count < 65000;) {
        /* A no-break space is C2 A0 in UTF-8. */
        if (c == 0xC2) {
            int next = getc(pipe);
            if (next == 0xA0) {
                c = ' ';
            } else {
                words[count++] = (char)c;
                c = next;
            }
        }
        if (c == '\n' || c == '\f')
            c = ' ';
        if (c != ' ' || (count && words[count - 1] != ' '))
            words[count++] = (char)c;
    }
    pclose(pipe);
    unlink(name);
    return words;
}

static void assert_says(char *pdf, size_t length, const char *const *sayings)
{
    char *words = words_of(pdf, length);
    free(pdf);
    if (!words)
        return;
    for (; *sayings; sayings++)
        if (!strstr(words, *sayings))
            fail_msg("\"%s\" is not on the chart: %s", *sayings, words);
    free(words);
}

static void a_section_names_room_sky_methods_scale_and_notes(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world =
        world_of(&light, "B\xc3\xbcro \xce\xa9 \xe2\x80\x94 12", ROOM LINE);
    struct pp_report report = report_of(world, &light);
    add_columns(&report);
    size_t length;
    char *pdf = section(&report, false, PP_CHART_PDF, &length);
    static const char *const sayings[] = {
        "B\xc3\xbcro \xce\xa9 \xe2\x80\x94 12",
        "CIE overcast sky",
        "Daylight factor (%)",
        "exact+bre",
        "brs-table+bre",
        "simulated \xc2\xb1 standard error",
        "average-df, room average 2.1 %",
        "Distance from the window wall (m)",
        "Section A\u2013A, 1:50.",
        "sill 0.9 m, head 2.3 m",
        "skyline 22\xc2\xb0",
        "at 15 m",
        "W1",    /* the window, */
        "south", /* its wall, */
        "7.4 m", /* the length */
        "2.7 m", /* and the height of the room */
        "Glass with a normal transmittance of 0.9; frame factor 1,",
        "ground 0.2. Clear single glass.",
        NULL};
    assert_says(pdf, length, sayings);
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void the_same_chart_is_the_same_bytes(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, "Twice", ROOM LINE);
    struct pp_report report = report_of(world, &light);
    add_columns(&report);
    for (int format = PP_CHART_PDF; format <= PP_CHART_PNG; format++) {
        size_t once, twice;
        char *first = section(&report, true, (enum pp_chart_format)format, &once);
        char *second = section(&report, true, (enum pp_chart_format)format, &twice);
        assert_int_equal(once, twice);
        assert_memory_equal(first, second, once);
        free(first);
        free(second);
    }
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void points_that_do_not_lie_on_a_line_are_refused_with_the_one_that_strays(
    void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world =
        world_of(&light, "Zigzag",
                 ROOM "<point x=\"1\" y=\"1\"/><point x=\"1\" y=\"5\"/>"
                      "<point x=\"1.4\" y=\"3\"/>");
    struct pp_report report = report_of(world, &light);
    add_columns(&report);
    struct pp_section_chart chart = {&report, false, 0, 0};
    struct pp_canvas *canvas = canvas_of(PP_CHART_PDF, PP_PAPER_A4, true);
    struct pp_error err;
    assert_int_equal(pp_section_chart_draw(canvas, &chart, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "(1.4, 3, 0.85) is 0.4 m off the line"));
    report.receiver_count = 0;
    assert_int_equal(pp_section_chart_draw(canvas, &chart, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "but there are none"));
    pp_canvas_destroy(canvas);
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void a_slanting_line_is_a_line_too(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world =
        world_of(&light, "Slanting",
                 ROOM "<line from=\"0.4 0.5\" to=\"2.8 6.7\" points=\"7\"/>");
    struct pp_report report = report_of(world, &light);
    add_columns(&report);
    size_t length;
    static const char *const sayings[] = {"exact+bre", "Section A\u2013A, 1:", NULL};
    char *pdf = section(&report, false, PP_CHART_PDF, &length);
    assert_says(pdf, length, sayings);
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void one_point_is_drawn(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, "One", ROOM "<point x=\"1\" y=\"2.2\"/>");
    struct pp_report report = report_of(world, &light);
    add_columns(&report);
    size_t length;
    static const char *const sayings[] = {"exact+bre", "Section A\u2013A, 1:50", NULL};
    char *pdf = section(&report, false, PP_CHART_PDF, &length);
    assert_says(pdf, length, sayings);
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void missing_values_have_a_reason(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, "Gaps", ROOM LINE);
    struct pp_report report = report_of(world, &light);
    add_columns(&report);
    report.columns[1].points[3] = pp_reading_none("window 1 is hidden");
    report.columns[1].points[8] = pp_reading_none("window 1 is hidden");
    report.columns[3].average = pp_reading_none("the sky is uniform");
    report.finished = false;
    size_t length;
    static const char *const sayings[] = {
        "brs-table+bre has no value at 2 of 9 points: window 1 is hidden.",
        "average-df has no value: the sky is uniform.", "The run was interrupted",
        NULL};
    char *pdf = section(&report, true, PP_CHART_PDF, &length);
    assert_says(pdf, length, sayings);
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void a_report_without_values_has_a_note_on_the_chart(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, "Nothing", ROOM LINE);
    struct pp_report report = report_of(world, &light);
    size_t length;
    static const char *const sayings[] = {"No method gives a daylight factor.",
                                          "Section A\u2013A, 1:50", NULL};
    char *pdf = section(&report, false, PP_CHART_PDF, &length);
    assert_says(pdf, length, sayings);

    /* All values null, on every scale. */
    add_columns(&report);
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < report.receiver_count; i++)
            report.columns[c].points[i] = pp_reading_none("no reason");
    report.columns[3].average = pp_reading_none(0);
    for (int scale = PP_SCALE_AS_FITS; scale <= PP_SCALE_LOG; scale++) {
        pdf = section(&report, scale, PP_CHART_PDF, &length);
        assert_says(pdf, length, sayings);
    }
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void zeros_infinities_and_extremes_are_drawn_without_a_fault(void **state)
{
    (void)state;
    static const double values[] = {0.0, 1e-5, 0.6, INFINITY, -0.01, 1e-300, 1e300};
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, "Odd", ROOM LINE);
    for (int v = 0; v < 7; v++) {
        struct pp_report report = report_of(world, &light);
        add_columns(&report);
        for (int i = 0; i < report.receiver_count; i++)
            report.columns[0].points[i].value = values[v];
        report.columns[2].points[4].std_error = v == 6 ? 1e300 : 10.0;
        for (int scale = PP_SCALE_AS_FITS; scale <= PP_SCALE_LOG; scale++) {
            size_t length;
            free(section(&report, scale, PP_CHART_SVG, &length));
            assert_true(length > 1000);
        }
        pp_report_clear(&report);
    }
    pp_world_destroy(world);
}

static void dozens_of_methods_get_a_legend(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, "Many", ROOM LINE);
    struct pp_report report = report_of(world, &light);
    for (int c = 0; c < 30; c++) {
        char name[32];
        snprintf(name, sizeof name, "method-%d+bre", c);
        struct pp_column *column = pp_report_add(&report, PP_DF, name, true);
        for (int i = 0; i < report.receiver_count; i++)
            column->points[i] = pp_reading_of(0.01 + 0.001 * c / (1 + i));
    }
    size_t length;
    static const char *const sayings[] = {"method-0+bre", "method-29+bre", NULL};
    char *pdf = section(&report, false, PP_CHART_PDF, &length);
    assert_says(pdf, length, sayings);
    pp_report_clear(&report);
    pp_world_destroy(world);
}

/* ---- plan ---- */

static double no_sky_xy[][2] = {{0.6, 4.0}, {2.6, 4.0}};
static double contour_xy[][2] = {{0.0, 2.0}, {1.7, 2.9}, {3.2, 2.0}};

static struct pp_daylight_plan plan_by_hand(void)
{
    static struct pp_curve no_sky = {0, false, 2, no_sky_xy};
    static struct pp_curve contour = {0.02, false, 3, contour_xy};
    return (struct pp_daylight_plan){.name = "exact+bre",
                                     .contours = {1, &contour},
                                     .no_sky = {1, &no_sky},
                                     .lowest = 0.004,
                                     .highest = 0.12,
                                     .sky_share = 0.7};
}

static char *plan_chart(const struct pp_world *world,
                        const struct pp_outside_light *light,
                        const struct pp_daylight_plan *plan,
                        enum pp_chart_format format, enum pp_paper paper,
                        size_t *length)
{
    struct pp_report report = report_of(world, light);
    struct pp_plan_chart chart = {
        .world = world, .light = light, .plan = plan, .report = &report};
    struct pp_canvas *canvas = canvas_of(format, paper, pp_plan_chart_landscape(world));
    assert_int_equal(pp_plan_chart_draw(canvas, &chart, 0), PP_OK);
    return finish(canvas, length);
}

static void a_plan_is_to_the_scale_that_it_states(void **state)
{
    (void)state;
    static const struct {
        enum pp_paper paper;
        const char *scale;
        double mm; /* distance on paper of 2 m on the no-sky line */
    } rows[] = {{PP_PAPER_A5, "1:75", 2000.0 / 75.0},
                {PP_PAPER_A4, "1:50", 40.0},
                {PP_PAPER_A2, "1:20", 100.0}};
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, "Plan", ROOM LINE);
    struct pp_daylight_plan plan = plan_by_hand();
    for (int i = 0; i < 3; i++) {
        size_t length;
        const char *const sayings[] = {
            rows[i].scale, "no-sky line", "daylight factor by exact+bre (%)",
            "Skyline of 22\xc2\xb0 in front of wall south.", NULL};
        char *pdf =
            plan_chart(world, &light, &plan, PP_CHART_PDF, rows[i].paper, &length);
        assert_says(pdf, length, sayings);

        /* The only dashed line of two points is the no-sky line. */
        char *svg =
            plan_chart(world, &light, &plan, PP_CHART_SVG, rows[i].paper, &length);
        double found = 0.0;
        for (const char *at = svg; (at = strstr(at, "stroke-dasharray:")); at++) {
            double x0, y0, x1, y1;
            const char *path = strstr(at, " d=\"");
            if (path
                && sscanf(path, " d=\"M %lf %lf L %lf %lf", &x0, &y0, &x1, &y1) == 4
                && fabs(y1 - y0) < 1e-3)
                found = fmax(found, fabs(x1 - x0) / 72.0 * 25.4);
        }
        const char *matrix = strstr(svg, "matrix(");
        double xx = 1.0;
        if (matrix)
            sscanf(matrix, "matrix(%lf", &xx);
        assert_near(found * xx, rows[i].mm, 0.1);
        free(svg);
    }
    pp_world_destroy(world);
}

static void a_plan_without_contours_has_a_note(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, "Cellar", ROOM LINE);
    struct pp_daylight_plan plan = {.name = "exact"};
    size_t length;
    static const char *const dark[] = {"No contours: there is no daylight.", NULL};
    char *pdf = plan_chart(world, &light, &plan, PP_CHART_PDF, PP_PAPER_A4, &length);
    assert_says(pdf, length, dark);
    plan.lowest = plan.highest = 0.0123;
    static const char *const flat[] = {"approximately",
                                       "1.2 % everywhere",
                                       "W1",
                                       "south",
                                       "north",
                                       "3.2 m",
                                       "7.4 m",
                                       NULL};
    pdf = plan_chart(world, &light, &plan, PP_CHART_PDF, PP_PAPER_A4, &length);
    assert_says(pdf, length, flat);
    pp_world_destroy(world);
}

static void small_rooms_and_halls_find_a_usual_scale(void **state)
{
    (void)state;
    static const struct {
        const char *plan;
        double scale;
    } rows[] = {{"<plan width=\"1\" depth=\"1.2\" height=\"2\"/>", 10},
                {"<plan width=\"100\" depth=\"60\" height=\"9\"/>", 750},
                {"<plan width=\"17\" depth=\"11\" height=\"3\"/>", 100}};
    struct pp_style style = pp_style_for(210.0);
    for (int i = 0; i < 3; i++) {
        struct pp_outside_light light;
        struct pp_world *world = world_of(&light, "Scale", rows[i].plan);
        struct pp_room_plan plan = {0};
        pp_room_plan_fit(&plan, world, &style, 180.0, 180.0);
        assert_near(plan.scale, rows[i].scale, 1e-9);
        pp_world_destroy(world);
    }
}

/* ---- axes and numbers ---- */

static void ticks_are_round_and_cover_the_values(void **state)
{
    (void)state;
    struct pp_axis axis = pp_axis_linear(0.0, 9.3, 100.0, 0.0, 8.0, true);
    assert_near(axis.high, 10.0, 1e-12);
    assert_int_equal(axis.tick_count, 11);
    assert_near(pp_axis_at(&axis, 2.5), 75.0, 1e-12);
    axis = pp_axis_linear(0.0, 7.2, 10.0, 82.0, 9.0, false);
    assert_near(axis.high, 7.2, 0.0);
    assert_near(axis.ticks[axis.tick_count - 1], 7.0, 1e-12);
    axis = pp_axis_log(0.034, 18.0, 0.0, 120.0, 7.0);
    assert_near(axis.low, 0.02, 1e-12);
    assert_near(axis.high, 20.0, 1e-9);
    char label[32];
    pp_axis_label(&axis, 1, label, sizeof label);
    assert_string_equal(label, "0.05");
}

static void per_cent_have_the_digits_that_their_size_calls_for(void **state)
{
    (void)state;
    static const struct {
        double fraction;
        const char *text;
    } rows[] = {{0.484, "48"},     {0.0996, "10"}, {0.0213, "2.1"},
                {0.00346, "0.35"}, {0.0, "0.00"},  {0.000012, "0.0012"},
                {-0.0213, "-2.1"}};
    for (int i = 0; i < 7; i++) {
        char text[32], expected[32];
        pp_style_percent(text, sizeof text, rows[i].fraction);
        snprintf(expected, sizeof expected, "%s\xc2\xa0%%", rows[i].text);
        assert_string_equal(text, expected);
    }
}

static void every_kind_of_chart_has_a_name_and_a_summary(void **state)
{
    (void)state;
    const struct pp_chart_kind *kind;
    for (int i = 0; (kind = pp_chart_kind_at(i)) != NULL; i++) {
        assert_ptr_equal(pp_chart_kind_find(kind->name), kind);
        assert_true(strlen(kind->summary) > 10);
        assert_true(kind->summary[strlen(kind->summary) - 1] != '.');
    }
    assert_non_null(pp_chart_kind_find("section"));
    assert_null(pp_chart_kind_find("pie"));
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_section_names_room_sky_methods_scale_and_notes),
        cmocka_unit_test(the_same_chart_is_the_same_bytes),
        cmocka_unit_test(
            points_that_do_not_lie_on_a_line_are_refused_with_the_one_that_strays),
        cmocka_unit_test(a_slanting_line_is_a_line_too),
        cmocka_unit_test(one_point_is_drawn),
        cmocka_unit_test(missing_values_have_a_reason),
        cmocka_unit_test(a_report_without_values_has_a_note_on_the_chart),
        cmocka_unit_test(zeros_infinities_and_extremes_are_drawn_without_a_fault),
        cmocka_unit_test(dozens_of_methods_get_a_legend),
        cmocka_unit_test(a_plan_is_to_the_scale_that_it_states),
        cmocka_unit_test(a_plan_without_contours_has_a_note),
        cmocka_unit_test(small_rooms_and_halls_find_a_usual_scale),
        cmocka_unit_test(ticks_are_round_and_cover_the_values),
        cmocka_unit_test(per_cent_have_the_digits_that_their_size_calls_for),
        cmocka_unit_test(every_kind_of_chart_has_a_name_and_a_summary),
    };
    add_tests(tests, NULL, NULL);
}
