/* test_gbxml_document.c - gbXML files are read in their own encodings, and refused in words. */
#include "formats/gbxml/gbxml_document.h"

#include "tests/lib/near.h"

#define BUERO "B\xC3\xBCro" /* in UTF-8 */

/* The name of the only space of a file of those bytes; fails where there is none. */
static void space_is_called(const char *bytes, size_t length, const char *expected)
{
    struct pp_gbxml_document document;
    struct pp_error err = {0};
    if (pp_gbxml_document_parse(&document, bytes, length, "a.xml", &err) != PP_OK)
        fail_msg("%s", err.message);
    const struct pp_gbxml_element *name =
        pp_gbxml_document_path(document.root, "Campus/Space/Name");
    assert_non_null(name);
    assert_string_equal(pp_gbxml_document_text(name), expected);
    pp_gbxml_document_clear(&document);
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

static void what_is_no_gbxml_is_refused_in_words(void **state)
{
    (void)state;
    static const struct {
        const char *bytes, *words;
    } files[] = {
        {"<gbXML>\n<Campus>",
         "a.xml:2: the file is not well-formed XML: it breaks off"},
        {"<gbXML>\n</Campus></gbXML>",
         "a.xml:2: the file is not well-formed XML: mismatched tag"},
        {"", "a.xml:1: the file is not well-formed XML: no element found"},
        {"<!DOCTYPE gbXML [<!ENTITY a 'b'>]><gbXML>&a;</gbXML>",
         "a.xml: a DOCTYPE is not allowed in a gbXML file; leave it out"},
        {"<room/>", "a.xml: its outermost element is \"room\"; expected gbXML"},
        {FILE_OF("klingon", "a"), "a.xml:1: the file is not well-formed XML: unknown"},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct pp_gbxml_document document;
        struct pp_error err = {0};
        assert_int_equal(pp_gbxml_document_parse(&document, files[i].bytes,
                                                 strlen(files[i].bytes), "a.xml", &err),
                         PP_BAD_INPUT);
        if (!strstr(err.message, files[i].words))
            fail_msg("\"%s\" does not say \"%s\"", err.message, files[i].words);
        assert_null(document.root);
    }
}

/* Prefixes, namespaces, and text that other elements divide. */
static void elements_are_found_by_their_names(void **state)
{
    (void)state;
    static const char bytes[] =
        "<g:gbXML xmlns:g='http://www.gbxml.org/schema'>\n"
        "<g:Area g:unit='SquareMeters'> 12.5 <g:Note/> 13 </g:Area>\n"
        "<Area>\n</Area><Volume>3</Volume></g:gbXML>";
    struct pp_gbxml_document document;
    struct pp_error err = {0};
    assert_int_equal(
        pp_gbxml_document_parse(&document, bytes, sizeof bytes - 1, "a.xml", &err),
        PP_OK);
    const struct pp_gbxml_element *area =
        pp_gbxml_document_child(document.root, "Area");
    double value;
    assert_true(pp_gbxml_document_number(area, &value));
    assert_near(value, 12.5, 0.0);
    assert_int_equal(area->line, 2);
    assert_string_equal(pp_gbxml_document_attribute(area, "unit"), "SquareMeters");
    assert_null(pp_gbxml_document_attribute(area, "id"));
    const struct pp_gbxml_element *other = pp_gbxml_document_next(area, "Area");
    assert_int_equal(other->line, 3);
    assert_null(pp_gbxml_document_text(other));
    assert_false(pp_gbxml_document_number(other, &value));
    assert_null(pp_gbxml_document_next(other, "Area"));
    assert_null(pp_gbxml_document_path(document.root, "Area/Note/Nothing"));
    pp_gbxml_document_clear(&document);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_file_has_the_encoding_that_it_names),
        cmocka_unit_test(what_is_no_gbxml_is_refused_in_words),
        cmocka_unit_test(elements_are_found_by_their_names),
    };
    add_tests(tests, NULL, NULL);
}
