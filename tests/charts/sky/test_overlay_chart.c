/* test_overlay_chart.c - elements of an overlay are where the lens projects them, to a
 * tenth of a millimetre. */
#include "charts/sky/overlay_chart.h"

#include <string.h>

#include "tests/lib/strokes.h"

#define PAPER_MM 0.02

enum { DOTS = 1000 };

/* Projections of the lenses by the angle from the zenith in degrees; R = 1. */
static double radius_of(enum pp_lens lens, double angle)
{
    double t = angle * PP_RAD;
    switch (lens) {
    case PP_LENS_EQUISOLID: /* areas proportional to solid angles: 1 - cos */
        return sqrt(1.0 - cos(t));
    case PP_LENS_STEREOGRAPHIC: /* tan(t/2) from sine and cosine */
        return sin(t) / (1.0 + cos(t));
    case PP_LENS_ORTHOGRAPHIC:
        return sqrt(1.0 - cos(t) * cos(t));
    default:
        return angle / 90.0;
    }
}

static struct strokes drawn(const struct pp_overlay *overlay, enum pp_paper paper)
{
    const struct pp_sheet on = {
        .format = PP_CHART_SVG, .paper = paper, .title = "Overlay"};
    struct pp_canvas *canvas;
    const unsigned char *bytes;
    size_t length;
    assert_int_equal(pp_canvas_create(&canvas, &on, NULL), PP_OK);
    assert_int_equal(pp_overlay_chart_draw(canvas, overlay, NULL), PP_OK);
    assert_int_equal(pp_canvas_finish(canvas, &bytes, &length, NULL), PP_OK);
    char *svg = strndup((const char *)bytes, length);
    struct strokes strokes = strokes_of(svg);
    free(svg);
    pp_canvas_destroy(canvas);
    return strokes;
}

/* Centre: midway between the ticks of north and south, vertical strokes that begin on
 * the circle and go outwards. */
static void find_middle(const struct strokes *strokes, double radius, double middle[2])
{
    for (int i = 0; i < strokes->count; i++) {
        const struct stroke *s = &strokes->list[i];
        bool upright = fabs(s->x1 - s->x0) < 1e-6 && fabs(s->y1 - s->y0) > 0.5;
        for (int k = 0; upright && k < strokes->count; k++) {
            const struct stroke *t = &strokes->list[k];
            if (fabs(t->x0 - s->x0) < 1e-6 && fabs(t->x1 - s->x1) < 1e-6
                && fabs(t->y0 - s->y0 - 2.0 * radius) < PAPER_MM && t->y1 > t->y0
                && s->y1 < s->y0) {
                middle[0] = s->x0;
                middle[1] = 0.5 * (s->y0 + t->y0);
                return;
            }
        }
    }
    fail_msg("there is no middle");
}

/* Centres of the crosses. Each is drawn on a white cross, so every other pair
 * counts. */
static int find_crosses(const struct strokes *strokes, double (*xy)[2], int most)
{
    int count = 0;
    for (int i = 0; i + 1 < strokes->count && count < most; i++) {
        const struct stroke *s = &strokes->list[i], *t = s + 1;
        double x = 0.5 * (s->x0 + s->x1), y = 0.5 * (s->y0 + s->y1);
        bool cross = fabs(s->x0 - t->x0) < PAPER_MM && fabs(s->x1 - t->x1) < PAPER_MM
                     && fabs(s->y0 - t->y1) < PAPER_MM && fabs(s->y1 - t->y0) < PAPER_MM
                     && fabs(fabs(s->x1 - s->x0) - fabs(s->y1 - s->y0)) < PAPER_MM
                     && fabs(s->x1 - s->x0) > 0.2 && fabs(s->x1 - s->x0) < 3.0;
        if (!cross
            || (count && fabs(xy[count - 1][0] - x) < PAPER_MM
                && fabs(xy[count - 1][1] - y) < PAPER_MM))
            continue;
        xy[count][0] = x;
        xy[count++][1] = y;
    }
    return count;
}

