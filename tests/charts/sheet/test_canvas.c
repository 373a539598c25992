/* test_canvas.c - drawings as files: true scale, identical bytes, titles, errors. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>

#include "charts/sheet/canvas.h"
#include "charts/sheet/page.h"
#include "tests/lib/near.h"
#include "tests/lib/through.h"

static const char title[] = "Caf\xc3\xa9 <north> & \"south\"";

static struct pp_canvas *canvas_of(enum pp_chart_format format, enum pp_paper paper,
                                   bool landscape)
{
    struct pp_sheet sheet = {.format = format,
                             .paper = paper,
                             .landscape = landscape,
                             .title = title,
                             .description = "A rule & words"};
    struct pp_canvas *canvas;
    struct pp_error err;
    if (pp_canvas_create(&canvas, &sheet, &err) != PP_OK)
        fail_msg("%s", err.message);
    return canvas;
}

/* A line from (20, 30) to (120, 30), 100 mm long, within a clip, and text below it. */
static void draw_rule(struct pp_canvas *canvas)
{
    cairo_t *cr = pp_canvas_cairo(canvas);
    struct pp_style style = pp_page_style(canvas);
    struct pp_lettering text = {.size = PP_TEXT_BODY};
    cairo_save(cr);
    cairo_arc(cr, 70, 50, 60, 0, 6.28);
    cairo_clip(cr);
    cairo_set_line_width(cr, 0.25);
    cairo_move_to(cr, 20, 30);
    cairo_line_to(cr, 120, 30);
    cairo_stroke(cr);
    cairo_restore(cr);
    pp_lettering_draw(cr, &style, &text, 20, 40, "Working plane");
}

/* The whole file as a string. */
static char *file_of(struct pp_canvas *canvas, size_t *length)
{
    const unsigned char *bytes;
    struct pp_error err;
    if (pp_canvas_finish(canvas, &bytes, length, &err) != PP_OK)
        fail_msg("%s", err.message);
    char *copy = malloc(*length + 1);
    memcpy(copy, bytes, *length);
    copy[*length] = 0;
    return copy;
}

static char *drawn(enum pp_chart_format format, size_t *length)
{
    struct pp_canvas *canvas = canvas_of(format, PP_PAPER_A4, false);
    draw_rule(canvas);
    char *file = file_of(canvas, length);
    pp_canvas_destroy(canvas);
    return file;
}

static void svg_is_in_millimetres_and_a_rule_is_100_mm_long(void **state)
{
    (void)state;
    size_t length;
    char *svg = drawn(PP_CHART_SVG, &length);
    double width, height, box_width, box_height;
    const char *root = strstr(svg, "<svg");
    assert_non_null(root);
    assert_int_equal(sscanf(strstr(root, "width="), "width=\"%lfmm\" height=\"%lfmm\"",
                            &width, &height),
                     2);
    assert_int_equal(sscanf(strstr(root, "viewBox="), "viewBox=\"0 0 %lf %lf\"",
                            &box_width, &box_height),
                     2);
    assert_near(width, 210.0, 0.0);
    assert_near(height, 297.0, 0.0);
    /* Path of the line in units of the view box, which a matrix may transform. */
    const char *path = strstr(svg, "stroke:rgb");
    assert_non_null(path);
    double x0, y0, x1, y1, xx = 1.0, yy = 1.0, zero;
    assert_int_equal(
        sscanf(strstr(path, " d=\"") + 4, "M %lf %lf L %lf %lf", &x0, &y0, &x1, &y1),
        4);
    const char *matrix = strstr(path, "matrix(");
    if (matrix && matrix < strchr(path, '>'))
        assert_int_equal(
            sscanf(matrix, "matrix(%lf,%lf,%lf,%lf", &xx, &zero, &zero, &yy), 4);
    assert_near((x1 - x0) * xx / box_width * width, 100.0, 0.1);
    assert_near(y0 * yy / box_height * height, 30.0, 0.1);
    free(svg);
}

