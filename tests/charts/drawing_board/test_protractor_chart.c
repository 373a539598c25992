/* test_protractor_chart.c - every mark of a protractor's scales is where its formula
 * requires, to 0.1 mm on paper; from the paths of the SVG. */
#include <stdio.h>
#include <stdlib.h>

#include "charts/drawing_board/protractor_chart.h"
#include "charts/drawing_board/protractor_disc.h"
#include "charts/drawing_board/protractor_worked.h"
#include "charts/sheet/page.h"
#include "methods/protractor/protractor_sheet_fill.h"

#include "tests/lib/near.h"
#include "tests/lib/room_of.h"
#include "tests/lib/sized.h"

static struct pp_canvas *canvas_of(enum pp_chart_format format, enum pp_paper paper)
{
    struct pp_canvas *canvas;
    const struct pp_sheet sheet = {.format = format, .paper = paper, .title = "test"};
    assert_int_equal(pp_canvas_create(&canvas, &sheet, NULL), PP_OK);
    return canvas;
}

static struct pp_mark_spacing spacing_of(const struct pp_canvas *canvas, bool worked)
{
    double arc = pp_protractor_chart_arc_mm(canvas, worked);
    return (struct pp_mark_spacing){0.75 / arc, 5.0 / arc};
}

/* Straight lines of the drawing, mm, from the text of an SVG. */
struct line {
    double from[2], to[2];
};

/* Reads "x y". */
static bool read_pair(const char *from, double xy[2])
{
    char *middle, *end;
    xy[0] = strtod(from, &middle);
    xy[1] = strtod(middle, &end);
    return middle != from && end != middle;
}

static struct line *lines_of(const char *svg, int *count)
{
    struct line *lines = malloc(20000 * sizeof *lines);
    *count = 0;
    for (const char *path = svg; (path = strchr(path, '<'));) {
        static const char begins[] = "<path style=\"fill:none";
        const char *end = strchr(path, '>');
        if (strncmp(path, begins, sizeof begins - 1) != 0) {
            path++;
            continue;
        }
        const char *data = memmem(path, (size_t)(end - path), " d=\"", 4);
        double at[2] = {0.0, 0.0};
        assert_non_null(data);
        for (const char *c = data + 4; c < end && *c != '"'; c++) {
            double xy[2];
            if (*c != 'M' && *c != 'L')
                continue;
            assert_true(read_pair(c + 1, xy));
            if (*c == 'L' && *count < 20000) {
                memcpy(lines[*count].from, at, sizeof at);
                memcpy(lines[(*count)++].to, xy, sizeof xy);
            }
            memcpy(at, xy, sizeof xy);
        }
        path = end;
    }
    return lines;
}

/* Distance on paper between the mark at this altitude and the position where the scale
 * has the nearest tenth of a per cent; by quadrature. */
static double off_mm(const struct pp_protractor *protractor, double angle, double arc)
{
    double share = pp_protractor_scale_primary(protractor, angle);
    double nearest = rint(1e3 * share) / 1e3;
    return fabs(share - nearest) / pp_protractor_scale_primary_slope(protractor, angle)
           * arc;
}

