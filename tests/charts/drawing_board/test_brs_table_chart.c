/* test_brs_table_chart.c - the printed BRS table: the positions of a window's readings,
 * and their result. */
#include <string.h>

#include "charts/drawing_board/brs_table_chart.h"

#include "methods/brs/brs_sheet_fill.h"
#include "methods/evaluate.h"
#include "tests/lib/box_room.h"
#include "tests/lib/room_of.h"
#include "tests/lib/strokes.h"

#define PAPER_MM 0.05

/* SVG of the sheet; the caller frees it. */
static char *drawn(const struct pp_brs_sheet *sheet, enum pp_paper paper)
{
    const struct pp_sheet on = {
        .format = PP_CHART_SVG, .paper = paper, .title = "Table"};
    struct pp_canvas *canvas;
    const unsigned char *bytes;
    size_t length;
    assert_int_equal(pp_canvas_create(&canvas, &on, NULL), PP_OK);
    assert_int_equal(pp_brs_table_chart_draw(canvas, sheet, NULL), PP_OK);
    assert_int_equal(pp_canvas_finish(canvas, &bytes, &length, NULL), PP_OK);
    char *copy = strndup((const char *)bytes, length);
    pp_canvas_destroy(canvas);
    return copy;
}

/* Outer frame of the table, from its tallest vertical strokes. */
static struct stroke frame_of(const struct strokes *strokes)
{
    struct stroke tallest = {0}, frame = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < strokes->count; i++) {
        const struct stroke *s = &strokes->list[i];
        if (fabs(s->x1 - s->x0) < 1e-6
            && fabs(s->y1 - s->y0) > fabs(tallest.y1 - tallest.y0))
            tallest = *s;
    }
    for (int i = 0; i < strokes->count; i++) {
        const struct stroke *s = &strokes->list[i];
        if (fabs(fabs(s->y1 - s->y0) - fabs(tallest.y1 - tallest.y0)) > PAPER_MM
            || fabs(s->x1 - s->x0) > 1e-6)
            continue;
        frame = (struct stroke){fmin(frame.x0, s->x0), fmin(s->y0, s->y1),
                                fmax(frame.x1, s->x0), fmax(s->y0, s->y1)};
    }
    return frame;
}

static bool has_cross(const struct strokes *strokes, double x, double y)
{
    int level = 0, upright = 0;
    for (int i = 0; i < strokes->count; i++) {
        const struct stroke *s = &strokes->list[i];
        double length = hypot(s->x1 - s->x0, s->y1 - s->y0);
        if (length > 4.0 || fabs(0.5 * (s->x0 + s->x1) - x) > PAPER_MM
            || fabs(0.5 * (s->y0 + s->y1) - y) > PAPER_MM)
            continue;
        level += fabs(s->y1 - s->y0) < 1e-6;
        upright += fabs(s->x1 - s->x0) < 1e-6;
    }
    return level == 1 && upright == 1;
}

/* h/d 2.5 is midway between 2.4 (the eighth row; infinity is the first) and 2.6, w/d
 * 1.3 midway between 1.2 (the eleventh column) and 1.4. The cross is at the common
 * corner of these four cells, eight cells down and twelve across, headers included. */
