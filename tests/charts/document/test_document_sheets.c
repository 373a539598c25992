/* test_document_sheets.c - a document on sheets of A4, read back with pdftotext: no
 * text is lost or cut between sheets. */
#include <stdio.h>
#include <stdlib.h>

#include "charts/document/document_sheets.h"
#include "tests/lib/near.h"
#include "tests/lib/through.h"

enum { SHEETS_MOST = 24 };

/* Text of each sheet. */
struct sheets {
    char *text;
    const char *list[SHEETS_MOST];
    int count;
};

static char *pdf_of(const struct pp_document *document,
                    struct pp_canvas *const *pictures, size_t *length)
{
    const struct pp_sheet sheet = {.format = PP_CHART_PDF, .title = "Test"};
    struct pp_canvas *canvas;
    const unsigned char *bytes;
    struct pp_error err = {0};
    assert_int_equal(pp_document_status(document, NULL), PP_OK);
    assert_int_equal(pp_canvas_create(&canvas, &sheet, &err), PP_OK);
    if (pp_document_sheets_draw(canvas, document, "Corner house", pictures, &err)
            != PP_OK
        || pp_canvas_finish(canvas, &bytes, length, &err) != PP_OK)
        fail_msg("%s", err.message);
    char *pdf = malloc(*length);
    memcpy(pdf, bytes, *length);
    pp_canvas_destroy(canvas);
    return pdf;
}

/* No sheets if pdftotext is not installed. */
static struct sheets sheets_of(const struct pp_document *document)
{
    struct sheets sheets = {0};
    size_t length;
    char *pdf = pdf_of(document, NULL, &length);
    sheets.text = through("pdftotext %s - 2>/dev/null", pdf, length);
    free(pdf);
    for (char *at = sheets.text; at && *at;) {
        char *end = strchr(at, '\f');
        assert_true(sheets.count < SHEETS_MOST);
        sheets.list[sheets.count++] = at;
        if (end)
            *end++ = '\0';
        at = end;
    }
    return sheets;
}

static bool has(const struct sheets *sheets, int sheet, const char *words)
{
    return strstr(sheets->list[sheet], words) != NULL;
}

/* Number of sheets that contain the words. */
static int sheets_with(const struct sheets *sheets, const char *words)
{
    int count = 0;
    for (int i = 0; i < sheets->count; i++)
        count += has(sheets, i, words);
    return count;
}

static void put_table(struct pp_document *document, int rows)
{
    pp_document_table(document);
    pp_document_column(document, PP_COLUMN_WORDS, "window");
    pp_document_column(document, PP_COLUMN_NUMBERS, "existing, %%");
    for (int i = 0; i < rows; i++) {
        if (i == 0 || i == rows - 4) {
            pp_document_row(document, PP_ROW_GROUP);
            pp_document_cell(document, PP_TONE_PLAIN, i ? "Gardens" : "Sunlight");
        }
        pp_document_row(document, PP_ROW_CELLS);
        pp_document_cell(document, PP_TONE_PLAIN, "row-%03d.", i);
        pp_document_note(document, "of two lines");
        pp_document_cell(document, PP_TONE_PLAIN, "%.2f", 0.17 * i);
    }
}

static void a_table_over_sheets_repeats_its_head_and_has_every_row_once(void **state)
{
    (void)state;
    enum { ROWS = 153 };
    struct pp_document document = {0};
    pp_document_heading(&document, 1, "Site");
    put_table(&document, ROWS);
    struct sheets sheets = sheets_of(&document);
    pp_document_clear(&document);
    if (!sheets.text)
        skip();
    assert_true(sheets.count >= 4);
    assert_int_equal(sheets_with(&sheets, "existing, %"), sheets.count);
    assert_int_equal(sheets_with(&sheets, "Sunlight"), sheets.count);
    assert_int_equal(sheets_with(&sheets, "Gardens"), 1);
    for (int i = 0; i < ROWS; i++) {
        char row[32];
        snprintf(row, sizeof row, "row-%03d.", i);
        assert_int_equal(sheets_with(&sheets, row), 1);
    }
    for (int i = 0; i < sheets.count; i++) {
        char page[32];
        snprintf(page, sizeof page, "page %d of %d\n", i + 1, sheets.count);
        assert_true(has(&sheets, i, page));
        assert_true(has(&sheets, i, "Corner house"));
    }
    free(sheets.text);
}