static void dots_stand_where_the_lens_draws_their_directions(void **state)
{
    (void)state;
    static const enum pp_paper papers[PP_LENS_COUNT] = {PP_PAPER_A4, PP_PAPER_A5,
                                                        PP_PAPER_A3, PP_PAPER_A2};
    struct pp_sky sky = pp_sky_overcast();
    struct pp_sky_cell *dots;
    static double xy[2 * DOTS][2];
    assert_int_equal(pp_sky_cells(&dots, &sky, DOTS, NULL), PP_OK);
    for (int lens = 0; lens < PP_LENS_COUNT; lens++) {
        double middle[2], radius = 47.5;
        const struct pp_overlay overlay = {.lens = (enum pp_lens)lens,
                                           .diameter_mm = 2.0 * radius,
                                           .sky = sky,
                                           .dots = dots,
                                           .dot_count = DOTS};
        struct strokes strokes = drawn(&overlay, papers[lens]);
        find_middle(&strokes, radius, middle);
        assert_int_equal(find_crosses(&strokes, xy, 2 * DOTS), DOTS);
        int high = 0;
        for (int i = 0; i < DOTS; i++) {
            double r = radius * radius_of(lens, 90.0 - dots[i].altitude / PP_RAD);
            /* North is up, east on the left. */
            assert_near(xy[i][0], middle[0] - r * sin(dots[i].bearing), 0.05);
            assert_near(xy[i][1], middle[1] - r * cos(dots[i].bearing), 0.05);
            high += hypot(xy[i][0] - middle[0], xy[i][1] - middle[1])
                    < radius * radius_of(lens, 60.0);
        }
        /* Above 30 degrees there are (3 (1 - 1/4) + 4 (1 - 1/8))/7 of the light. Whole
         * rings have an error of half a ring, out of about 75 dots each. */
        assert_near(high, 821.4, 38.0);
        free(strokes.list);
    }
    free(dots);
}

static bool has_end(const struct strokes *strokes, double x, double y, double within)
{
    for (int i = 0; i < strokes->count; i++)
        if (hypot(strokes->list[i].x1 - x, strokes->list[i].y1 - y) < within)
            return true;
    return false;
}

/* At noon the sun is 51.5 degrees less its declination from the zenith, in the south;
 * at the equinox it rises due east, on the left. */
static void sun_paths_pass_through_known_directions(void **state)
{
    (void)state;
    static const double declinations[] = {23.44, 0.0, -23.44};
    for (int lens = 0; lens < PP_LENS_COUNT; lens++) {
        double middle[2], radius = 75.0;
        const struct pp_overlay overlay = {.lens = (enum pp_lens)lens,
                                           .diameter_mm = 2.0 * radius,
                                           .sky = pp_sky_overcast(),
                                           .sun = true,
                                           .latitude_rad = 51.5 * PP_RAD};
        struct strokes strokes = drawn(&overlay, PP_PAPER_A4);
        find_middle(&strokes, radius, middle);
        for (int i = 0; i < 3; i++) {
            double r = radius * radius_of(lens, 51.5 - declinations[i]);
            /* A declination of 0.4 degrees on 21 March. */
            assert_true(
                has_end(&strokes, middle[0], middle[1] + r, i == 1 ? 0.7 : 0.1));
        }
        assert_true(has_end(&strokes, middle[0] - radius, middle[1], 1.2));
        free(strokes.list);
    }
}

static void a_circle_larger_than_the_sheet_is_refused(void **state)
{
    (void)state;
    const struct pp_sheet on = {.format = PP_CHART_SVG, .paper = PP_PAPER_A5};
    const struct pp_overlay overlay = {.diameter_mm = 180.0, .sky = pp_sky_overcast()};
    struct pp_canvas *canvas;
    struct pp_error err = {0};
    assert_int_equal(pp_canvas_create(&canvas, &on, NULL), PP_OK);
    assert_int_equal(pp_overlay_chart_draw(canvas, &overlay, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "--paper"));
    pp_canvas_destroy(canvas);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(dots_stand_where_the_lens_draws_their_directions),
        cmocka_unit_test(sun_paths_pass_through_known_directions),
        cmocka_unit_test(a_circle_larger_than_the_sheet_is_refused),
    };
    add_tests(tests, NULL, NULL);
}