static void a_reading_is_marked_between_its_cells_in_proportion(void **state)
{
    (void)state;
    static const struct {
        enum pp_paper paper;
        double h, w, down, across; /* h/d, w/d; cells from the frame's corner */
    } rows[] = {
        {PP_PAPER_A5, 2.5, 1.3, 8.0, 12.0},   {PP_PAPER_A4, 2.5, 1.3, 8.0, 12.0},
        {PP_PAPER_A2, 0.37, 2.3, 26.8, 16.1}, /* 0.3 of a row below 0.4; 0.6 of a column */
        {PP_PAPER_A4, 0.05, 0.05, 30.0, 1.0}, /* half a cell beyond the last row and the first column */
        {PP_PAPER_A3, 10.0, 12.0, 2.0, 20.0}, /* by d/h: midway between 5 and infinity */
    };
    for (int i = 0; i < 5; i++) {
        double d = 0.6;
        struct box_room box;
        struct pp_receiver receiver = {pp_vec(10.0, d, 0.85), pp_vec(0.0, 0.0, 1.0), 0,
                                       0.0};
        struct pp_brs_sheet sheet;
        box_room_build(&box, 30.0, 3.0, 9.0, 0.2, 0.5, 0.7);
        box_room_south(&box, 10.0, 0.85, rows[i].w * d, rows[i].h * d);
        assert_int_equal(
            pp_brs_sheet_fill_room(&sheet, &box.world, &box.light, &receiver, NULL),
            PP_OK);
        assert_int_equal(sheet.reading_count, 1);
        char *svg = drawn(&sheet, rows[i].paper);
        struct strokes strokes = strokes_of(svg);
        struct stroke frame = frame_of(&strokes);
        double wide = (frame.x1 - frame.x0) / 21.0, high = (frame.y1 - frame.y0) / 30.0;
        assert_true(has_cross(&strokes, frame.x0 + rows[i].across * wide,
                              frame.y0 + rows[i].down * high));
        free(strokes.list);
        free(svg);
        pp_brs_sheet_clear(&sheet);
    }
}

static void the_readings_come_to_what_the_method_gives(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version=\"1\"><plan width=\"5.3\" depth=\"6.1\" height=\"2.9\"/>"
        "<window wall=\"south\" left=\"0.4\" sill=\"0.7\" width=\"1.9\" "
        "height=\"1.6\"/>"
        "<window wall=\"east\" left=\"1.1\" sill=\"1.1\" width=\"1.2\" height=\"1.4\" "
        "glazing=\"clear-double\" frame-factor=\"0.8\" maintenance=\"0.9\"/>"
        "<block x=\"-3\" y=\"-12\" width=\"9\" depth=\"4\" height=\"6\"/>"
        "<point x=\"2.3\" y=\"1.7\"/></room>");
    struct pp_brs_sheet sheet;
    struct pp_report report = {.world = world,
                               .light = light,
                               .receivers = world->receivers,
                               .receiver_count = 1};
    assert_int_equal(
        pp_brs_sheet_fill_room(&sheet, world, &light, world->receivers, NULL), PP_OK);
    assert_int_equal(pp_methods_evaluate(&report, "brs-table", NULL), PP_OK);
    double sum[2] = {0.0, 0.0};
    for (int i = 0; i < sheet.reading_count; i++) {
        const struct pp_brs_reading *reading = &sheet.readings[i];
        sum[reading->hidden] += reading->sign * reading->value * reading->factor
                                * sheet.windows[reading->window].allowance;
    }
    assert_true(sum[0] > 0.005 && sum[1] > 1e-4);
    assert_near(sum[0], pp_report_find(&report, PP_SC, "brs-table")->points[0].value,
                1e-14);
    assert_near(sum[1], pp_report_find(&report, PP_ERC, "brs-table")->points[0].value,
                1e-14);
    assert_near(sheet.sky_component, sum[0], 1e-14);
    assert_near(sheet.external, sum[1], 1e-14);
    pp_report_clear(&report);
    pp_brs_sheet_clear(&sheet);
    pp_world_destroy(world);
}

static void what_the_table_does_not_hold_is_refused(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version=\"1\"><plan width=\"5\" depth=\"6\" height=\"3\"/>"
                "<rooflight x=\"1\" y=\"1\" width=\"1\" depth=\"1\"/>"
                "<point x=\"2.3\" y=\"1.7\"/></room>");
    struct pp_brs_sheet sheet;
    struct pp_error err = {0};
    assert_int_equal(
        pp_brs_sheet_fill_room(&sheet, world, &light, world->receivers, &err),
        PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "vertical"));
    pp_world_destroy(world);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_reading_is_marked_between_its_cells_in_proportion),
        cmocka_unit_test(the_readings_come_to_what_the_method_gives),
        cmocka_unit_test(what_the_table_does_not_hold_is_refused),
    };
    add_tests(tests, NULL, NULL);
}
