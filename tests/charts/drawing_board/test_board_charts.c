/* test_board_charts.c - the printed diagrams of the drawing board: they show the
 * squares and dots that the methods count, at the positions of their scales. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "charts/drawing_board/board.h"
#include "charts/drawing_board/pepper_pot_chart.h"
#include "charts/drawing_board/skylight_indicator_chart.h"
#include "charts/drawing_board/waldram_chart.h"
#include "charts/room/exercise_chart.h"
#include "methods/evaluate.h"
#include "methods/pepper_pot/pepper_pot_dots.h"
#include "methods/pepper_pot/pepper_pot_sheet_fill.h"
#include "methods/waldram/skylight_indicator_fill.h"
#include "methods/waldram/waldram_sheet_fill.h"
#include "tests/lib/room_of.h"
#include "tests/lib/strokes.h"

/* cairo writes coordinates to 1/1000 of a point or finer; lines must be accurate to a
 * tenth of a millimetre. */
#define PAPER_MM 0.02

static const char two_sides[] =
    "<room version=\"1\" name=\"Two sides\">\n"
    "<plan width=\"5.3\" depth=\"6.1\" height=\"2.9\"/>\n"
    "<finishes floor=\"0.2\" walls=\"0.6\" ceiling=\"0.75\"/>\n"
    "<window wall=\"south\" left=\"0.4\" sill=\"0.7\" width=\"1.9\" height=\"1.6\"/>\n"
    "<window wall=\"south\" left=\"2.9\" sill=\"0.9\" width=\"1.7\" height=\"1.3\" "
    "glazing=\"clear-double\" frame-factor=\"0.8\" maintenance=\"0.9\"/>\n"
    "<window wall=\"east\" left=\"1.1\" sill=\"0.9\" width=\"1.2\" height=\"1.4\" "
    "glazing=\"none\"/>\n"
    "<block x=\"-3\" y=\"-12\" width=\"7\" depth=\"4\" height=\"6\"/>\n"
    "<point x=\"2.3\" y=\"1.7\"/>\n"
    "</room>\n";

static double value_of(const struct pp_world *world,
                       const struct pp_outside_light *light,
                       enum pp_component component, const char *method)
{
    struct pp_report report = {.world = world,
                               .light = *light,
                               .receivers = world->receivers,
                               .receiver_count = 1};
    struct pp_error err = {0};
    if (pp_methods_evaluate(&report, method, &err) != PP_OK)
        fail_msg("%s", err.message);
    double value = pp_report_find(&report, component, method)->points[0].value;
    pp_report_clear(&report);
    return value;
}

/* The file of a drawing; the caller frees it. */
static char *finished(struct pp_canvas *canvas, size_t *length)
{
    const unsigned char *bytes;
    struct pp_error err = {0};
    if (pp_canvas_finish(canvas, &bytes, length, &err) != PP_OK)
        fail_msg("%s", err.message);
    char *copy = malloc(*length + 1);
    assert_non_null(copy);
    memcpy(copy, bytes, *length);
    copy[*length] = '\0';
    pp_canvas_destroy(canvas);
    return copy;
}

static struct pp_canvas *canvas_of(enum pp_chart_format format, enum pp_paper paper,
                                   bool landscape)
{
    const struct pp_sheet sheet = {
        .format = format, .paper = paper, .landscape = landscape, .title = "Board"};
    struct pp_canvas *canvas;
    struct pp_error err = {0};
    if (pp_canvas_create(&canvas, &sheet, &err) != PP_OK)
        fail_msg("%s", err.message);
    return canvas;
}

static char *waldram_file(const struct pp_waldram_sheet *sheet,
                          enum pp_chart_format format, size_t *length)
{
    struct pp_canvas *canvas = canvas_of(format, PP_PAPER_A4, true);
    assert_int_equal(pp_waldram_chart_draw(canvas, sheet, NULL), PP_OK);
    return finished(canvas, length);
}

static char *pepper_pot_file(const struct pp_pepper_pot_sheet *sheet, double viewing,
                             enum pp_chart_format format, enum pp_paper paper,
                             size_t *length)
{
    struct pp_canvas *canvas = canvas_of(format, paper, true);
    assert_int_equal(pp_pepper_pot_chart_draw(canvas, sheet, viewing, NULL), PP_OK);
    return finished(canvas, length);
}

