/* test_page.c - draws the test page from top to bottom. All lengths are in
 * millimetres. */
#include "charts/test_page.h"

#include <stdio.h>

#include "charts/sheet/hatch.h"
#include "charts/sheet/page.h"

/* Sample text: letters of European names, signs in formulae, and letters that are
 * easily confused. */
static const char sample[] =
    "ÄÖÜ äöüß àçéñøš łőž  ·  θ τ ρ φ η  ·  ° ² √ − × ≤ ± ½ – …  ·  "
    "1 l I | 0 O 5 S 8 B";

static const struct pp_page page = {
    "Test page", "Print this page at 100 % (\"actual size\"), and measure the rulers",
    "The rulers are 100 mm long; the circle and its square are 50 mm wide. If a "
    "printed length differs, the printer has scaled the page, and no drawing is at its "
    "true scale. Corner marks are 10 mm from the edges of an A4 sheet. Neighbouring "
    "greys should differ, the thinnest line should be unbroken, and the lines of "
    "hatches should not merge."};

struct test_page {
    cairo_t *cr;
    struct pp_style style;
    double left, width; /* left edge and width of all rows */
};

static void label(const struct test_page *sheet, double x, double y, double across,
                  const char *words)
{
    const struct pp_lettering text = {.size = PP_TEXT_SMALL, .across = across};
    pp_lettering_draw(sheet->cr, &sheet->style, &text, x, y, words);
}

static void draw_heading(const struct test_page *sheet, double y, const char *words)
{
    const struct pp_lettering text = {.size = PP_TEXT_BODY, .bold = true, .down = 1.0};
    pp_lettering_draw(sheet->cr, &sheet->style, &text, sheet->left, y, words);
}

static void stroke(cairo_t *cr, double x0, double y0, double x1, double y1)
{
    cairo_move_to(cr, x0, y0);
    cairo_line_to(cr, x1, y1);
    cairo_stroke(cr);
}

/* Length (mm) of the tick at a millimetre of the ruler. */
static double tick_length(int mm)
{
    return mm % 10 == 0 ? 5.0 : mm % 5 == 0 ? 3.5 : 2.0;
}

/* Draws two rulers from x, y, one to the right and one downwards. */
static void draw_rulers(const struct test_page *sheet, double x, double y)
{
    cairo_t *cr = sheet->cr;
    const double end = PP_TEST_PAGE_RULER_MM;
    pp_style_line(cr, 0.18, PP_INK);
    stroke(cr, x, y, x + end, y);
    stroke(cr, x, y, x, y + end);
    for (int mm = 0; mm <= PP_TEST_PAGE_RULER_MM; mm++) {
        char words[16];
        pp_style_line(cr, 0.12, PP_INK);
        stroke(cr, x + mm, y, x + mm, y - tick_length(mm));
        stroke(cr, x, y + mm, x - tick_length(mm), y + mm);
        if (mm % 10 != 0)
            continue;
        snprintf(words, sizeof words, mm < PP_TEST_PAGE_RULER_MM ? "%d" : "%d mm", mm);
        label(sheet, x + mm, y - 8.5, 0.5, words);
        const struct pp_lettering aside = {
            .size = PP_TEXT_SMALL, .across = 1.0, .down = 0.5};
        if (mm > 0)
            pp_lettering_draw(cr, &sheet->style, &aside, x - 6.0, y + mm, words);
    }
}

static void draw_circle(const struct test_page *sheet, double x, double y)
{
    cairo_t *cr = sheet->cr;
    pp_style_line(cr, 0.18, PP_INK);
    cairo_rectangle(cr, x, y, 50.0, 50.0);
    cairo_stroke(cr);
    cairo_arc(cr, x + 25.0, y + 25.0, 25.0, 0.0, 2.0 * PP_PI);
    cairo_stroke(cr);
    label(sheet, x + 25.0, y + 50.8, 0.5, "50 mm");
}

/* Writes text in every size used in charts, downwards from y. */
static void draw_text_sizes(const struct test_page *sheet, double x, double y)
{
    static const char *const names[] = {[PP_TEXT_SMALL] = "small",
                                        [PP_TEXT_BODY] = "body",
                                        [PP_TEXT_HEAD] = "head",
                                        [PP_TEXT_TITLE] = "title"};
    for (enum pp_text_size size = PP_TEXT_TITLE;; size--) {
        char words[96];
        snprintf(words, sizeof words, "%s, %.1f mm: daylight factor 2.35 %%",
                 names[size], sheet->style.text[size]);
        const struct pp_lettering text = {.size = size};
        struct pp_box box =
            pp_lettering_draw(sheet->cr, &sheet->style, &text, x, y, words);
        y += box.height + 1.5;
        if (size == PP_TEXT_SMALL)
            break;
    }
    const struct pp_lettering letters = {.size = PP_TEXT_BODY,
                                         .width = sheet->left + sheet->width - x};
    pp_lettering_draw(sheet->cr, &sheet->style, &letters, x, y + 1.5, sample);
}

/* Draws greys from black to 20 % black in steps of 10 %, then the fill of charts (12
 * %), half of it, and white. */