static void svg_has_a_title_a_description_and_ids_of_its_own(void **state)
{
    (void)state;
    size_t length;
    char *svg = drawn(PP_CHART_SVG, &length);
    assert_non_null(strstr(svg, "Caf\xc3\xa9 &lt;north&gt; &amp; \"south\"</title>"));
    assert_non_null(strstr(svg, ">A rule &amp; words</desc>"));

    /* Every id begins with the prefix, and every reference is to one of these ids. */
    char prefix[11];
    assert_int_equal(sscanf(strstr(svg, "id=\""), "id=\"%10s", prefix), 1);
    int ids = 0, references = 0;
    for (const char *at = svg; (at = strstr(at, " id=\"")); at += 5, ids++)
        assert_memory_equal(at + 5, prefix, 10);
    for (const char *at = svg; (at = strstr(at, "#")); at++) {
        char id[64] = " id=\"";
        size_t count = strcspn(at + 1, "\")");
        assert_true(count < 40);
        strncat(id, at + 1, count);
        strcat(id, "\"");
        assert_non_null(strstr(svg, id));
        references++;
    }
    assert_true(ids >= 12);
    assert_true(references >= 12);

    /* Another drawing has another prefix. */
    struct pp_canvas *canvas = canvas_of(PP_CHART_SVG, PP_PAPER_A4, false);
    char *other = file_of(canvas, &length);
    assert_null(strstr(other, prefix));
    free(other);
    pp_canvas_destroy(canvas);

    char *complaints = through("xmllint --noout %s 2>&1", svg, strlen(svg));
    if (complaints)
        assert_string_equal(complaints, "");
    free(complaints);
    free(svg);
}

/* Cairo 1.16 compresses the drawing on a page by deflate; the size of the page is plain
 * text. */
static void pdf_page_is_of_true_size(void **state)
{
    (void)state;
    static const struct {
        enum pp_paper paper;
        bool landscape;
        double width, height;
    } rows[] = {{PP_PAPER_A5, false, 148, 210},
                {PP_PAPER_A4, true, 297, 210},
                {PP_PAPER_A3, false, 297, 420},
                {PP_PAPER_A2, true, 594, 420}};
    for (int i = 0; i < 4; i++) {
        struct pp_canvas *canvas =
            canvas_of(PP_CHART_PDF, rows[i].paper, rows[i].landscape);
        assert_near(pp_canvas_width_mm(canvas), rows[i].width, 0.0);
        assert_near(pp_canvas_height_mm(canvas), rows[i].height, 0.0);
        draw_rule(canvas);
        size_t length;
        char *pdf = file_of(canvas, &length);
        const char *box = memmem(pdf, length, "/MediaBox [", 11);
        double x, y, width, height;
        assert_non_null(box);
        assert_int_equal(
            sscanf(box, "/MediaBox [ %lf %lf %lf %lf", &x, &y, &width, &height), 4);
        assert_near(width / 72.0 * 25.4, rows[i].width, 0.1);
        assert_near(height / 72.0 * 25.4, rows[i].height, 0.1);
        free(pdf);
        pp_canvas_destroy(canvas);
    }
}

static void pdf_rule_is_100_mm_long(void **state)
{
    (void)state;
    size_t length;
    char *pdf = drawn(PP_CHART_PDF, &length);
    /* pdftocairo writes an SVG in points. */
    char *svg = through("pdftocairo -svg -noshrink -origpagesizes %s - 2>/dev/null",
                        pdf, length);
    free(pdf);
    if (!svg)
        skip();
    const char *path = strstr(svg, "stroke:rgb");
    if (!path)
        path = strstr(svg, "stroke=\"rgb");
    assert_non_null(path);
    double x0, y0, x1, y1, xx = 1.0, zero;
    assert_int_equal(
        sscanf(strstr(path, "M ") + 2, "%lf %lf L %lf %lf", &x0, &y0, &x1, &y1), 4);
    const char *matrix = strstr(path, "matrix(");
    if (matrix && matrix < strchr(path, '>'))
        assert_int_equal(sscanf(matrix, "matrix(%lf%*c%lf", &xx, &zero), 2);
    assert_near((x1 - x0) * xx / 72.0 * 25.4, 100.0, 0.1);
    free(svg);
}

static void words_in_a_pdf_can_be_searched(void **state)
{
    (void)state;
    size_t length;
    char *pdf = drawn(PP_CHART_PDF, &length);
    char *text = through("pdftotext %s - 2>/dev/null", pdf, length);
    free(pdf);
    if (!text)
        skip();
    assert_non_null(strstr(text, "Working plane"));
    free(text);
}