/* Some of these tables are one row too long for a sheet. */
static void the_last_row_of_a_table_is_not_alone_on_a_sheet(void **state)
{
    (void)state;
    int broken = 0;
    for (int rows = 44; rows < 64; rows++) {
        struct pp_document document = {0};
        char last[32], before[32];
        pp_document_table(&document);
        pp_document_column(&document, PP_COLUMN_WORDS, "window");
        for (int i = 0; i < rows; i++) {
            pp_document_row(&document, PP_ROW_CELLS);
            pp_document_cell(&document, PP_TONE_PLAIN, "row-%03d.", i);
        }
        struct sheets sheets = sheets_of(&document);
        pp_document_clear(&document);
        if (!sheets.text)
            skip();
        snprintf(last, sizeof last, "row-%03d.", rows - 1);
        snprintf(before, sizeof before, "row-%03d.", rows - 2);
        assert_true(has(&sheets, sheets.count - 1, last));
        assert_true(has(&sheets, sheets.count - 1, before));
        broken += sheets.count > 1;
        free(sheets.text);
    }
    assert_in_range(broken, 1, 19);
}

static void a_table_without_rows_has_a_head(void **state)
{
    (void)state;
    struct pp_document document = {0};
    pp_document_table(&document);
    pp_document_column(&document, PP_COLUMN_WORDS, "window");
    struct sheets sheets = sheets_of(&document);
    pp_document_clear(&document);
    if (!sheets.text)
        skip();
    assert_int_equal(sheets.count, 1);
    assert_true(has(&sheets, 0, "window"));
    free(sheets.text);
}

/* For any text above it, a heading is on the same sheet as the text that follows: a
 * paragraph, or the header of a table and its first row. */
static void no_heading_is_the_last_of_a_sheet(void **state)
{
    (void)state;
    for (int lines = 44; lines < 60; lines++) {
        struct pp_document document = {0};
        for (int i = 0; i < lines; i++)
            pp_document_paragraph(&document, PP_TONE_PLAIN, "line %d", i);
        pp_document_heading(&document, 3, "Heading");
        if (lines % 2)
            pp_document_paragraph(&document, PP_TONE_PLAIN, "An introduction");
        pp_document_table(&document);
        pp_document_column(&document, PP_COLUMN_WORDS, "what");
        pp_document_row(&document, PP_ROW_GROUP);
        pp_document_cell(&document, PP_TONE_PLAIN, "group");
        pp_document_row(&document, PP_ROW_CELLS);
        pp_document_cell(&document, PP_TONE_PLAIN, "first-row");
        struct sheets sheets = sheets_of(&document);
        pp_document_clear(&document);
        if (!sheets.text)
            skip();
        for (int i = 0; i < sheets.count; i++) {
            assert_int_equal(has(&sheets, i, "Heading"), has(&sheets, i, "first-row"));
            assert_int_equal(has(&sheets, i, "group"), has(&sheets, i, "first-row"));
        }
        assert_int_equal(sheets_with(&sheets, "first-row"), 1);
        free(sheets.text);
    }
}

static void a_chapter_begins_a_sheet_unless_most_of_one_is_left(void **state)
{
    (void)state;
    static const struct {
        int lines, sheets;
    } rows[] = {{8, 1}, {30, 2}};
    for (int k = 0; k < 2; k++) {
        struct pp_document document = {0};
        for (int i = 0; i < rows[k].lines; i++)
            pp_document_paragraph(&document, PP_TONE_PLAIN, "line %d", i);
        pp_document_heading(&document, 2, "Bedroom");
        pp_document_paragraph(&document, PP_TONE_PLAIN, "its text");
        struct sheets sheets = sheets_of(&document);
        pp_document_clear(&document);
        if (!sheets.text)
            skip();
        assert_int_equal(sheets.count, rows[k].sheets);
        assert_true(has(&sheets, sheets.count - 1, "Bedroom"));
        assert_true(has(&sheets, sheets.count - 1, "its text"));
        free(sheets.text);
    }
}

/* Very long names and cells, of one word or many, and more columns than fit stay on
 * their sheets. */