static void marks_stand_where_the_formula_puts_them(void **state)
{
    (void)state;
    for (int number = 1; number <= 10; number += PP_SIZED(1, 3, 3)) {
        struct pp_canvas *canvas = canvas_of(PP_CHART_SVG, PP_PAPER_A4);
        struct pp_style style = pp_page_style(canvas);
        struct pp_protractor protractor;
        struct pp_protractor_sheet sheet;
        pp_protractor_scale_published(&protractor, number, NULL);
        assert_int_equal(pp_protractor_sheet_fill_blank(&sheet, &protractor, "glass",
                                                        spacing_of(canvas, false),
                                                        NULL),
                         PP_OK);
        assert_int_equal(pp_protractor_chart_draw(canvas, &sheet, NULL), PP_OK);
        double radius = pp_protractor_chart_radius_mm(canvas);
        double arc = pp_protractor_disc_arc(&style, radius);
        const unsigned char *bytes;
        size_t length;
        assert_int_equal(pp_canvas_finish(canvas, &bytes, &length, NULL), PP_OK);
        char *svg = strndup((const char *)bytes, length);
        int count;
        struct line *lines = lines_of(svg, &count);

        /* Base: the only horizontal line from the centre with the length of the
         * radius. */
        double centre[2] = {NAN, NAN};
        for (int i = 0; i < count; i++)
            if (fabs(lines[i].from[0] - lines[i].to[0] - radius) < 0.01
                && fabs(lines[i].from[1] - lines[i].to[1]) < 0.001)
                memcpy(centre, lines[i].from, sizeof centre);
        assert_near(centre[0], 105.0, 0.01);

        int marks = 0;
        double worst = 0.0;
        for (int i = 0; i < count; i++) {
            double x = lines[i].from[0] - centre[0], y = centre[1] - lines[i].from[1];
            double to = hypot(lines[i].to[0] - centre[0], lines[i].to[1] - centre[1]);
            bool is_mark = fabs(hypot(x, y) - arc) < 0.01 && y > -0.05 && to < arc - 1.0
                           && to > arc - 3.0;
            if (!is_mark)
                continue;
            marks++;
            double angle = atan2(y, -x);
            if (sheet.scale.range_rad < PP_PI / 2.0 + 1e-6 && angle > PP_PI / 2.0)
                angle = PP_PI - angle;
            worst = fmax(worst, off_mm(&protractor, angle, arc));
        }
        bool twice = sheet.scale.range_rad < PP_PI / 2.0 + 1e-6;
        assert_int_equal(marks, (1 + twice) * sheet.scale.mark_count);
        assert_true(sheet.scale.mark_count > 60);
        assert_near(worst, 0.0, 0.1);
        free(lines);
        free(svg);
        pp_protractor_sheet_clear(&sheet);
        pp_canvas_destroy(canvas);
    }
}

/* Points on the lines of correction factors, compared with quadrature. */
static void lines_of_factors_stand_where_the_formula_puts_them(void **state)
{
    (void)state;
    struct pp_mark_spacing spacing = {0.01, 0.06};
    for (int number = 1; number <= 10; number += PP_SIZED(1, 3, 3)) {
        struct pp_protractor protractor;
        struct pp_protractor_sheet sheet;
        pp_protractor_scale_published(&protractor, number, NULL);
        assert_int_equal(
            pp_protractor_sheet_fill_blank(&sheet, &protractor, "glass", spacing, NULL),
            PP_OK);
        const struct pp_protractor_scale *scale = &sheet.scale;
        assert_int_equal(scale->line_count, 24);
        for (int i = 3; i < scale->line_count; i += 5)
            for (int k = 4; k < scale->lines[i].count - 4; k += 3) {
                double average = k * PP_PROTRACTOR_LINE_STEP_RAD;
                double theta =
                    scale->turned_down
                        ? scale->lines[i].jamb_rad[k]
                        : pp_protractor_scale_theta(
                            cos(average), pp_angle_of(scale->lines[i].jamb_rad[k]));
                assert_near(pp_protractor_scale_auxiliary(&protractor, average, theta),
                            0.02 * (i + 1), 1e-6);
            }
        pp_protractor_sheet_clear(&sheet);
    }
}