static struct pp_waldram_sheet blank_waldram(bool glazed)
{
    struct pp_sky sky = pp_sky_overcast();
    struct pp_waldram_sheet sheet;
    assert_int_equal(pp_waldram_sheet_fill_blank(&sheet, &sky, glazed, NULL), PP_OK);
    return sheet;
}

static struct pp_pepper_pot_sheet blank_pepper_pot(bool upright)
{
    struct pp_sky sky = pp_sky_overcast();
    struct pp_pepper_pot_sheet sheet;
    assert_int_equal(pp_pepper_pot_sheet_fill_blank(&sheet, &sky, true, upright,
                                                    PP_PEPPER_POT_WORTH, NULL),
                     PP_OK);
    return sheet;
}

/* True if a vertical stroke at x has an end at y. */
static bool has_upright(const struct strokes *strokes, double x, double y)
{
    for (int i = 0; i < strokes->count; i++) {
        const struct stroke *s = &strokes->list[i];
        if (fabs(s->x0 - x) < PAPER_MM && fabs(s->x1 - x) < PAPER_MM
            && (fabs(s->y0 - y) < PAPER_MM || fabs(s->y1 - y) < PAPER_MM))
            return true;
    }
    return false;
}

static bool has_level(const struct strokes *strokes, double x, double y)
{
    for (int i = 0; i < strokes->count; i++) {
        const struct stroke *s = &strokes->list[i];
        if (fabs(s->y0 - y) < PAPER_MM && fabs(s->y1 - y) < PAPER_MM
            && (fabs(s->x0 - x) < PAPER_MM || fabs(s->x1 - x) < PAPER_MM))
            return true;
    }
    return false;
}

/* Frame of the only panel: the widest rectangle, from two opposite horizontal strokes of
 * one path. */
static struct stroke frame_of(const struct strokes *strokes)
{
    struct stroke best = {0};
    for (int i = 0; i < strokes->count; i++) {
        const struct stroke *s = &strokes->list[i];
        for (int k = i + 1; k < strokes->count && k < i + 3; k++) {
            const struct stroke *t = &strokes->list[k];
            bool opposite =
                fabs(s->x0 - t->x1) < PAPER_MM && fabs(s->x1 - t->x0) < PAPER_MM
                && fabs(s->y0 - s->y1) < PAPER_MM && fabs(t->y0 - t->y1) < PAPER_MM;
            if (opposite && fabs(s->x1 - s->x0) > fabs(best.x1 - best.x0))
                best = (struct stroke){fmin(s->x0, s->x1), fmin(s->y0, t->y0),
                                       fmax(s->x0, s->x1), fmax(s->y0, t->y0)};
        }
    }
    assert_true(best.x1 - best.x0 > 50.0 && best.y1 > best.y0);
    return best;
}

/* ---- tests ---- */

/* The heading of each diagram names its surface: a wall by its name, or a ceiling
 * without one. */
static void a_panel_is_headed_by_its_wall_or_ceiling(void **state)
{
    (void)state;
    static const char *const heads[] = {"Wall south: with clear single glass,",
                                        "Ceiling: without glass,"};
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='5' depth='4' height='3'/>"
                "<window wall='south' left='1' sill='0.9' width='2' height='1.4'/>"
                "<rooflight x='2' y='2' width='1.2' depth='0.9' glazing='none'/>"
                "<point x='2.5' y='2'/></room>");
    struct pp_pepper_pot_sheet sheet;
    assert_int_equal(pp_pepper_pot_sheet_fill_room(&sheet, world, &light,
                                                   world->receivers,
                                                   PP_PEPPER_POT_WORTH, NULL),
                     PP_OK);
    assert_int_equal(sheet.count, 2);
    for (int i = 0; i < 2; i++) {
        char words[128];
        pp_board_panel_words(words, sizeof words, &sheet.panels[i].face,
                             sheet.panels[i].glazed);
        assert_string_equal(words, heads[i]);
    }
    pp_board_sheets_pepper_pot_clear(&sheet);
    pp_world_destroy(world);
}

