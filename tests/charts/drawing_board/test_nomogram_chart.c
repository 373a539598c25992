/* test_nomogram_chart.c - every mark of a nomogram is where its formula requires, to
 * 0.1 mm on paper, and a straight-edge on the printed marks gives the result of the
 * formula to 0.5 %; from the lines of the PDF. */
#include <stdio.h>
#include <stdlib.h>

#include <zlib.h>

#include "charts/drawing_board/nomogram_chart.h"
#include "methods/nomogram/nomogram_scale.h"
#include "methods/nomogram/nomogram_sheet_fill.h"
#include "methods/reflected/obstruction.h"
#include "methods/evaluate.h"
#include "model/geometry/vec.h"

#include "tests/lib/near.h"
#include "tests/lib/room_of.h"

/* A straight line of the drawing, mm, y down from the upper edge. */
struct line {
    double from[2], to[2];
};

struct drawing {
    int count;
    struct line list[6000];
};

/* First stream of a PDF, inflated. */
static char *first_stream(const unsigned char *bytes, size_t length)
{
    const unsigned char *from = memmem(bytes, length, "stream\n", 7);
    assert_non_null(from);
    from += 7;
    size_t room = 4 << 20;
    char *text = calloc(1, room);
    uLongf taken = (uLongf)room - 1;
    z_stream z = {.next_in = (unsigned char *)(uintptr_t)from,
                  .avail_in = (unsigned)(bytes + length - from),
                  .next_out = (unsigned char *)text,
                  .avail_out = (unsigned)taken};
    assert_int_equal(inflateInit(&z), Z_OK);
    assert_int_equal(inflate(&z, Z_FINISH), Z_STREAM_END);
    inflateEnd(&z);
    return text;
}

/* Lines of a PDF page drawn by cairo: a matrix reverses y, then m and l. */
static struct drawing *lines_of(const struct pp_nomogram_sheet *sheet,
                                enum pp_paper paper)
{
    struct pp_canvas *canvas;
    const struct pp_sheet page = {
        .format = PP_CHART_PDF, .paper = paper, .title = "test"};
    assert_int_equal(pp_canvas_create(&canvas, &page, NULL), PP_OK);
    double height = pp_canvas_height_mm(canvas);
    assert_int_equal(pp_nomogram_chart_draw(canvas, sheet, NULL), PP_OK);
    const unsigned char *bytes;
    size_t length;
    assert_int_equal(pp_canvas_finish(canvas, &bytes, &length, NULL), PP_OK);
    char *text = first_stream(bytes, length);
    struct drawing *drawing = calloc(1, sizeof *drawing);
    double matrix[6] = {1, 0, 0, 1, 0, 0}, at[2] = {0, 0}, v[6] = {0};
    int count =
        0; /* number of numbers before an operator; line breaks may be anywhere */
    for (char *word = strtok(text, " \n"); word; word = strtok(NULL, " \n")) {
        char *end;
        double number = strtod(word, &end);
        if (*end == 0) {
            memmove(v, v + 1, sizeof v - sizeof *v);
            v[5] = number;
            count++;
            continue;
        }
        if (strcmp(word, "cm") == 0 && count == 6 && v[3] < 0.0)
            memcpy(matrix, v, sizeof matrix); /* matrix of the page */
        if ((strcmp(word, "m") == 0 || strcmp(word, "l") == 0) && count == 2) {
            double xy[2] = {(matrix[0] * v[4] + matrix[4]) * 25.4 / 72.0,
                            height - (matrix[3] * v[5] + matrix[5]) * 25.4 / 72.0};
            if (*word == 'l' && drawing->count < 6000) {
                memcpy(drawing->list[drawing->count].from, at, sizeof at);
                memcpy(drawing->list[drawing->count++].to, xy, sizeof xy);
            }
            memcpy(at, xy, sizeof xy);
        }
        count = 0;
    }
    free(text);
    pp_canvas_destroy(canvas);
    return drawing;
}

static struct pp_nomogram_spacing spacing_of(enum pp_paper paper)
{
    struct pp_canvas *canvas;
    const struct pp_sheet page = {.format = PP_CHART_PDF, .paper = paper};
    assert_int_equal(pp_canvas_create(&canvas, &page, NULL), PP_OK);
    struct pp_nomogram_spacing spacing = {
        pp_nomogram_chart_height_mm(canvas), pp_canvas_width_mm(canvas),
        pp_nomogram_chart_fine_mm(canvas), pp_nomogram_chart_number_mm(canvas)};
    pp_canvas_destroy(canvas);
    return spacing;
}

