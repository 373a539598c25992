/* test_room_text.c - room files with some windows changed: all other text is
 * unchanged. */
#include <stdio.h>
#include <stdlib.h>

#include "model/room/text/room_text.h"
#include "tests/lib/near.h"

/* Text that resembles a window, quotes of both kinds, a tag over two lines, an element
 * that is not empty, and a last one on a line with others. */
static const char file[] =
    "<?xml version='1.0'?> <!-- <window left='9'/> -->\n"
    "<room version=\"1\" name=\"a > b &lt;window\">\n"
    "  <plan width='4.1' depth='5.3' height='2.7'/>\n"
    "  <window wall=\"south\" left = '0.40' sill=\"0.9\"\n"
    "          width=\"1.10\" height='1.2' glazing=\"clear-double\"/>  <!-- one -->\n"
    "  <rooflight x=\"1\" y=\"2\" width=\"0.7\" depth=\"0.8\"></rooflight>\n"
    "  <window wall='north' left='1' sill='1' width='1' height='1' ><!-- </window> "
    "--></window><point x='1' y='1'/>\n"
    "</room>\n";

static char *edited(const struct pp_text_edit *edits, int count)
{
    char *changed;
    size_t length;
    struct pp_error err;
    assert_int_equal(
        pp_room_text_edit(&changed, &length, file, strlen(file), edits, count, &err),
        PP_OK);
    assert_int_equal(length, strlen(changed));
    return changed;
}

/* Asserts that one passage of the file is replaced by another. */
static void assert_replaced(const char *changed, const char *was, const char *is)
{
    char expected[2048];
    const char *at = strstr(file, was);
    assert_non_null(at);
    snprintf(expected, sizeof expected, "%.*s%s%s", (int)(at - file), file, is,
             at + strlen(was));
    assert_string_equal(changed, expected);
}

static void without_edits_the_text_is_the_file_s(void **state)
{
    (void)state;
    char *changed = edited(NULL, 0);
    assert_string_equal(changed, file);
    free(changed);
}

static void a_place_is_written_into_the_tag_and_figures_that_stay_are_not_touched(
    void **state)
{
    (void)state;
    const struct pp_text_edit edit = {
        PP_TEXT_SET, 0, {0.35, 1.2000000000000002, 0.9, 1.2}};
    char *changed = edited(&edit, 1);
    assert_replaced(changed, "left = '0.40' sill=\"0.9\"\n          width=\"1.10\"",
                    "left = '0.35' sill=\"0.9\"\n          width=\"1.2\"");
    free(changed);
}

static void a_rooflight_has_x_y_and_depth(void **state)
{
    (void)state;
    const struct pp_text_edit edit = {PP_TEXT_SET, 1, {1.25, 0.7, 2.5, 0.3}};
    char *changed = edited(&edit, 1);
    assert_replaced(changed, "x=\"1\" y=\"2\" width=\"0.7\" depth=\"0.8\"",
                    "x=\"1.25\" y=\"2.5\" width=\"0.7\" depth=\"0.3\"");
    free(changed);
}

static void one_more_stands_on_a_line_of_its_own_with_the_same_indent(void **state)
{
    (void)state;
    const struct pp_text_edit edit = {PP_TEXT_ADD, 0, {2.5, 1.1, 0.9, 1.2}};
    char *changed = edited(&edit, 1);
    assert_replaced(changed, "glazing=\"clear-double\"/>",
                    "glazing=\"clear-double\"/>\n"
                    "  <window wall=\"south\" left = '2.5' sill=\"0.9\"\n"
                    "          width=\"1.10\" height='1.2' glazing=\"clear-double\"/>");
    free(changed);
}

static void one_left_out_takes_its_line_with_it(void **state)
{
    (void)state;
    const struct pp_text_edit edit = {.kind = PP_TEXT_REMOVE, .opening = 1};
    char *changed = edited(&edit, 1);
    assert_replaced(
        changed,
        "  <rooflight x=\"1\" y=\"2\" width=\"0.7\" depth=\"0.8\"></rooflight>\n", "");
    free(changed);
}

static void what_shares_its_line_stays(void **state)
{
    (void)state;
    const struct pp_text_edit edit = {.kind = PP_TEXT_REMOVE, .opening = 2};
    char *changed = edited(&edit, 1);
    assert_replaced(changed,
                    "<window wall='north' left='1' sill='1' width='1' height='1' ><!-- "
                    "</window> --></window>",
                    "");
    free(changed);
}