static void sheets_sum_up_to_what_the_methods_give(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, two_sides);
    struct pp_waldram_sheet waldram;
    struct pp_pepper_pot_sheet pots;
    assert_int_equal(
        pp_waldram_sheet_fill_room(&waldram, world, &light, world->receivers, NULL),
        PP_OK);
    assert_int_equal(pp_pepper_pot_sheet_fill_room(&pots, world, &light,
                                                   world->receivers,
                                                   PP_PEPPER_POT_WORTH, NULL),
                     PP_OK);
    assert_near(waldram.sky_component, value_of(world, &light, PP_SC, "waldram"),
                1e-13);
    assert_near(waldram.external, value_of(world, &light, PP_ERC, "waldram"), 1e-13);
    assert_near(pots.sky_component, value_of(world, &light, PP_SC, "pepper-pot"),
                1e-13);
    assert_near(pots.external, value_of(world, &light, PP_ERC, "pepper-pot"), 1e-13);
    assert_true(waldram.external > 0.0 && pots.external > 0.0);
    /* The south window is glazed, the east window is not. */
    assert_int_equal(waldram.count, 2);
    assert_int_equal(waldram.panels[0].count, 2);
    assert_true(waldram.panels[0].glazed && !waldram.panels[1].glazed);
    for (int i = 0; i < waldram.count; i++)
        for (int w = 0; w < waldram.panels[i].count; w++)
            for (int p = 0; p < waldram.panels[i].windows[w].count; p++) {
                const struct pp_board_piece *piece =
                    &waldram.panels[i].windows[w].pieces[p];
                int tenths = 0;
                for (int k = 0; k < piece->square_count; k++)
                    tenths += piece->squares[k].tenths;
                assert_near(tenths / 10.0, piece->counted, 1e-9);
                /* The drawn outline has the area of the squares. */
                assert_near(pp_region_area(&piece->outline), piece->counted, 0.6);
            }
    pp_board_sheets_waldram_clear(&waldram);
    pp_board_sheets_pepper_pot_clear(&pots);
    pp_world_destroy(world);
}

static void the_ruler_is_100_mm_long_and_has_its_millimetres(void **state)
{
    (void)state;
    const enum pp_paper papers[] = {PP_PAPER_A5, PP_PAPER_A4, PP_PAPER_A3, PP_PAPER_A2};
    struct pp_pepper_pot_sheet sheet = blank_pepper_pot(false);
    for (int i = 0; i < 4; i++) {
        size_t length;
        char *svg = pepper_pot_file(&sheet, 0.0, PP_CHART_SVG, papers[i], &length);
        struct strokes strokes = strokes_of(svg);
        bool found = false;
        for (int k = 0; k < strokes.count && !found; k++) {
            const struct stroke *s = &strokes.list[k];
            if (fabs(s->y1 - s->y0) > 1e-9 || fabs(s->x1 - s->x0 - 100.0) > PAPER_MM)
                continue;
            found = true;
            for (int mm = 0; mm <= 100; mm++)
                found = found && has_upright(&strokes, s->x0 + mm, s->y0);
        }
        assert_true(found);
        free(strokes.list);
        free(svg);
    }
    pp_board_sheets_pepper_pot_clear(&sheet);
}

/* A metre at a distance of 1.5 m is 24 mm long for a viewing distance of 36 mm. */
static void metres_are_drawn_as_the_viewing_distance_over_theirs(void **state)
{
    (void)state;
    struct pp_pepper_pot_sheet sheet = blank_pepper_pot(false);
    size_t length;
    char *svg = pepper_pot_file(&sheet, 36.0, PP_CHART_SVG, PP_PAPER_A4, &length);
    struct strokes strokes = strokes_of(svg);
    bool found = false;
    for (int k = 0; k < strokes.count && !found; k++) {
        const struct stroke *s = &strokes.list[k];
        double metres = (s->x1 - s->x0) / 24.0;
        found = fabs(s->y1 - s->y0) < 1e-9 && metres > 1.5
                && fabs(metres - rint(metres)) * 24.0 < PAPER_MM
                && has_upright(&strokes, s->x0 + 24.0, s->y0)
                && has_upright(&strokes, s->x0 + 48.0, s->y0)
                && !has_upright(&strokes, s->x0 + 1.0, s->y0)
                && !has_upright(&strokes, s->x0 + 12.0, s->y0);
    }
    assert_true(found);
    free(strokes.list);
    free(svg);
    pp_board_sheets_pepper_pot_clear(&sheet);
}

