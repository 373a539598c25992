/* test_document_html.c - a document as an HTML page: all its text, in order and
 * escaped. */
#include <stdio.h>
#include <stdlib.h>

#include "reports/page/document_html.h"
#include "tests/lib/near.h"

/* The page; the caller frees it. */
static char *page_of(const struct pp_document *document,
                     const struct pp_svg_picture *pictures)
{
    char *bytes;
    size_t length;
    FILE *out = open_memstream(&bytes, &length);
    assert_non_null(out);
    assert_int_equal(pp_document_status(document, NULL), PP_OK);
    pp_document_html(document, "A & <b>", pictures, out);
    fclose(out);
    return bytes;
}

static int count_of(const char *page, const char *words)
{
    int count = 0;
    for (const char *at = page; (at = strstr(at, words)) != NULL; at++)
        count++;
    return count;
}

/* Asserts that the page contains the words in this order; NULL ends the list. */
static void assert_order(const char *page, const char *const *words)
{
    const char *at = page;
    for (; *words; words++) {
        const char *found = strstr(at, *words);
        if (!found)
            fail_msg("no \"%s\" behind what is before it", *words);
        at = found + strlen(*words);
    }
}

static void text_is_in_the_order_of_the_document(void **state)
{
    (void)state;
    struct pp_document document = {0};
    pp_document_heading(&document, 1, "Caf\xc3\xa9 <i>%d</i>", 7);
    pp_document_paragraph(&document, PP_TONE_VERDICT, "3 met & 2 not");
    pp_document_heading(&document, 2, "Study");
    pp_document_table(&document);
    pp_document_column(&document, PP_COLUMN_LABELS, "by");
    pp_document_column(&document, PP_COLUMN_NUMBERS, "average, %%");
    pp_document_column(&document, PP_COLUMN_WORDS, "verdict");
    pp_document_row(&document, PP_ROW_GROUP);
    pp_document_cell(&document, PP_TONE_PLAIN, "group");
    pp_document_row(&document, PP_ROW_REMARK);
    pp_document_cell(&document, PP_TONE_SOFT, "remark");
    pp_document_row(&document, PP_ROW_CELLS);
    pp_document_cell(&document, PP_TONE_PLAIN, "exact");
    pp_document_note(&document, "a note");
    pp_document_cell(&document, PP_TONE_PLAIN, "%.2f", 2.47);
    pp_document_cell(&document, PP_TONE_BAD, "not met");
    pp_document_heading(&document, 2, "Bedroom");
    pp_document_picture(&document, 1, "Plan <1:50>");
    static const char svg[] = "<?xml version=\"1.0\"?>\n<svg id=\"x\"></svg>\n";
    const struct pp_svg_picture pictures[] = {{"", 0}, {svg, sizeof svg - 1}};
    char *page = page_of(&document, pictures);
    static const char *const order[] = {
        "<title>A &amp; &lt;b&gt;</title>",
        "<h1>Caf\xc3\xa9 &lt;i&gt;7&lt;/i&gt;</h1>",
        "<p class=\"verdict\">3 met &amp; 2 not</p>",
        "<section>\n<h2 id=\"chapter-1\">Study</h2>",
        "<thead><tr><th class=\"w\">by</th><th>average, %</th><th class=\"w\">verdict",
        "colspan=\"3\">group</th>",
        "colspan=\"3\">remark</td>",
        "<td class=\"l\">exact<br><span class=\"soft\">a note</span></td>",
        "<td>2.47</td>",
        "<td class=\"w bad\">not met</td>",
        "</section>\n<section>\n<h2 id=\"chapter-2\">Bedroom</h2>",
        "<figure><svg id=\"x\"></svg>\n<figcaption>Plan &lt;1:50&gt;</figcaption>",
        "</section>\n</body>",
        NULL};
    assert_order(page, order);
    assert_null(strstr(page, "<?xml"));
    free(page);
    pp_document_clear(&document);
}

static void a_table_without_headings_has_no_head_and_short_rows_are_filled(void **state)
{
    (void)state;
    struct pp_document document = {0};
    pp_document_table(&document);
    for (int i = 0; i < 3; i++)
        pp_document_column(&document, PP_COLUMN_WORDS, "%s", "");
    pp_document_row(&document, PP_ROW_CELLS);
    pp_document_cell(&document, PP_TONE_PLAIN, "alone");
    pp_document_row(&document, PP_ROW_CELLS);
    char *page = page_of(&document, NULL);
    assert_null(strstr(page, "<thead>"));
    assert_int_equal(count_of(page, "<td"), 6);
    assert_int_equal(count_of(page, "<td></td>"), 5);
    free(page);
    pp_document_clear(&document);
}

static void add_text(void *closure, const char *text)
{
    strcat(closure, text);
    strcat(closure, "|");
}

static void every_text_is_reported_once(void **state)
{
    (void)state;
    struct pp_document document = {0};
    char all[128] = "";
    pp_document_heading(&document, 3, "[WW23]");
    pp_document_table(&document);
    pp_document_column(&document, PP_COLUMN_WORDS, "head");
    pp_document_row(&document, PP_ROW_CELLS);
    pp_document_cell(&document, PP_TONE_PLAIN, "cell");
    pp_document_note(&document, "note");
    pp_document_paragraph(&document, PP_TONE_SOFT, "end");
    pp_document_texts(&document, add_text, all);
    assert_string_equal(all, "[WW23]|head|cell|note|end|");
    pp_document_clear(&document);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(text_is_in_the_order_of_the_document),
        cmocka_unit_test(
            a_table_without_headings_has_no_head_and_short_rows_are_filled),
        cmocka_unit_test(every_text_is_reported_once),
    };
    add_tests(tests, NULL, NULL);
}