static void long_text_is_broken_or_cut_within_the_sheet(void **state)
{
    (void)state;
    enum { LONG = 7000, COLUMNS = 20 };
    char *word = malloc(LONG + 1);
    memset(word, 'w', LONG);
    word[LONG] = '\0';
    struct pp_document document = {0};
    pp_document_heading(&document, 1, "%s", word);
    for (int i = 0; i < LONG; i += 7)
        word[i] = ' ';
    pp_document_paragraph(&document, PP_TONE_CODE, "%s", word);
    pp_document_table(&document);
    for (int i = 0; i < COLUMNS; i++)
        pp_document_column(&document, (enum pp_document_column_kind)(i % 3), "head %d",
                           i);
    for (int k = 0; k < 3; k++) {
        pp_document_row(&document, PP_ROW_CELLS);
        for (int i = 0; i < COLUMNS; i++)
            pp_document_cell(&document, PP_TONE_PLAIN, "%s", i % 3 ? "3.17" : word);
        pp_document_row(&document, PP_ROW_GROUP);
        pp_document_cell(&document, PP_TONE_PLAIN, "%s", word);
    }
    pp_document_paragraph(&document, PP_TONE_PLAIN, "the end");
    struct sheets sheets = sheets_of(&document);
    pp_document_clear(&document);
    free(word);
    if (!sheets.text)
        skip();
    assert_true(sheets.count <= 5);
    assert_int_equal(sheets_with(&sheets, "the end"), 1);
    free(sheets.text);
}

static void pictures_go_two_on_a_sheet_at_true_scale(void **state)
{
    (void)state;
    struct pp_sheet sheet = pp_document_sheets_picture();
    struct pp_canvas *picture;
    struct pp_document document = {0};
    size_t length, again;
    sheet.to_place = true;
    assert_int_equal(pp_canvas_create(&picture, &sheet, NULL), PP_OK);
    cairo_t *cr = pp_canvas_cairo(picture);
    cairo_set_line_width(cr, 0.3);
    cairo_move_to(cr, 11.3, 11.7);
    cairo_line_to(cr, 11.3 + 150.0, 11.7);
    cairo_stroke(cr);
    for (int i = 0; i < 4; i++)
        pp_document_picture(&document, 0, "A rule");
    char *pdf = pdf_of(&document, &picture, &length);
    assert_non_null(memmem(pdf, length, "/Count 2", 8));
    char *same = pdf_of(&document, &picture, &again);
    assert_int_equal(length, again);
    assert_memory_equal(pdf, same, length);
    pp_canvas_destroy(picture);
    pp_document_clear(&document);
    char *svg = through("pdftocairo -svg -f 2 -l 2 -noshrink -origpagesizes %s - "
                        "2>/dev/null",
                        pdf, length);
    free(same);
    free(pdf);
    if (!svg)
        skip();
    int rules = 0;
    for (const char *at = svg; (at = strstr(at, " d=\"M ")) != NULL; at++) {
        double x0, y0, x1, y1, scale = 1.0, zero;
        const char *matrix = strstr(at, "matrix(");
        if (sscanf(at + 6, "%lf %lf L %lf %lf", &x0, &y0, &x1, &y1) != 4)
            continue;
        if (matrix && matrix < strchr(at, '>'))
            assert_int_equal(sscanf(matrix, "matrix(%lf%*c%lf", &scale, &zero), 2);
        rules += fabs((x1 - x0) * scale / 72.0 * 25.4 - 150.0) < 0.1;
    }
    assert_int_equal(rules, 2);
    free(svg);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_table_over_sheets_repeats_its_head_and_has_every_row_once),
        cmocka_unit_test(the_last_row_of_a_table_is_not_alone_on_a_sheet),
        cmocka_unit_test(a_table_without_rows_has_a_head),
        cmocka_unit_test(no_heading_is_the_last_of_a_sheet),
        cmocka_unit_test(a_chapter_begins_a_sheet_unless_most_of_one_is_left),
        cmocka_unit_test(long_text_is_broken_or_cut_within_the_sheet),
        cmocka_unit_test(pictures_go_two_on_a_sheet_at_true_scale),
    };
    add_tests(tests, NULL, NULL);
}