/* Without glass the scale is linear in azimuth, and 3 sin^2 + 4 sin^3 in altitude. */
static void waldram_scale_marks_stand_where_the_formula_puts_them(void **state)
{
    (void)state;
    struct pp_waldram_sheet sheet = blank_waldram(false);
    size_t length;
    char *svg = waldram_file(&sheet, PP_CHART_SVG, &length);
    struct strokes strokes = strokes_of(svg);
    struct stroke frame = frame_of(&strokes);
    double width = frame.x1 - frame.x0, height = frame.y1 - frame.y0;
    /* 36 by 500/36 equal squares. */
    assert_near(height / width, 500.0 / 36.0 / 36.0, 1e-4);
    for (int degree = 0; degree <= 180; degree += 5)
        if (!has_upright(&strokes, frame.x0 + degree / 180.0 * width, frame.y1))
            fail_msg("no mark at azimuth %d", degree - 90);
    for (int degree = 5; degree < 90; degree += 5) {
        double s = sin(degree * PP_RAD), share = s * s * (3.0 + 4.0 * s) / 7.0;
        if (!has_level(&strokes, frame.x0, frame.y1 - share * height))
            fail_msg("no mark at altitude %d", degree);
    }
    free(strokes.list);
    free(svg);
    pp_board_sheets_waldram_clear(&sheet);
}

/* Azimuth is scaled by its sine, altitude by 3 (gamma + sin gamma cos gamma) + 4 (1 -
 * cos^3 gamma) divided by its value at the zenith, 3 pi/2 + 4; 36 squares by 11. */
static void marks_for_an_upright_receiver_stand_where_the_formula_puts_them(
    void **state)
{
    (void)state;
    struct pp_sky sky = pp_sky_overcast();
    struct pp_waldram_sheet sheet;
    size_t length;
    assert_int_equal(pp_waldram_sheet_fill_upright(&sheet, &sky, NULL), PP_OK);
    char *svg = waldram_file(&sheet, PP_CHART_SVG, &length);
    struct strokes strokes = strokes_of(svg);
    struct stroke frame = frame_of(&strokes);
    double width = frame.x1 - frame.x0, height = frame.y1 - frame.y0;
    assert_near(height / width, 396.177 / 36.0 / 36.0, 1e-4);
    for (int degree = -90; degree <= 90; degree += 5)
        if (!has_upright(&strokes,
                         frame.x0 + 0.5 * width * (1.0 + sin(degree * PP_RAD)),
                         frame.y1))
            fail_msg("no mark at azimuth %d", degree);
    for (int degree = 5; degree < 90; degree += 5) {
        double g = degree * PP_RAD, c = cos(g);
        double share =
            (3.0 * (g + sin(g) * c) + 4.0 * (1.0 - c * c * c)) / (1.5 * PP_PI + 4.0);
        if (!has_level(&strokes, frame.x0, frame.y1 - share * height))
            fail_msg("no mark at altitude %d", degree);
    }
    free(strokes.list);
    free(svg);
    pp_board_sheets_waldram_clear(&sheet);
}

/* Altitude at this share of the height of the vertical diagram, by Newton's method. */
static double sheet_altitude(double share)
{
    double g = 0.5;
    for (int i = 0; i < 50; i++) {
        double c = cos(g), s = sin(g);
        double excess =
            3.0 * (g + s * c) + 4.0 * (1.0 - c * c * c) - share * (1.5 * PP_PI + 4.0);
        g -= excess / (6.0 * c * c + 12.0 * c * c * s);
    }
    return g;
}