static void the_same_drawing_gives_the_same_bytes(void **state)
{
    (void)state;
    static const enum pp_chart_format formats[] = {PP_CHART_PDF, PP_CHART_SVG,
                                                   PP_CHART_PNG};
    for (int i = 0; i < 3; i++) {
        size_t once, twice;
        char *first = drawn(formats[i], &once);
        /* Another canvas in between changes the numbers that cairo assigns. */
        pp_canvas_destroy(canvas_of(PP_CHART_SVG, PP_PAPER_A5, true));
        char *second = drawn(formats[i], &twice);
        assert_int_equal(once, twice);
        assert_memory_equal(first, second, once);
        free(first);
        free(second);
    }
}

static void a_drawing_that_lacks_a_part_is_no_file(void **state)
{
    (void)state;
    for (int format = PP_CHART_PDF; format <= PP_CHART_PNG; format++) {
        struct pp_canvas *canvas =
            canvas_of((enum pp_chart_format)format, PP_PAPER_A5, true);
        draw_rule(canvas);
        pp_canvas_lacks_memory(pp_canvas_cairo(canvas));
        const unsigned char *bytes;
        size_t length;
        struct pp_error err = {0};
        assert_int_equal(pp_canvas_finish(canvas, &bytes, &length, &err), PP_SYSTEM);
        assert_non_null(strstr(err.message, "memory"));
        pp_canvas_destroy(canvas);
    }
}

/* IHDR has the size at bytes 16 to 23, followed by pHYs. */
static void png_has_its_size_and_resolution(void **state)
{
    (void)state;
    size_t length;
    unsigned char *png = (unsigned char *)drawn(PP_CHART_PNG, &length);
    int width = png[18] << 8 | png[19], height = png[22] << 8 | png[23];
    assert_int_equal(width, 1654); /* 210 mm at 200 dots an inch */
    assert_int_equal(height, 2339);
    assert_memory_equal(png + 37, "pHYs", 4);
    assert_int_equal(png[43] << 8 | png[44], 7874); /* dots a metre */
    char *complaints = through("pngcheck -q %s 2>&1", (char *)png, length);
    if (complaints)
        assert_null(strstr(complaints, "ERROR"));
    free(complaints);
    free(png);
}

static enum pp_status full_disk(void *closure, const unsigned char *bytes,
                                size_t length, struct pp_error *err)
{
    (void)bytes;
    *(size_t *)closure = length;
    return pp_fail(err, PP_SYSTEM, "no space left on device");
}

static void a_failure_to_write_is_handed_on(void **state)
{
    (void)state;
    struct pp_canvas *canvas = canvas_of(PP_CHART_PDF, PP_PAPER_A4, false);
    struct pp_error err;
    size_t asked = 0;
    draw_rule(canvas);
    assert_int_equal(pp_canvas_write(canvas, full_disk, &asked, &err), PP_SYSTEM);
    assert_string_equal(err.message, "no space left on device");
    assert_true(asked > 500);
    pp_canvas_destroy(canvas);
}

static void a_failed_drawing_is_not_written(void **state)
{
    (void)state;
    struct pp_canvas *canvas = canvas_of(PP_CHART_SVG, PP_PAPER_A4, false);
    struct pp_error err;
    size_t asked = 0;
    cairo_restore(pp_canvas_cairo(canvas)); /* more often than saved */
    assert_int_equal(pp_canvas_write(canvas, full_disk, &asked, &err), PP_SYSTEM);
    assert_non_null(strstr(err.message, "cannot draw the chart"));
    assert_int_equal(asked, 0);
    pp_canvas_destroy(canvas);
}

static void names_of_files_and_papers_are_understood_or_refused(void **state)
{
    (void)state;
    enum pp_chart_format format;
    enum pp_paper paper;
    struct pp_error err;
    assert_int_equal(pp_canvas_format_of(&format, "a b/room.SVG", 0), PP_OK);
    assert_int_equal(format, PP_CHART_SVG);
    assert_int_equal(pp_canvas_format_of(&format, "room.jpg", &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "room.jpg"));
    assert_int_equal(pp_canvas_format_of(&format, "pdf", 0), PP_BAD_INPUT);
    assert_int_equal(pp_canvas_paper_of(&paper, "A3", 0), PP_OK);
    assert_int_equal(paper, PP_PAPER_A3);
    assert_int_equal(pp_canvas_paper_of(&paper, "letter", &err), PP_BAD_INPUT);

    struct pp_sheet sheet = {.format = PP_CHART_PNG, .dpi = 3.0};
    struct pp_canvas *canvas;
    assert_int_equal(pp_canvas_create(&canvas, &sheet, &err), PP_BAD_INPUT);
    assert_null(canvas);
    sheet.dpi = NAN;
    assert_int_equal(pp_canvas_create(&canvas, &sheet, &err), PP_BAD_INPUT);
}

