/* test_gbxml_document.c - gbXML files in various encodings are read, or rejected with a
 * reason. */
#include "formats/gbxml/gbxml_document.h"

#include <stdlib.h>
#include <string.h>

#include "tests/lib/near.h"

#define BUERO "B\xC3\xBCro" /* in UTF-8 */

/* Asserts the name of the only space in a file of these bytes. */
static void space_is_called(const char *bytes, size_t length, const char *expected)
{
    struct pp_xml document;
    struct pp_error err = {0};
    if (pp_gbxml_document_parse(&document, bytes, length, "a.xml", &err) != PP_OK)
        fail_msg("%s", err.message);
    const struct pp_xml_element *name =
        pp_gbxml_document_path(document.root, "Campus/Space/Name");
    assert_non_null(name);
    assert_string_equal(pp_gbxml_document_text(name), expected);
    pp_xml_clear(&document);
}

#define FILE_OF(encoding, name)                                                        \
    "<?xml version=\"1.0\" encoding=\"" encoding                                       \
    "\"?>\n<gbXML><Campus><Space><Name> " name "\n</Name></Space></Campus></gbXML>"

static void a_file_has_the_encoding_that_it_names(void **state)
{
    (void)state;
    static const char *const files[] = {
        FILE_OF("UTF-8", BUERO),
        FILE_OF("ISO-8859-1", "B\xFCro"),
        FILE_OF("windows-1252", "B\xFCro"),
        FILE_OF("US-ASCII", "B&#xFC;ro"),
        FILE_OF("UTF-8", "<!-- of -->" BUERO),
        FILE_OF("UTF-8", "<![CDATA[" BUERO "]]>"),
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        space_is_called(files[i], strlen(files[i]), BUERO);
    space_is_called(FILE_OF("windows-1252", "\x80"),
                    sizeof FILE_OF("windows-1252", "\x80") - 1, "\xE2\x82\xAC");

    static const char text[] = FILE_OF("UTF-16", "B\xFCro");
    for (int big = 0; big < 2; big++) {
        char wide[2 * sizeof text] = {0};
        wide[big] = '\xFF';
        wide[1 - big] = '\xFE';
        for (size_t i = 0; i < sizeof text - 1; i++)
            wide[2 + 2 * i + (size_t)big] = text[i];
        space_is_called(wide, 2 * sizeof text, BUERO);
    }
}

static void utf8_that_is_declared_as_utf16_is_read_as_utf8(void **state)
{
    (void)state;
    static const char *const files[] = {FILE_OF("utf-16", BUERO),
                                        FILE_OF("UTF-16LE", BUERO),
                                        "\xEF\xBB\xBF" FILE_OF("utf-16", BUERO)};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        space_is_called(files[i], strlen(files[i]), BUERO);
}

static void is_read(const char *bytes, size_t length)
{
    struct pp_xml document;
    struct pp_error err = {0};
    if (pp_gbxml_document_parse(&document, bytes, length, "a.xml", &err) != PP_OK)
        fail_msg("%s", err.message);
    pp_xml_clear(&document);
}

static void is_refused(const char *bytes, size_t length, const char *words)
{
    struct pp_xml document;
    struct pp_error err = {0};
    assert_int_equal(pp_gbxml_document_parse(&document, bytes, length, "a.xml", &err),
                     PP_BAD_INPUT);
    if (!strstr(err.message, words))
        fail_msg("\"%s\" does not say \"%s\"", err.message, words);
    assert_null(document.root);
}

static void files_other_than_gbxml_are_refused_in_words(void **state)
{
    (void)state;
    static const struct {
        const char *bytes, *words;
    } files[] = {
        {"<gbXML>\n<Campus>",
         "a.xml:2: the file ends inside the <Campus> that begins on line 2; "
         "expected </Campus>"},
        {"<gbXML>\n<Campus id='a", "a.xml:2: the file ends inside the tag"},
        {"<gbXML>\n</Campus></gbXML>", "a.xml:2: there is </Campus>; expected </gbXML> "
                                       "to close the element on line 1"},
        {"", "a.xml:1: the file is empty; expected a <gbXML>"},
        {"v 1 2 3", "a.xml:1: this is not XML; expected a <gbXML>"},
        {"<!DOCTYPE gbXML [<!ENTITY a 'b'>]><gbXML>&a;</gbXML>",
         "a.xml:1: a DOCTYPE is not allowed in a gbXML file; leave it out"},
        {"<?xml version='1.0'?>\n<!DOCTYPE gbXML SYSTEM "
         "'file:///etc/passwd'>\n<gbXML/>",
         "a.xml:2: a DOCTYPE is not allowed"},
        {"<gbXML>\n&a;</gbXML>", "a.xml:2: the entity &a; is unknown"},
        {"\n<room/>", "a.xml:2: the outermost element is <room>; expected <gbXML>"},
        {FILE_OF("klingon", "a"), "a.xml:1: the encoding \"klingon\" is unknown"},
        {FILE_OF("UTF-8", "B\xFCro"), "a.xml:2: byte 0xFC is not UTF-8"},
        {FILE_OF("US-ASCII", "B\xFCro"), "a.xml:2: some bytes are not US-ASCII"},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        is_refused(files[i].bytes, strlen(files[i].bytes), files[i].words);
    is_refused("<gbXML>\n\0</gbXML>", 17, "a.xml:2: there is a NUL byte");
    is_refused("\xFF\xFE<\0g\0/", 7, "a.xml:1: some bytes are not UTF-16LE");
    is_refused("\xFE\xFF\0<\xD8\0\0a", 8, "a.xml:1: some bytes are not UTF-16BE");
}

/* Each is processed quickly; a long tag or thousands of errors could take minutes. */
static void bulk_is_read_or_refused_with_its_line(void **state)
{
    (void)state;
    static const struct {
        const char *head, *unit, *tail, *words; /* no words: the file is read */
    } bulk[] = {
        {"<gbXML>\n", "<a>", "",
         "a.xml:2: elements are nested more than 64 levels deep"},
        {"<gbXML>\n<a ", "b='c' ", "/></gbXML>", "a.xml:2: a tag of more than 65536"},
        {"<gbXML>\n<a b='", "c", "'/></gbXML>", "a.xml:2: a tag of more than 65536"},
        {"<gbXML>\n<!-- ", "c", " --></gbXML>", NULL},
        {"<gbXML><Name>", "c", "</Name></gbXML>", NULL},
        {"<gbXML>", "<Name/>", "</gbXML>", NULL},
        {"<gbXML>", "\n", "</Campus>",
         "a.xml:10999985: there is </Campus>; expected </gbXML>"},
        {"<gbXML>\n<a>", "&", "</a></gbXML>", "a.xml:2: expected a name"},
        {"<!DOCTYPE gbXML [", "<!ENTITY a 'b'>", "]><gbXML/>", "a.xml:1: a DOCTYPE"},
    };
    enum { SIZE = 11000000 };
    char *text = malloc(SIZE + 1);
    assert_non_null(text);
    for (size_t i = 0; i < sizeof bulk / sizeof *bulk; i++) {
        size_t unit = strlen(bulk[i].unit), tail = strlen(bulk[i].tail);
        char *p = stpcpy(text, bulk[i].head);
        for (; (size_t)(p - text) + unit + tail <= SIZE; p += unit)
            memcpy(p, bulk[i].unit, unit);
        p = stpcpy(p, bulk[i].tail);
        if (bulk[i].words)
            is_refused(text, (size_t)(p - text), bulk[i].words);
        else
            is_read(text, (size_t)(p - text));
    }
    free(text);
}

/* Prefixes, namespaces, and text interrupted by other elements. */
static void elements_are_found_by_their_names(void **state)
{
    (void)state;
    static const char bytes[] =
        "<g:gbXML xmlns:g='http://www.gbxml.org/schema'>\n"
        "<g:Area g:unit='SquareMeters' name='a &amp;amp; &#38;#38; "
        "&#x26;&lt;&#10;&quot;'> 12.5 <g:Note/> 13 </g:Area>\n"
        "<Area>\n</Area><Volume>3</Volume></g:gbXML>";
    struct pp_xml document;
    struct pp_error err = {0};
    assert_int_equal(
        pp_gbxml_document_parse(&document, bytes, sizeof bytes - 1, "a.xml", &err),
        PP_OK);
    const struct pp_xml_element *area = pp_gbxml_document_child(document.root, "Area");
    double value;
    assert_true(pp_gbxml_document_number(area, &value));
    assert_near(value, 12.5, 0.0);
    assert_int_equal(area->line, 2);
    assert_string_equal(pp_gbxml_document_attribute(area, "unit"), "SquareMeters");
    assert_string_equal(pp_gbxml_document_attribute(area, "name"),
                        "a &amp; &#38; &<\n\"");
    assert_null(pp_gbxml_document_attribute(area, "id"));
    const struct pp_xml_element *other = pp_gbxml_document_next(area, "Area");
    assert_int_equal(other->line, 3);
    assert_null(pp_gbxml_document_text(other));
    assert_false(pp_gbxml_document_number(other, &value));
    assert_null(pp_gbxml_document_next(other, "Area"));
    assert_null(pp_gbxml_document_path(document.root, "Area/Note/Nothing"));
    pp_xml_clear(&document);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_file_has_the_encoding_that_it_names),
        cmocka_unit_test(utf8_that_is_declared_as_utf16_is_read_as_utf8),
        cmocka_unit_test(files_other_than_gbxml_are_refused_in_words),
        cmocka_unit_test(bulk_is_read_or_refused_with_its_line),
        cmocka_unit_test(elements_are_found_by_their_names),
    };
    add_tests(tests, NULL, NULL);
}