/* True if two slanting strokes cross at x, y. */
static bool has_cross(const struct strokes *strokes, double x, double y)
{
    int found = 0;
    for (int i = 0; i < strokes->count; i++) {
        const struct stroke *s = &strokes->list[i];
        bool slanting = fabs(fabs(s->x1 - s->x0) - fabs(s->y1 - s->y0)) < PAPER_MM
                        && fabs(s->x1 - s->x0) > PAPER_MM;
        found += slanting && fabs(0.5 * (s->x0 + s->x1) - x) < PAPER_MM
                 && fabs(0.5 * (s->y0 + s->y1) - y) < PAPER_MM;
    }
    return found == 2;
}

/* On A4 a unit is 10 mm. The ticks along the wall are the only strokes that extend
 * downwards from one line at this spacing. */
static void crosses_of_the_indicator_stand_at_the_cotangents_of_their_altitudes(
    void **state)
{
    (void)state;
    struct pp_sky sky = pp_sky_overcast();
    struct pp_skylight_indicator_sheet sheet;
    assert_int_equal(pp_skylight_indicator_fill_blank(&sheet, &sky, NULL), PP_OK);
    struct pp_canvas *canvas = canvas_of(PP_CHART_SVG, PP_PAPER_A4, true);
    assert_int_equal(pp_skylight_indicator_chart_draw(canvas, &sheet, NULL), PP_OK);
    size_t length;
    char *svg = finished(canvas, &length);
    struct strokes strokes = strokes_of(svg);
    double x0 = NAN, y0 = NAN;
    for (int i = 0; i < strokes.count && isnan(x0); i++) {
        const struct stroke *s = &strokes.list[i];
        bool all = fabs(s->x1 - s->x0) < 1e-9 && s->y1 > s->y0;
        for (int k = 1; k <= 12 && all; k++)
            all = has_upright(&strokes, s->x0 + 10.0 * k, s->y0)
                  && has_upright(&strokes, s->x0 - 10.0 * k, s->y0);
        if (all) {
            x0 = s->x0;
            y0 = s->y0;
        }
    }
    assert_false(isnan(x0));
    /* Fourth ring, 7/16 of the height of the diagram: 3 (g + sin g cos g) + 4 (1 -
     * cos^3 g) is 7/16 of 3 pi/2 + 4 at 27.0875 degrees. */
    double cot = 1.0 / tan(sheet_altitude(7.0 / 16.0));
    assert_near(cot, 1.0 / tan(27.0875 * PP_RAD), 1e-5);
    for (int j = 0; j < PP_SKYLIGHT_RAYS; j++) {
        double s = (2.0 * j + 1.0) / 10.0 - 1.0;
        assert_true(has_cross(&strokes, x0 + 10.0 * cot * s,
                              y0 - 10.0 * cot * sqrt(1.0 - s * s)));
    }
    free(strokes.list);
    free(svg);
    pp_skylight_indicator_sheet_clear(&sheet);
}

/* A façade 8 m away at its nearest point, 25 degrees to the right, and 5.5 m higher
 * than the eye: the points of its edge are (8 sin 25 + s cos 25, 8 cos 25 - s sin 25,
 * 5.5). */
static void droop_lines_of_an_inclined_facade_are_its_edge_as_seen(void **state)
{
    (void)state;
    double delta = 25.0 * PP_RAD, top = atan2(5.5, 8.0);
    for (int upright = 0; upright < 2; upright++) {
        struct pp_sky sky = pp_sky_overcast();
        struct pp_waldram_sheet sheet;
        assert_int_equal(upright
                             ? pp_waldram_sheet_fill_upright(&sheet, &sky, NULL)
                             : pp_waldram_sheet_fill_blank(&sheet, &sky, false, NULL),
                         PP_OK);
        assert_int_equal(pp_waldram_sheet_fill_inclined(&sheet, delta, NULL), PP_OK);
        const struct pp_waldram_panel *panel = sheet.panels;
        assert_int_equal(panel->across.count, 8);
        for (double s = -20.0; s < 20.0; s += 3.7) {
            double x = 8.0 * sin(delta) + s * cos(delta);
            double y = 8.0 * cos(delta) - s * sin(delta);
            double phi = atan2(x, y), gamma = atan2(5.5, hypot(x, y));
            /* For every level, the tangent of the altitude divided by that at the
             * nearest point is the same. */
            double ratio = tan(gamma) / tan(top);
            int near = 90 + (int)floor(phi / PP_RAD);
            if (fabs(phi) > 88.0 * PP_RAD)
                continue;
            const struct pp_curve *curve = &panel->across.list[2];
            double t = phi / PP_RAD - floor(phi / PP_RAD);
            double wanted = atan(tan(30.0 * PP_RAD) * ratio) / PP_RAD;
            int low = (int)floor(wanted);
            double height =
                panel->altitude[low]
                + (wanted - low) * (panel->altitude[low + 1] - panel->altitude[low]);
            /* Chords of a degree; squares are some millimetres on paper. */
            assert_near((1.0 - t) * curve->xy[near][1] + t * curve->xy[near + 1][1],
                        height, 0.01);
        }
        pp_board_sheets_waldram_clear(&sheet);
    }
}

