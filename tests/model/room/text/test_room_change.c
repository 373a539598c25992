/* test_room_change.c - changes of single attributes of a room file by address: the
 * other text is unchanged. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/room/text/room_change.h"
#include "tests/lib/near.h"

static const char building[] =
    "<building version='1'>\n"
    "  <block name='Tower' x='0' y='-20' width='4' depth='4' height='9'/>\n"
    "  <room name='A' ref='0.1' x='0' y='0' z='0'><plan width='4' depth='5' "
    "height='3'/>\n"
    "    <window wall='south' left='1' sill='1' width='1.2' height='1'/> <!-- W1 -->\n"
    "    <window name='W.2' wall='south' left='3' sill='1' width='0.5' height='1'>\n"
    "      <overhang depth='0.6'/></window></room>\n"
    "  <room name='B'><plan width='4' depth='6' height='3'/>\n"
    "    <window name='W3' wall='south' left='1' sill='1' width='1.1' height='1'/>\n"
    "    <window name='W4' wall='south' left='3' sill='1' width='1.1' "
    "height='1'/></room>\n"
    "</building>\n";

/* The text after one change; NULL, with the message, if it is refused. */
static char *with_change(const char *text, const char *address, const char *value,
                         bool lenient, struct pp_error *err)
{
    char *changed = NULL;
    size_t length;
    struct pp_room_change change = {address, value};
    const struct pp_room_changes changes = {&change, 1, lenient};
    if (pp_room_change_text(&changed, &length, text, strlen(text), &changes, err)
        != PP_OK)
        return NULL;
    assert_int_equal(length, strlen(changed));
    return changed;
}

/* Asserts that exactly one passage of the building's text is replaced. */
static void assert_changes(const char *address, const char *value, const char *was,
                           const char *is)
{
    struct pp_error err = {0};
    char expected[2048];
    const char *at = strstr(building, was);
    char *changed = with_change(building, address, value, false, &err);
    assert_non_null(at);
    assert_non_null(changed);
    snprintf(expected, sizeof expected, "%.*s%s%s", (int)(at - building), building, is,
             at + strlen(was));
    assert_string_equal(changed, expected);
    free(changed);
}

static void a_part_is_found_by_name_ref_number_or_the_room_it_is_in(void **state)
{
    (void)state;
    assert_changes("block.Tower.height", "12", "height='9'", "height='12'");
    assert_changes("window.W3.width", "2", "width='1.1' height='1'/>\n",
                   "width='2' height='1'/>\n");
    assert_changes("room.B.plan.depth", "7.5", "depth='6'", "depth='7.5'");
    assert_changes("room.0.1.plan.depth", "7.5", "depth='5'", "depth='7.5'");
    assert_changes("room.A.window.1.width", "2", "width='1.2'", "width='2'");
    assert_changes("overhang.depth", "0.9", "depth='0.6'", "depth='0.9'");
}

static void a_name_may_contain_points(void **state)
{
    (void)state;
    assert_changes("window.W.2.width", "0.7", "width='0.5'", "width='0.7'");
}

static void an_attribute_that_was_left_out_is_added(void **state)
{
    (void)state;
    assert_changes("window.W4.glazing", "opal-glass", "<window name='W4'",
                   "<window glazing=\"opal-glass\" name='W4'");
    assert_changes("building.north", "30", "<building", "<building north=\"30\"");
}

static void a_value_cannot_end_its_quotes(void **state)
{
    (void)state;
    assert_changes("block.Tower.name", "a'\"<&", "'Tower'", "'a&#39;&#34;&#60;&#38;'");
}

static void without_a_name_every_part_of_the_kind_changes(void **state)
{
    (void)state;
    struct pp_error err = {0};
    char *changed = with_change(building, "window.height", "1.5", false, &err);
    assert_non_null(changed);
    int count = 0;
    for (const char *at = changed; (at = strstr(at, "height='1.5'")) != NULL; at++)
        count++;
    assert_int_equal(count, 4);
    free(changed);
}

static void assert_refused(const char *address, const char *message)
{
    struct pp_error err = {0};
    assert_null(with_change(building, address, "1", false, &err));
    assert_int_equal(err.status, PP_BAD_INPUT);
    assert_non_null(strstr(err.message, message));
}

static void an_unknown_address_is_rejected_with_the_known_ones(void **state)
{
    (void)state;
    assert_refused("window.W5.width", "there is no window.W5");
    assert_refused("windwo.W3.width", "did you mean window?");
    assert_refused("room.Kitchen.plan.depth",
                   "there is no room.Kitchen; expected room.A or room.B");
    assert_refused("room.A.window.W9.width", "there is no window.W9");
    assert_refused("window.W3.widht", "did you mean width?");
    assert_refused("window.1.width", "2 parts have this address");
    assert_refused("", "");
    assert_refused(".", "");
}

static void a_lenient_change_leaves_out_what_the_file_does_not_have(void **state)
{
    (void)state;
    struct pp_error err = {0};
    char *changed = with_change(building, "block.Mill.height", "1", true, &err);
    assert_string_equal(changed, building);
    free(changed);
}

static void a_file_with_mistakes_is_left_to_its_reader(void **state)
{
    (void)state;
    struct pp_error err = {0};
    char *changed = with_change("<room><plan", "plan.depth", "1", false, &err);
    assert_string_equal(changed, "<room><plan");
    free(changed);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_part_is_found_by_name_ref_number_or_the_room_it_is_in),
        cmocka_unit_test(a_name_may_contain_points),
        cmocka_unit_test(an_attribute_that_was_left_out_is_added),
        cmocka_unit_test(a_value_cannot_end_its_quotes),
        cmocka_unit_test(without_a_name_every_part_of_the_kind_changes),
        cmocka_unit_test(an_unknown_address_is_rejected_with_the_known_ones),
        cmocka_unit_test(a_lenient_change_leaves_out_what_the_file_does_not_have),
        cmocka_unit_test(a_file_with_mistakes_is_left_to_its_reader),
    };
    add_tests(tests, NULL, NULL);
}