static bool level(const struct line *line)
{
    return fabs(line->from[1] - line->to[1]) < 1e-3;
}

/* The frame of the scales: x of A and of the last stem, y of the ends of A. */
struct frame {
    double left, right, top, bottom;
};

/* Scale A is the vertical line farthest to the left. */
static struct frame frame_of(const struct drawing *drawing)
{
    struct frame frame = {INFINITY, -INFINITY, 0.0, 0.0};
    for (int i = 0; i < drawing->count; i++) {
        const struct line *line = &drawing->list[i];
        if (fabs(line->from[0] - line->to[0]) > 1e-3
            || fabs(line->from[1] - line->to[1]) < 5.0)
            continue;
        frame.right = fmax(frame.right, line->from[0]);
        if (line->from[0] < frame.left) {
            frame.left = line->from[0];
            frame.top = fmin(line->from[1], line->to[1]);
            frame.bottom = fmax(line->from[1], line->to[1]);
        }
    }
    return frame;
}

/* The functions of the formula, written independently. */
static double function_of(enum pp_nomogram_quantity quantity, double number)
{
    double k = PP_NOMOGRAM_K, b = number * PP_RAD;
    static const double f[] = {1.8, 1.4, 1.3, 1.2};
    int i = (int)fmin(fmax((number - 0.2) / 0.2 + 1e-9, 0.0), 2.0);
    switch (quantity) {
    case PP_NOMOGRAM_GLASS:
        return number;
    case PP_NOMOGRAM_REFLECTANCE:
        return number / (1.0 - number);
    case PP_NOMOGRAM_COMPONENT:
    case PP_NOMOGRAM_LIGHT:
        return number / 100.0;
    case PP_NOMOGRAM_LOSS:
        return 1.0 / (1.0 - number);
    case PP_NOMOGRAM_GAIN:
    case PP_NOMOGRAM_FACTOR:
        return number;
    case PP_NOMOGRAM_PLACE:
        return pow(10.0, number);
    case PP_NOMOGRAM_OBSTRUCTION:
        return (100.0 * pp_obstruction_factor(b) + 5.0 * k) / (39.0 + 5.0 * k);
    case PP_NOMOGRAM_SLOPE:
        return 3.0 / 14.0 * (1.0 + cos(b))
               + 4.0 / (7.0 * PP_PI) * (sin(b) + (PP_PI - b) * cos(b))
               + 0.05 * k * (1.0 - cos(b));
    case PP_NOMOGRAM_WALLS:
        return 1.0 / (f[i] + (number - 0.2 * (i + 1)) / 0.2 * (f[i + 1] - f[i]));
    }
    return NAN;
}

static void marks_stand_where_the_formula_puts_them(void **state)
{
    (void)state;
    static const enum pp_paper papers[] = {PP_PAPER_A5, PP_PAPER_A4, PP_PAPER_A2};
    for (int kind = 0; kind < PP_NOMOGRAMS; kind++)
        for (int p = 0; p < 3; p++) {
            struct pp_nomogram_sheet sheet;
            assert_int_equal(pp_nomogram_sheet_fill_blank(&sheet,
                                                          (enum pp_nomogram_kind)kind,
                                                          spacing_of(papers[p]), NULL),
                             PP_OK);
            struct drawing *drawing = lines_of(&sheet, papers[p]);
            struct frame frame = frame_of(drawing);
            double high = frame.bottom - frame.top, wide = frame.right - frame.left;
            double step = spacing_of(papers[p]).height_mm;
            assert_true(high > 0.8 * step && high < step + 0.01);
            for (int s = 0; s < sheet.nomogram.stem_count; s++) {
                const struct pp_nomogram_stem *stem = &sheet.nomogram.stems[s];
                const struct pp_nomogram_scale *scale = &sheet.scales[s];
                double x = frame.left + stem->x * wide;
                int found = 0;
                double worst = 0.0;
                for (int i = 0; i < drawing->count; i++) {
                    const struct line *line = &drawing->list[i];
                    if (!level(line) || fabs(line->from[0] - x) > 0.05
                        || fabs(line->to[0] - x) > 6.0 || fabs(line->to[0] - x) < 0.5)
                        continue;
                    /* In the order in which they were drawn. */
                    assert_true(found < scale->count);
                    double u =
                        function_of(stem->quantity, scale->marks[found++].number);
                    double y = stem->foot + stem->decade * log10(u);
                    worst = fmax(worst, fabs(frame.bottom - y * high - line->from[1]));
                }
                assert_int_equal(found, scale->count);
                assert_true(scale->count
                            > (stem->quantity == PP_NOMOGRAM_WALLS ? 5 : 25));
                assert_near(worst, 0.0, 0.1);
            }
            free(drawing);
            pp_nomogram_sheet_clear(&sheet);
        }
}