static void droop_lines_pass_through_known_directions(void **state)
{
    (void)state;
    struct pp_waldram_sheet sheet = blank_waldram(false);
    const struct pp_waldram_panel *panel = sheet.panels;
    assert_int_equal(panel->parallel.count, 8);
    /* Parallel, 50 degrees in the middle: at an azimuth of 60 degrees tan 50 cos 60. */
    const struct pp_curve *curve = &panel->parallel.list[4];
    assert_near(curve->level, 50.0 * PP_RAD, 1e-12);
    double s = sin(atan(tan(50.0 * PP_RAD) * cos(60.0 * PP_RAD)));
    double y = s * s * (3.0 + 4.0 * s) / 7.0 * panel->top;
    assert_near(curve->xy[150][0], panel->azimuth[60], 1e-9);
    assert_near(curve->xy[150][1], y, 1e-9);
    /* Perpendicular: zero straight ahead, its level at 90 degrees. */
    curve = &panel->across.list[4];
    assert_near(curve->xy[90][1], 0.0, 1e-12);
    assert_near(curve->xy[180][1], panel->altitude[50], 1e-9);
    pp_board_sheets_waldram_clear(&sheet);
}

static void two_drawings_are_the_same_bytes(void **state)
{
    (void)state;
    const enum pp_chart_format formats[] = {PP_CHART_PDF, PP_CHART_SVG, PP_CHART_PNG};
    struct pp_waldram_sheet waldram = blank_waldram(true);
    struct pp_pepper_pot_sheet pot = blank_pepper_pot(true);
    for (int i = 0; i < 3; i++) {
        size_t lengths[4];
        char *files[4];
        for (int k = 0; k < 2; k++) {
            files[k] = waldram_file(&waldram, formats[i], &lengths[k]);
            files[2 + k] =
                pepper_pot_file(&pot, 0.0, formats[i], PP_PAPER_A4, &lengths[2 + k]);
        }
        for (int k = 0; k < 4; k += 2) {
            assert_int_equal(lengths[k], lengths[k + 1]);
            assert_memory_equal(files[k], files[k + 1], lengths[k]);
        }
        for (int k = 0; k < 4; k++)
            free(files[k]);
    }
    pp_board_sheets_waldram_clear(&waldram);
    pp_board_sheets_pepper_pot_clear(&pot);
}

/* True if two horizontal strokes have this width and are this far apart. */
static bool has_rectangle(const struct strokes *strokes, double width, double height)
{
    for (int i = 0; i < strokes->count; i++) {
        const struct stroke *s = &strokes->list[i];
        if (fabs(s->y1 - s->y0) > PAPER_MM
            || fabs(fabs(s->x1 - s->x0) - width) > PAPER_MM)
            continue;
        for (int k = 0; k < strokes->count; k++) {
            const struct stroke *t = &strokes->list[k];
            if (fabs(t->y1 - t->y0) < PAPER_MM && fabs(t->x0 - s->x1) < PAPER_MM
                && fabs(t->x1 - s->x0) < PAPER_MM
                && fabs(fabs(t->y0 - s->y0) - height) < PAPER_MM)
                return true;
        }
    }
    return false;
}