static void any_glass_slope_and_even_sky_has_a_protractor(void **state)
{
    (void)state;
    struct pp_mark_spacing spacing = {0.01, 0.06};
    struct pp_protractor_sheet sheet;
    struct pp_protractor protractor = {.sky = pp_sky_overcast(),
                                       .glass = pp_glass_panes(2, 1.52, 0.02),
                                       .slope_rad = 45.0 * PP_RAD};
    assert_int_equal(pp_sky_iso(&protractor.sky, 3, pp_vec(0, 0, 1), NULL), PP_OK);
    bool azimuth = pp_sky_has_azimuth(&protractor.sky);
    struct pp_error err;
    enum pp_status status =
        pp_protractor_sheet_fill_blank(&sheet, &protractor, "x", spacing, &err);
    assert_int_equal(status, azimuth ? PP_BAD_INPUT : PP_OK);
    assert_int_equal(sheet.scale.number, 0);
    assert_near(sheet.scale.range_rad, 135.0 * PP_RAD, 1e-12);
    pp_protractor_sheet_clear(&sheet);
    protractor.glass = pp_glass_diffusing(0.5);
    assert_int_equal(
        pp_protractor_sheet_fill_blank(&sheet, &protractor, "x", spacing, &err),
        PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "diffusing"));
    assert_int_equal(pp_sky_iso(&protractor.sky, 12, pp_vec(0, 0.6, 0.8), NULL), PP_OK);
    protractor.glass = pp_glass_clear_single();
    assert_int_equal(
        pp_protractor_sheet_fill_blank(&sheet, &protractor, "x", spacing, &err),
        PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "azimuth"));
}

/* A side-lit and a top-lit room in all formats and paper sizes, or a few of them below
 * full size. Each has the published protractor for the slope of its glass. */
static void a_worked_chart_is_drawn_of_windows_and_rooflights(void **state)
{
    (void)state;
    static const char *const rooms[] = {
        "<room version=\"1\"><plan width=\"4\" depth=\"6\" height=\"3\"/>"
        "<window wall=\"south\" left=\"1\" sill=\"0.9\" width=\"2\" height=\"1.5\"/>"
        "<skyline wall=\"south\" angle=\"15\"/><point x=\"1.7\" y=\"2.2\"/></room>",
        "<room version=\"1\"><plan width=\"5\" depth=\"5\" height=\"3\"/>"
        "<rooflight x=\"1\" y=\"1\" width=\"1.1\" depth=\"2.7\"/>"
        "<point x=\"2.3\" y=\"3.1\"/></room>"};
    for (int r = 0; r < 2; r++)
        for (int i = 0; i < 12; i += PP_SIZED(1, 5, 5)) {
            struct pp_outside_light light;
            struct pp_world *world = pp_test_lit_world(&light, rooms[r]);
            struct pp_canvas *canvas = canvas_of(i % 3, i / 3);
            struct pp_protractor_sheet sheet;
            assert_int_equal(
                pp_protractor_sheet_fill_room(&sheet, world, &light, world->receivers,
                                              spacing_of(canvas, true), NULL),
                PP_OK);
            assert_true(sheet.read.sky > 0.005);
            assert_int_equal(sheet.scale.number, r ? 4 : 2);
            assert_int_equal(pp_protractor_worked_draw(canvas, &sheet, NULL), PP_OK);
            const unsigned char *bytes;
            size_t length;
            assert_int_equal(pp_canvas_finish(canvas, &bytes, &length, NULL), PP_OK);
            assert_true(length > 5000);
            pp_protractor_sheet_clear(&sheet);
            pp_canvas_destroy(canvas);
            pp_world_destroy(world);
        }
}

static void a_point_that_sees_no_opening_has_no_worked_chart(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version=\"1\"><plan width=\"4\" depth=\"6\" height=\"3\"/>"
        "<window wall=\"south\" left=\"1\" sill=\"0.1\" width=\"2\" height=\"0.5\"/>"
        "<point x=\"1.7\" y=\"2.2\"/></room>");
    struct pp_protractor_sheet sheet;
    struct pp_error err;
    struct pp_mark_spacing spacing = {0.01, 0.06};
    assert_int_equal(pp_protractor_sheet_fill_room(&sheet, world, &light,
                                                   world->receivers, spacing, &err),
                     PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "no part of any opening is visible"));
    pp_protractor_sheet_clear(&sheet);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(marks_stand_where_the_formula_puts_them),
        cmocka_unit_test(lines_of_factors_stand_where_the_formula_puts_them),
        cmocka_unit_test(any_glass_slope_and_even_sky_has_a_protractor),
        cmocka_unit_test(a_worked_chart_is_drawn_of_windows_and_rooflights),
        cmocka_unit_test(a_point_that_sees_no_opening_has_no_worked_chart),
    };
    add_tests(tests, NULL, NULL);
}