/* Position of the mark of this number on paper. */
static bool mark_at(const struct drawing *drawing, const struct frame *frame,
                    const struct pp_nomogram_sheet *sheet, int stem, double number,
                    double xy[2])
{
    const struct pp_nomogram_scale *scale = &sheet->scales[stem];
    int wanted = -1, found = 0;
    for (int i = 0; i < scale->count && wanted < 0; i++)
        if (fabs(scale->marks[i].number - number) < 1e-9)
            wanted = i;
    double x =
        frame->left + sheet->nomogram.stems[stem].x * (frame->right - frame->left);
    for (int i = 0; i < drawing->count && wanted >= 0; i++) {
        const struct line *line = &drawing->list[i];
        if (!level(line) || fabs(line->from[0] - x) > 0.05
            || fabs(line->to[0] - x) > 6.0 || fabs(line->to[0] - x) < 0.5)
            continue;
        if (found++ == wanted) {
            memcpy(xy, line->from, sizeof line->from);
            return true;
        }
    }
    return false;
}

/* Number on a scale of components at a height on paper, interpolated between marks in
 * the logarithm, as on the scale. */
static double number_at(const struct drawing *drawing, const struct frame *frame,
                        const struct pp_nomogram_sheet *sheet, int stem, double y)
{
    const struct pp_nomogram_scale *scale = &sheet->scales[stem];
    for (int i = 1; i < scale->count; i++) {
        double low[2], high[2];
        assert_true(
            mark_at(drawing, frame, sheet, stem, scale->marks[i - 1].number, low));
        assert_true(mark_at(drawing, frame, sheet, stem, scale->marks[i].number, high));
        if (y > low[1] || y < high[1])
            continue;
        double t = (low[1] - y) / (low[1] - high[1]);
        return scale->marks[i - 1].number
               * pow(scale->marks[i].number / scale->marks[i - 1].number, t);
    }
    fail_msg("no marks about y %g", y);
    return NAN;
}