/* Windows of 1.9 by 1.6 and 1.7 by 1.3 m, 1.7 m away, with dots for a viewing distance
 * of 31 mm. Without a viewing distance everything has the scale of the plan. */
static void exercises_have_their_elevations_at_the_diagrams_scale(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, two_sides);
    for (int i = 0; i < 2; i++) {
        const struct pp_exercise exercise = {.world = world,
                                             .light = &light,
                                             .receiver = world->receivers[0],
                                             .tool = "a diagram",
                                             .viewing_mm = i ? 0.0 : 31.0};
        struct pp_canvas *canvas = canvas_of(PP_CHART_SVG, PP_PAPER_A3, true);
        struct pp_error err = {0};
        if (pp_exercise_chart_draw(canvas, &exercise, &err) != PP_OK)
            fail_msg("%s", err.message);
        size_t length;
        char *svg = finished(canvas, &length);
        struct strokes strokes = strokes_of(svg);
        /* A3 has space for the room and its elevations at 1:75. */
        double near = i ? 1000.0 / 75.0 : 31.0 / 1.7;
        assert_true(has_rectangle(&strokes, 1.9 * near, 1.6 * near));
        assert_true(has_rectangle(&strokes, 1.7 * near, 1.3 * near));
        assert_false(has_rectangle(&strokes, 1.9 * near + 0.1, 1.6 * near));
        /* East, 3 m away. */
        double far = i ? near : 31.0 / 3.0;
        assert_true(has_rectangle(&strokes, 1.2 * far, 1.4 * far));
        free(strokes.list);
        free(svg);
    }
    pp_world_destroy(world);
}

/* Points behind the plane of the window and in it, in an L-shaped room. */
static void a_window_that_is_not_seen_has_no_squares_and_no_dots(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version=\"1\">\n"
        "<plan height=\"2.7\"><vertex x=\"0\" y=\"0\"/><vertex x=\"3\" y=\"0\"/>"
        "<vertex x=\"3\" y=\"3\"/><vertex x=\"6\" y=\"3\"/><vertex x=\"6\" y=\"7\"/>"
        "<vertex x=\"0\" y=\"7\"/></plan>\n"
        "<window wall=\"3\" left=\"0.5\" sill=\"0.9\" width=\"1.5\" height=\"1.2\"/>\n"
        "<point x=\"1.1\" y=\"1.4\"/><point x=\"1.1\" y=\"3\"/>\n"
        "</room>\n");
    for (int i = 0; i < 2; i++) {
        struct pp_waldram_sheet waldram;
        struct pp_pepper_pot_sheet pot;
        assert_int_equal(pp_waldram_sheet_fill_room(&waldram, world, &light,
                                                    &world->receivers[i], NULL),
                         PP_OK);
        assert_int_equal(pp_pepper_pot_sheet_fill_room(&pot, world, &light,
                                                       &world->receivers[i],
                                                       PP_PEPPER_POT_WORTH, NULL),
                         PP_OK);
        assert_int_equal(waldram.panels[0].windows[0].count, 0);
        assert_int_equal(pot.panels[0].windows[0].count, 0);
        assert_near(waldram.sky_component + pot.sky_component, 0.0, 0.0);
        size_t length;
        free(waldram_file(&waldram, PP_CHART_SVG, &length));
        free(pepper_pot_file(&pot, 0.0, PP_CHART_SVG, PP_PAPER_A5, &length));
        pp_board_sheets_waldram_clear(&waldram);
        pp_board_sheets_pepper_pot_clear(&pot);
    }
    pp_world_destroy(world);
}