static void only_pdf_has_several_sheets(void **state)
{
    (void)state;
    struct pp_canvas *canvas = canvas_of(PP_CHART_PDF, PP_PAPER_A4, false);
    size_t length;
    draw_rule(canvas);
    assert_int_equal(pp_canvas_next_sheet(canvas, 0), PP_OK);
    draw_rule(canvas);
    char *pdf = file_of(canvas, &length);
    assert_non_null(memmem(pdf, length, "/Count 2", 8));
    free(pdf);
    pp_canvas_destroy(canvas);
    canvas = canvas_of(PP_CHART_SVG, PP_PAPER_A4, false);
    assert_int_equal(pp_canvas_next_sheet(canvas, 0), PP_BAD_INPUT);
    pp_canvas_destroy(canvas);
}

/* A drawing to be placed on a sheet: a line of 100 mm from (20, 30), closed lines
 * within a clip that begins at its edges, and a line that extends beyond the sheet. */
static struct pp_canvas *canvas_to_place(void)
{
    const struct pp_sheet sheet = {
        .width_mm = 131.7, .height_mm = 77.3, .to_place = true};
    const double left = 41.0, top = 33.8208, wide = 66.0, high = 37.0;
    struct pp_canvas *canvas;
    assert_int_equal(pp_canvas_create(&canvas, &sheet, NULL), PP_OK);
    assert_near(pp_canvas_width_mm(canvas), 131.7, 0.0);
    draw_rule(canvas);
    cairo_t *cr = pp_canvas_cairo(canvas);
    cairo_save(cr);
    cairo_rectangle(cr, left, top, wide, high);
    cairo_clip(cr);
    cairo_set_line_width(cr, 0.083);
    for (int i = 0; i < 16; i++) {
        double x = left + 0.25 * (i / 4) * wide, y = top + 0.25 * (i % 4) * high;
        double across = i % 2 ? 9.0 : 0.0, down = i % 2 ? 0.0 : 9.0;
        cairo_move_to(cr, x, y);
        cairo_line_to(cr, x + across, y + down);
        cairo_line_to(cr, x + across, y + down);
        cairo_line_to(cr, x, y);
        cairo_close_path(cr);
        cairo_stroke(cr);
    }
    cairo_restore(cr);
    cairo_move_to(cr, 100, 60);
    cairo_line_to(cr, 300, 60);
    cairo_stroke(cr);
    return canvas;
}

/* A placed drawing is not converted to pixels. */
static void a_placed_drawing_is_no_picture_of_pixels(void **state)
{
    (void)state;
    struct pp_canvas *drawing = canvas_to_place();
    for (int i = 0; i < 24; i++) {
        struct pp_canvas *sheet = canvas_of(PP_CHART_PDF, PP_PAPER_A4, false);
        size_t length;
        pp_canvas_place(sheet, drawing, 6.0 + 0.31 * i, 16.0 + 7.3 * i);
        char *pdf = file_of(sheet, &length);
        assert_null(memmem(pdf, length, "/Subtype /Image", 15));
        free(pdf);
        pp_canvas_destroy(sheet);
    }
    pp_canvas_destroy(drawing);
}