/* Lines between marks of the printed sheet, intersected with the printed scale. */
static void straight_edge_on_the_printed_marks_gives_the_formula(void **state)
{
    (void)state;
    struct pp_nomogram_sheet sheet;
    assert_int_equal(pp_nomogram_sheet_fill_blank(&sheet, PP_NOMOGRAM_AVERAGE,
                                                  spacing_of(PP_PAPER_A4), NULL),
                     PP_OK);
    struct drawing *drawing = lines_of(&sheet, PP_PAPER_A4);
    struct frame frame = frame_of(drawing);
    static const double ratios[] = {0.006, 0.014, 0.05, 0.12}, Rs[] = {0.2, 0.45, 0.7},
                        alphas[] = {20.0, 30.0, 50.0};
    double k = PP_NOMOGRAM_K;
    for (int i = 0; i < 4 * 3 * 3; i++) {
        double ratio = ratios[i % 4], R = Rs[i / 4 % 3], alpha = alphas[i / 12];
        double a[2], b[2], d[2];
        assert_true(mark_at(drawing, &frame, &sheet, 0, ratio, a));
        assert_true(mark_at(drawing, &frame, &sheet, 1, R, b));
        assert_true(mark_at(drawing, &frame, &sheet, 3, alpha, d));
        double wide = frame.right - frame.left;
        double x_C = frame.left + wide * sheet.nomogram.stems[2].x;
        double x_E = frame.left + wide * sheet.nomogram.stems[4].x;
        double y_C = a[1] + (x_C - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
        double y_E = y_C + (x_E - x_C) / (d[0] - x_C) * (d[1] - y_C);
        double R_fw = 2.0 * R / (1.0 + k),
               C = 100.0 * pp_obstruction_factor(alpha * PP_RAD);
        double plain = 0.85 * ratio / (1.0 - R) * (39.0 * R_fw + 5.0 * k * R_fw);
        double with = 0.85 * ratio / (1.0 - R) * (C * R_fw + 5.0 * k * R_fw);
        assert_relative(number_at(drawing, &frame, &sheet, 2, y_C), plain, 0.005);
        assert_relative(number_at(drawing, &frame, &sheet, 4, y_E), with, 0.005);
    }
    free(drawing);
    pp_nomogram_sheet_clear(&sheet);
}

static const char corner_room[] =
    "<room version='1' name='corner'><plan width='6' depth='5' height='3'/>"
    "<finishes decorations='0.8'/><window wall='south' left='1' sill='0.9' width='2' "
    "height='1.5'/>"
    "<window wall='south' left='4' sill='0.9' width='0.3' height='0.4'/>"
    "<window wall='east' left='1' sill='0.9' width='1.1' height='1.5' "
    "glazing='clear-double' maintenance='0.8'/>"
    "<window wall='east' left='3' sill='0.9' width='1.1' height='1.5' "
    "glazing='clear-double' maintenance='0.8'/>"
    "<skyline wall='south' angle='27'/><point x='3' y='2'/></room>";

/* The notes below the chart have the results of `df`; equal windows share their
 * lines. */
static void sum_of_a_room_is_that_of_the_method(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, corner_room);
    struct pp_report report = {.world = world,
                               .light = light,
                               .receivers = world->receivers,
                               .receiver_count = world->receiver_count};
    assert_int_equal(pp_methods_evaluate(&report, "nomogram,bre-min", NULL), PP_OK);
    const struct pp_column *average = pp_report_find(&report, PP_IRC, "nomogram");
    const struct pp_column *least = pp_report_find(&report, PP_IRC, "bre-min");
    for (int kind = 0; kind < 2; kind++) {
        struct pp_nomogram_sheet sheet;
        assert_int_equal(
            pp_nomogram_sheet_fill_room(&sheet, (enum pp_nomogram_kind)kind, world,
                                        &light, NULL, spacing_of(PP_PAPER_A4), NULL),
            PP_OK);
        assert_int_equal(sheet.window_count, 3);
        assert_int_equal(sheet.windows[2].alike, 2);
        /* On nomogram II the scales are closer together, and E has coarser
         * divisions. */
        assert_relative(sheet.component, average->average.value, kind ? 0.02 : 1e-12);
        /* The rule and the reading together: 15 %. */
        if (kind)
            assert_relative(sheet.further, least->points[0].value, 0.15);
        else
            assert_true(isnan(sheet.further));
        pp_nomogram_sheet_clear(&sheet);
    }
    pp_report_clear(&report);
    pp_world_destroy(world);
}

static void rooms_that_a_nomogram_is_not_made_for(void **state)
{
    (void)state;
    static const struct {
        const char *xml, *why;
        enum pp_nomogram_kind kind;
    } cases[] = {
        {"<room version='1'><plan width='6' depth='5' height='3'/></room>",
         "no vertical window", PP_NOMOGRAM_AVERAGE},
        {corner_room, "no rooflight", PP_NOMOGRAM_ROOFLIGHT},
        {"<room version='1'><sky type='iso-5'/><plan width='6' depth='5' height='3'/>"
         "</room>",
         "overcast", PP_NOMOGRAM_MINIMUM},
    };
    for (int i = 0; i < 3; i++) {
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, cases[i].xml);
        struct pp_nomogram_sheet sheet;
        struct pp_error err = {0};
        assert_int_equal(pp_nomogram_sheet_fill_room(&sheet, cases[i].kind, world,
                                                     &light, NULL,
                                                     spacing_of(PP_PAPER_A4), &err),
                         PP_BAD_INPUT);
        assert_non_null(strstr(err.message, cases[i].why));
        pp_nomogram_sheet_clear(&sheet);
        pp_world_destroy(world);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(marks_stand_where_the_formula_puts_them),
        cmocka_unit_test(straight_edge_on_the_printed_marks_gives_the_formula),
        cmocka_unit_test(sum_of_a_room_is_that_of_the_method),
        cmocka_unit_test(rooms_that_a_nomogram_is_not_made_for),
    };
    add_tests(tests, NULL, NULL);
}