static void draw_greys(const struct test_page *sheet, double y)
{
    enum { STEPS = 12 };
    const double width = sheet->width / STEPS;
    for (int i = 0; i < STEPS; i++) {
        double black = i < 9     ? 1.0 - 0.1 * i
                       : i == 9  ? 1.0 - PP_GREY_FILL
                       : i == 10 ? 0.06
                                 : 0.0;
        double x = sheet->left + i * width;
        char words[16];
        pp_style_grey(sheet->cr, 1.0 - black);
        cairo_rectangle(sheet->cr, x, y, width, 12.0);
        cairo_fill(sheet->cr);
        snprintf(words, sizeof words, "%.0f %%", 100.0 * black);
        label(sheet, x + 0.5 * width, y + 12.8, 0.5, words);
    }
    pp_style_line(sheet->cr, 0.12, PP_INK);
    cairo_rectangle(sheet->cr, sheet->left, y, sheet->width, 12.0);
    cairo_stroke(sheet->cr);
}

/* Draws lines of several widths on the left, and the curves of charts on the right. */
static void draw_lines(const struct test_page *sheet, double y)
{
    static const double widths[] = {0.1, 0.13, 0.18, 0.25, 0.35, 0.5, 0.7, 1.0};
    const double half = 0.5 * sheet->width;
    for (int i = 0; i < 8; i++) {
        char words[24];
        double at = y + 2.0 + 4.0 * i;
        pp_style_line(sheet->cr, widths[i], PP_INK);
        stroke(sheet->cr, sheet->left + 16.0, at, sheet->left + half - 6.0, at);
        snprintf(words, sizeof words, "%.2f mm", widths[i]);
        label(sheet, sheet->left, at - 1.6, 0.0, words);

        const struct pp_curve_style curve = pp_style_curve(i);
        double x = sheet->left + half + 14.0;
        pp_style_pen(sheet->cr, &sheet->style, &curve);
        stroke(sheet->cr, x, at, sheet->left + sheet->width, at);
        pp_style_marker(sheet->cr, &sheet->style, (enum pp_marker)curve.marker,
                        x + 25.0, at);
        snprintf(words, sizeof words, "curve %d", i + 1);
        label(sheet, x - 14.0, at - 1.6, 0.0, words);
    }
}

/* Draws six hatched fields in two columns. x, y: upper left corner. */
static void draw_hatches(const struct test_page *sheet, double x, double y)
{
    static const struct {
        double apart, weight;
    } list[] = {{0.6, 0.1},  {0.8, 0.1},  {1.2, 0.13},
                {1.8, 0.18}, {2.5, 0.25}, {3.5, 0.35}};
    for (int i = 0; i < 6; i++) {
        struct pp_box box = {x + i % 2 * 45.0, y + i / 2 * 18.0, 40.0, 12.0};
        char words[32];
        cairo_rectangle(sheet->cr, box.x, box.y, box.width, box.height);
        pp_hatch_path(sheet->cr, box, list[i].apart, list[i].weight, PP_INK);
        pp_style_line(sheet->cr, 0.18, PP_INK);
        cairo_rectangle(sheet->cr, box.x, box.y, box.width, box.height);
        cairo_stroke(sheet->cr);
        snprintf(words, sizeof words, "%.1f mm apart", list[i].apart);
        label(sheet, box.x, box.y + 12.6, 0.0, words);
    }
}

/* Draws a cross in each corner, 10 mm from both edges of the sheet. */
static void draw_corners(const struct test_page *sheet, double width, double height)
{
    pp_style_line(sheet->cr, 0.18, PP_INK);
    for (int i = 0; i < 4; i++) {
        double x = i % 2 ? width - 10.0 : 10.0, y = i / 2 ? height - 10.0 : 10.0;
        stroke(sheet->cr, x - 3.0, y, x + 3.0, y);
        stroke(sheet->cr, x, y - 3.0, x, y + 3.0);
    }
}

enum pp_status pp_test_page_draw(struct pp_canvas *canvas, struct pp_error *err)
{
    struct test_page sheet = {.cr = pp_canvas_cairo(canvas),
                              .style = pp_page_style(canvas)};
    struct pp_box body = pp_page_draw(canvas, &sheet.style, &page);
    sheet.left = body.x;
    sheet.width = body.width;
    draw_corners(&sheet, pp_canvas_width_mm(canvas), pp_canvas_height_mm(canvas));

    double y = body.y + 14.0;
    draw_rulers(&sheet, body.x + 14.0, y);
    draw_text_sizes(&sheet, body.x + 24.0, y + 8.0);
    draw_circle(&sheet, body.x + 26.0, y + 44.0);
    draw_hatches(&sheet, body.x + 94.0, y + 44.0);
    y += PP_TEST_PAGE_RULER_MM + 16.0;
    draw_heading(&sheet, y - 1.5, "Greys, by share of black");
    draw_greys(&sheet, y);
    y += 30.0;
    draw_heading(&sheet, y - 1.5, "Line widths, and curves of charts");
    draw_lines(&sheet, y);
    return cairo_status(sheet.cr) == CAIRO_STATUS_SUCCESS
               ? PP_OK
               : pp_fail(err, PP_SYSTEM, "the test page cannot be drawn: %s",
                         cairo_status_to_string(cairo_status(sheet.cr)));
}

int pp_test_page_font(char *family, size_t room)
{
    return pp_lettering_font(sample, family, room);
}
