/* test_drawn_covers.c - doors and dados in plans and sections of a room: their
 * positions, to scale; plans show no dado. */
#include "charts/room/room_plan.h"
#include "charts/section/room_section.h"
#include "charts/sheet/canvas.h"
#include "charts/sheet/page.h"
#include "tests/lib/room_of.h"
#include "tests/lib/strokes.h"

static const char room[] =
    "<room version='1'><plan width='4.23' depth='5.41' height='2.87'/>"
    "<window wall='south' left='0.37' sill='0.93' width='1.31' height='1.57'/>%s"
    "<point x='2.9' y='2.1'/></room>";
static const char covers[] =
    "<facade wall='south' up='1' depth='0.33'/>"
    "<door wall='south' left='2.2' width='0.97' height='2.03'/>"
    "<dado wall='north' height='0.71' reflectance='0.25'/>";

enum what { PLAN, SECTION };

/* Strokes of a drawing; the caller frees them. *mm_per_m is its scale; x0 and y0 are
 * the position on paper of the south-west corner, or of the floor at the south wall. */
static struct strokes drawn(enum what what, const char *parts, double *mm_per_m,
                            double *x0, double *y0)
{
    char text[2048];
    struct pp_outside_light light;
    const struct pp_sheet on = {.format = PP_CHART_SVG, .paper = PP_PAPER_A4};
    struct pp_canvas *canvas;
    const unsigned char *bytes;
    size_t length;
    snprintf(text, sizeof text, room, parts);
    struct pp_world *world = pp_test_lit_world(&light, text);
    assert_int_equal(pp_canvas_create(&canvas, &on, NULL), PP_OK);
    struct pp_style style = pp_page_style(canvas);
    cairo_t *cr = pp_canvas_cairo(canvas);
    if (what == PLAN) {
        struct pp_room_plan plan = {.x = 40.0, .y = 200.0};
        pp_room_plan_fit(&plan, world, &style, 120.0, 150.0);
        pp_room_plan_draw(cr, &style, &plan);
        *mm_per_m = plan.mm_per_m;
        *x0 = pp_plan_frame_x(&plan, 0.0);
        *y0 = pp_plan_frame_y(&plan, 0.0);
    } else {
        struct pp_section_cut cut;
        struct pp_report report = {
            .world = world, .receivers = world->receivers, .receiver_count = 1};
        assert_int_equal(pp_section_cut_init(&cut, world, world->receivers, 1, NULL),
                         PP_OK);
        struct pp_room_section section = {.world = world,
                                          .cut = &cut,
                                          .report = &report,
                                          .x = 60.0,
                                          .y = 60.0,
                                          .left_mm = 20.0,
                                          .right_mm = 20.0};
        pp_room_section_fit(&section, &style, 120.0, 90.0);
        pp_room_section_draw(cr, &style, &section);
        *mm_per_m = section.mm_per_m;
        *x0 = pp_section_frame_x(&section, 0.0);
        *y0 = pp_section_frame_y(&section, 0.0);
        pp_section_cut_clear(&cut);
    }
    assert_int_equal(pp_canvas_finish(canvas, &bytes, &length, NULL), PP_OK);
    char *svg = strndup((const char *)bytes, length);
    struct strokes strokes = strokes_of(svg);
    free(svg);
    pp_canvas_destroy(canvas);
    pp_world_destroy(world);
    return strokes;
}

/* True if there is a stroke from low to high on paper, less than `near` mm from x. */
static bool upright(const struct strokes *strokes, double x, double low, double high,
                    double near)
{
    for (int i = 0; i < strokes->count; i++) {
        const struct stroke *s = &strokes->list[i];
        if (fabs(s->x0 - x) < near && fabs(s->x1 - x) < near
            && fabs(fmin(s->y0, s->y1) - low) < 0.05
            && fabs(fmax(s->y0, s->y1) - high) < 0.05)
            return true;
    }
    return false;
}

/* The jambs of the door extend from the inner face of the wall to the façade, 0.33 m
 * outside. `left` is measured from the west, since the south wall is seen from
 * outside. */
static void a_door_opens_its_wall_in_a_plan(void **state)
{
    (void)state;
    double mm, x0, y0;
    struct strokes with = drawn(PLAN, covers, &mm, &x0, &y0);
    assert_true(upright(&with, x0 + mm * 2.2, y0, y0 + mm * 0.33, 0.05));
    assert_true(upright(&with, x0 + mm * (2.2 + 0.97), y0, y0 + mm * 0.33, 0.05));
    free(with.list);
    struct strokes without =
        drawn(PLAN, "<facade wall='south' up='1' depth='0.33'/>", &mm, &x0, &y0);
    assert_false(upright(&without, x0 + mm * 2.2, y0, y0 + mm * 0.33, 0.05));
    free(without.list);
}

static void a_dado_is_not_in_a_plan(void **state)
{
    (void)state;
    double mm, x0, y0;
    struct strokes with =
        drawn(PLAN, "<dado height='0.71' reflectance='0.25'/>", &mm, &x0, &y0);
    struct strokes without = drawn(PLAN, "", &mm, &x0, &y0);
    assert_int_equal(with.count, without.count);
    free(with.list);
    free(without.list);
}

/* The section at x = 2.9 cuts the door at s = 0 and the dado at s = 5.41: each has
 * vertical lines from the floor to its height, close to the wall. */
static void a_section_cuts_a_door_and_a_dado(void **state)
{
    (void)state;
    double mm, x0, y0;
    struct strokes with = drawn(SECTION, covers, &mm, &x0, &y0);
    assert_true(upright(&with, x0, y0 - mm * 2.03, y0, 0.5));
    assert_true(upright(&with, x0 + mm * 5.41, y0 - mm * 0.71, y0, 1.5));
    free(with.list);
    struct strokes without = drawn(SECTION, "", &mm, &x0, &y0);
    assert_false(upright(&without, x0, y0 - mm * 2.03, y0, 0.5));
    assert_false(upright(&without, x0 + mm * 5.41, y0 - mm * 0.71, y0, 1.5));
    free(without.list);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_door_opens_its_wall_in_a_plan),
        cmocka_unit_test(a_dado_is_not_in_a_plan),
        cmocka_unit_test(a_section_cuts_a_door_and_a_dado),
    };
    add_tests(tests, NULL, NULL);
}