static void a_placed_drawing_keeps_its_scale_and_its_words(void **state)
{
    (void)state;
    struct pp_canvas *drawing = canvas_to_place();
    struct pp_canvas *sheet = canvas_of(PP_CHART_PDF, PP_PAPER_A4, false);
    size_t length;
    pp_canvas_place(sheet, drawing, 13.37, 101.9);
    pp_canvas_place(sheet, drawing, 13.37, 187.1);
    char *pdf = file_of(sheet, &length);
    pp_canvas_destroy(sheet);
    pp_canvas_destroy(drawing);
    char *svg = through("pdftocairo -svg -noshrink -origpagesizes %s - 2>/dev/null",
                        pdf, length);
    char *text = through("pdftotext %s - 2>/dev/null", pdf, length);
    free(pdf);
    if (!svg || !text)
        skip();
    /* Lines of 100 mm, placement to the nearest point, and text stored as text. */
    int rules = 0;
    for (const char *at = svg; (at = strstr(at, " d=\"M ")) != NULL; at++) {
        double x0, y0, x1, y1, scale = 1.0, zero;
        const char *matrix = strstr(at, "matrix(");
        if (sscanf(at + 6, "%lf %lf L %lf %lf", &x0, &y0, &x1, &y1) != 4)
            continue;
        if (matrix && matrix < strchr(at, '>'))
            assert_int_equal(sscanf(matrix, "matrix(%lf%*c%lf", &scale, &zero), 2);
        rules += fabs((x1 - x0) * scale / 72.0 * 25.4 - 100.0) < 0.1;
    }
    assert_int_equal(rules, 2);
    assert_non_null(strstr(text, "Working plane"));
    assert_non_null(strstr(strstr(text, "Working plane") + 1, "Working plane"));
    free(text);
    free(svg);
}

static void a_drawing_to_be_placed_is_no_file(void **state)
{
    (void)state;
    struct pp_canvas *drawing = canvas_to_place();
    const unsigned char *bytes;
    size_t length;
    struct pp_error err;
    assert_false(pp_canvas_has_sheets(drawing));
    assert_int_equal(pp_canvas_next_sheet(drawing, &err), PP_BAD_INPUT);
    assert_int_equal(pp_canvas_finish(drawing, &bytes, &length, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "placed"));

    /* A drawing that is incomplete for lack of memory is also incomplete after it is
     * placed. */
    struct pp_canvas *sheet = canvas_of(PP_CHART_PDF, PP_PAPER_A4, false);
    pp_canvas_lacks_memory(pp_canvas_cairo(drawing));
    pp_canvas_place(sheet, drawing, 0.0, 0.0);
    assert_int_equal(pp_canvas_finish(sheet, &bytes, &length, &err), PP_SYSTEM);
    pp_canvas_destroy(sheet);
    pp_canvas_destroy(drawing);
}

static void a_pdf_lists_its_contents(void **state)
{
    (void)state;
    struct pp_canvas *canvas = canvas_of(PP_CHART_PDF, PP_PAPER_A4, false);
    size_t length;
    draw_rule(canvas);
    pp_canvas_add_outline(canvas, 1, "Whole", 20.0);
    assert_int_equal(pp_canvas_next_sheet(canvas, NULL), PP_OK);
    draw_rule(canvas);
    pp_canvas_add_outline(canvas, 2, "Part", 20.0);
    char *pdf = file_of(canvas, &length);
    assert_non_null(memmem(pdf, length, "/Title (Whole)", 14));
    assert_non_null(memmem(pdf, length, "/Title (Part)", 13));
    free(pdf);
    pp_canvas_destroy(canvas);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(svg_is_in_millimetres_and_a_rule_is_100_mm_long),
        cmocka_unit_test(svg_has_a_title_a_description_and_ids_of_its_own),
        cmocka_unit_test(pdf_page_is_of_true_size),
        cmocka_unit_test(pdf_rule_is_100_mm_long),
        cmocka_unit_test(words_in_a_pdf_can_be_searched),
        cmocka_unit_test(the_same_drawing_gives_the_same_bytes),
        cmocka_unit_test(a_drawing_that_lacks_a_part_is_no_file),
        cmocka_unit_test(png_has_its_size_and_resolution),
        cmocka_unit_test(a_failure_to_write_is_handed_on),
        cmocka_unit_test(a_failed_drawing_is_not_written),
        cmocka_unit_test(names_of_files_and_papers_are_understood_or_refused),
        cmocka_unit_test(only_pdf_has_several_sheets),
        cmocka_unit_test(a_placed_drawing_is_no_picture_of_pixels),
        cmocka_unit_test(a_placed_drawing_keeps_its_scale_and_its_words),
        cmocka_unit_test(a_drawing_to_be_placed_is_no_file),
        cmocka_unit_test(a_pdf_lists_its_contents),
    };
    add_tests(tests, NULL, NULL);
}