static void what_the_diagrams_do_not_hold_is_refused_with_why(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version=\"1\">\n"
                "<plan width=\"4\" depth=\"5\" height=\"2.7\"/>\n"
                "<rooflight x=\"1\" y=\"1\" width=\"1\" depth=\"1\"/>\n"
                "<point x=\"1.1\" y=\"1.4\"/>\n"
                "</room>\n");
    struct pp_waldram_sheet waldram;
    struct pp_pepper_pot_sheet pot;
    struct pp_error err = {0};
    assert_int_equal(
        pp_waldram_sheet_fill_room(&waldram, world, &light, world->receivers, &err),
        PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "rooflight RL1 has sloping glass"));
    world->openings[0].glass = pp_glass_diffusing(0.6);
    assert_int_equal(pp_pepper_pot_sheet_fill_room(&pot, world, &light,
                                                   world->receivers,
                                                   PP_PEPPER_POT_WORTH, &err),
                     PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "rooflight RL1"));
    pp_world_destroy(world);

    struct pp_sky sky;
    assert_int_equal(pp_sky_iso(&sky, 12, pp_vec(0.6, 0.0, 0.8), NULL), PP_OK);
    assert_int_equal(pp_waldram_sheet_fill_blank(&waldram, &sky, true, &err),
                     PP_BAD_INPUT);
    assert_int_equal(pp_pepper_pot_sheet_fill_blank(&pot, &sky, true, false,
                                                    PP_PEPPER_POT_WORTH, &err),
                     PP_BAD_INPUT);
}

/* For a rooflight or a clear sky, for which there are no published dots, the sheet has
 * the dots of `pepper-pot-sky` and their sums. Without windows it is an exercise. */
static void dots_for_any_sky_and_slope_sum_up_to_their_method(void **state)
{
    (void)state;
    static const char *const rooms[] = {
        "<room version='1'><plan width='4' depth='5' height='2.7'/>"
        "<rooflight x='1' y='1' width='1' depth='1'/><point x='1.1' y='1.4'/></room>",
        "<room version='1'><sky type='iso-12' sun-altitude='35' sun-bearing='160'/>"
        "<plan width='4' depth='5' height='2.7'/><window wall='south' left='1' "
        "sill='0.9' width='2' height='1.3'/><point x='1.1' y='1.4'/></room>"};
    for (int i = 0; i < 2; i++) {
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, rooms[i]);
        struct pp_pepper_pot_sheet pot;
        assert_int_equal(pp_pepper_pot_sheet_fill_room(&pot, world, &light,
                                                       world->receivers,
                                                       PP_PEPPER_POT_WORTH, NULL),
                         PP_OK);
        assert_true(pot.any && pot.sky_component > 0.02);
        assert_int_equal(pot.panels[0].any_slope, i == 0);
        assert_near(pot.sky_component, value_of(world, &light, PP_SC, "pepper-pot-sky"),
                    1e-13);
        pp_pepper_pot_sheet_fill_unsolved(&pot);
        assert_true(pot.blank && pot.panels[0].count == 0);
        assert_true(!pot.panels[0].face.name && !pot.panels[0].face.overhead);
        for (int k = 0; k < pot.panels[0].dot_count; k++)
            assert_false(pot.panels[0].dots[k].counted);
        pp_board_sheets_pepper_pot_clear(&pot);
        pp_world_destroy(world);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dots_for_any_sky_and_slope_sum_up_to_their_method),
        cmocka_unit_test(a_panel_is_headed_by_its_wall_or_ceiling),
        cmocka_unit_test(sheets_sum_up_to_what_the_methods_give),
        cmocka_unit_test(the_ruler_is_100_mm_long_and_has_its_millimetres),
        cmocka_unit_test(metres_are_drawn_as_the_viewing_distance_over_theirs),
        cmocka_unit_test(waldram_scale_marks_stand_where_the_formula_puts_them),
        cmocka_unit_test(
            marks_for_an_upright_receiver_stand_where_the_formula_puts_them),
        cmocka_unit_test(
            crosses_of_the_indicator_stand_at_the_cotangents_of_their_altitudes),
        cmocka_unit_test(droop_lines_of_an_inclined_facade_are_its_edge_as_seen),
        cmocka_unit_test(droop_lines_pass_through_known_directions),
        cmocka_unit_test(two_drawings_are_the_same_bytes),
        cmocka_unit_test(exercises_have_their_elevations_at_the_diagrams_scale),
        cmocka_unit_test(a_window_that_is_not_seen_has_no_squares_and_no_dots),
        cmocka_unit_test(what_the_diagrams_do_not_hold_is_refused_with_why),
    };
    add_tests(tests, NULL, NULL);
}