static void several_edits_are_made_at_once(void **state)
{
    (void)state;
    const struct pp_text_edit edits[] = {{PP_TEXT_SET, 0, {0.5, 1.1, 0.9, 1.2}},
                                         {PP_TEXT_ADD, 0, {2.5, 1.1, 0.9, 1.2}},
                                         {PP_TEXT_REMOVE, 1, {0, 0, 0, 0}},
                                         {PP_TEXT_SET, 2, {1, 1, 1, 1.5}}};
    char *changed = edited(edits, 4);
    assert_non_null(strstr(changed, "left = '0.5'"));
    assert_non_null(strstr(changed, "left = '2.5'"));
    assert_null(strstr(changed, "rooflight"));
    assert_non_null(strstr(changed, "sill='1' width='1' height='1.5' >"));
    free(changed);
}

static void an_element_is_given_by_itself(void **state)
{
    (void)state;
    const struct pp_text_edit edit = {PP_TEXT_SET, 2, {1, 1, 0.75, 1}};
    char *element;
    struct pp_error err;
    assert_int_equal(pp_room_text_element(&element, file, strlen(file), &edit, &err),
                     PP_OK);
    assert_string_equal(
        element, "<window wall='north' left='1' sill='0.75' width='1' height='1' >");
    free(element);
}

/* Both pictures of a sky are found, in any order. */
static void a_file_that_moves_finds_its_pictures_and_outlines(void **state)
{
    (void)state;
    static const char text[] =
        "<room><sky second='b.hdr' type='picture' file='a.hdr'/><outline file='c.csv'/>"
        "</room>";
    char *moved;
    size_t length;
    assert_int_equal(
        pp_room_text_move(&moved, &length, text, strlen(text), "../", NULL), PP_OK);
    assert_string_equal(moved, "<room><sky second='../b.hdr' type='picture' "
                               "file='../a.hdr'/><outline file='../c.csv'/></room>");
    free(moved);
}

/* Only relative paths of meshes are changed: not absolute paths, other elements or
 * comments. Special characters in a folder's name are escaped. */
static void a_file_that_moves_finds_its_meshes(void **state)
{
    (void)state;
    static const char text[] =
        "<room version='1'><!-- <mesh file='no.obj'/> --><mesh file='a &amp; b.obj'/>\n"
        "<mesh name=\"file='x'\"\n file=\"sub/c.dxf\" x='1'/><meshes file='d'/>"
        "<mesh file='/root.obj'/></room>";
    static const char wanted[] =
        "<room version='1'><!-- <mesh file='no.obj'/> -->"
        "<mesh file='../Tom&#39;s &#38; &#60;/a &amp; b.obj'/>\n"
        "<mesh name=\"file='x'\"\n file=\"../Tom&#39;s &#38; &#60;/sub/c.dxf\" x='1'/>"
        "<meshes file='d'/><mesh file='/root.obj'/></room>";
    char *moved;
    size_t length;
    assert_int_equal(
        pp_room_text_move(&moved, &length, text, strlen(text), "../Tom's & </", NULL),
        PP_OK);
    assert_string_equal(moved, wanted);
    assert_int_equal(length, strlen(wanted));
    free(moved);
    assert_int_equal(pp_room_text_move(&moved, &length, text, strlen(text), "", NULL),
                     PP_OK);
    assert_string_equal(moved, text);
    free(moved);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_edits_the_text_is_the_file_s),
        cmocka_unit_test(
            a_place_is_written_into_the_tag_and_figures_that_stay_are_not_touched),
        cmocka_unit_test(a_rooflight_has_x_y_and_depth),
        cmocka_unit_test(one_more_stands_on_a_line_of_its_own_with_the_same_indent),
        cmocka_unit_test(one_left_out_takes_its_line_with_it),
        cmocka_unit_test(what_shares_its_line_stays),
        cmocka_unit_test(several_edits_are_made_at_once),
        cmocka_unit_test(an_element_is_given_by_itself),
        cmocka_unit_test(a_file_that_moves_finds_its_meshes),
        cmocka_unit_test(a_file_that_moves_finds_its_pictures_and_outlines),
    };
    add_tests(tests, NULL, NULL);
}
