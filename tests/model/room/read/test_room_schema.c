/* test_room_schema.c - the schema for editors, docs/room.rng, and the reader accept the
 * same names, numbers and examples. test_wrong_rooms.c tests both with the wrong
 * rooms. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "model/room/corrections.h"
#include "model/light/finishes.h"
#include "model/light/glazings.h"
#include "model/room/building.h"
#include "model/room/read/room_schema.h"
#include "tests/lib/editor_schema.h"
#include "tests/lib/near.h"

static struct editor_schema *the_schema(void)
{
    struct editor_schema *schema = editor_schema_create();
    assert_non_null(schema);
    return schema;
}

static bool reader_takes(const char *xml)
{
    struct pp_building *building;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "test");
    enum pp_status status =
        pp_building_parse(&building, xml, strlen(xml), &mistakes, NULL);
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
    return status == PP_OK;
}

static void schema_and_reader_agree(const struct editor_schema *schema,
                                    const char *format, const char *value,
                                    bool expected)
{
    char xml[1024];
    snprintf(xml, sizeof xml, format, value);
    bool by_reader = reader_takes(xml),
         by_schema = editor_schema_takes(schema, xml, strlen(xml));
    if (by_reader != expected || by_schema != expected)
        fail_msg("%s: reader %d, schema %d, expected %d", xml, by_reader, by_schema,
                 expected);
}

#define ROOM(inside)                                                                   \
    "<room version='1'><plan width='4.2' depth='5.3' height='2.7'/>" inside "</room>"

static void schema_and_reader_know_the_same_names(void **state)
{
    (void)state;
    static const char window[] = ROOM("<window wall='south' left='0.9' sill='0.8' "
                                      "width='2.4' height='1.5' glazing='%s'/>");
    static const char finish[] = ROOM("<finish wall='south' reflectance='%s'/>");
    static const char sky[] =
        ROOM("<sky type='%s' sun-altitude='35' sun-bearing='170'/>");
    struct editor_schema *schema = the_schema();
    schema_and_reader_agree(schema, window, "none", true);
    for (int i = 0; i < pp_glazings_count(); i++)
        schema_and_reader_agree(schema, window, pp_glazings_at(i)->name, true);
    for (int i = 0; i < pp_finishes_count(); i++)
        schema_and_reader_agree(schema, finish, pp_finishes_at(i)->name, true);
    static const char frame[] = ROOM("<window wall='south' left='0.9' sill='0.8' "
                                     "width='2.4' height='1.5' frame-factor='%s'/>");
    static const char curtains[] = ROOM("<window wall='south' left='0.9' sill='0.8' "
                                        "width='2.4' height='1.5' curtains='%s'/>");
    for (int i = 0; i < pp_frames.count; i++)
        schema_and_reader_agree(schema, frame, pp_frames.list[i].name, true);
    for (int i = 0; i < pp_curtains.count; i++)
        schema_and_reader_agree(schema, curtains, pp_curtains.list[i].name, true);
    schema_and_reader_agree(schema, frame, "white", false);
    schema_and_reader_agree(schema, curtains, "metal", false);
    schema_and_reader_agree(schema, frame, "0.35", true);
    schema_and_reader_agree(schema, curtains, "0.35", true);
    static const char *const states[] = {"auto", "0.9",  "0", "1",
                                         "1.01", "-0.1", "",  "new"};
    for (int i = 0; i < 8; i++)
        schema_and_reader_agree(schema, ROOM("<finishes decorations='%s'/>"), states[i],
                                i < 4);
    static const char *const works[] = {"clean", "dirty", "", "Clean"};
    for (int i = 0; i < 4; i++)
        schema_and_reader_agree(schema, ROOM("<site work='%s'/>"), works[i], i < 2);
    for (int i = 0; i <= 16; i++) {
        char type[16];
        snprintf(type, sizeof type, "iso-%d", i);
        schema_and_reader_agree(schema, sky, type, i >= 1 && i <= 15);
        bool alone = i == 1 || i == 3 || i == 5;
        schema_and_reader_agree(schema, ROOM("<sky type='%s'/>"), type, alone);
    }
    editor_schema_destroy(schema);
}

static void schema_and_reader_read_the_same_numbers(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        bool good;
    } numbers[] = {
        {"3", true},          {"3.", true},       {".5", true},     {"0.5", true},
        {"+3", true},         {"3e1", true},      {"3E+1", true},   {"30e-1", true},
        {" 3 ", true},        {"\n3", true},      {"0003", true},   {"1e5", true},
        {"0.001", true},      {"100000.0", true}, {"1e-3", true},   {"", false},
        {" ", false},         {".", false},       {"+", false},     {"e3", false},
        {"3e", false},        {"3 4", false},     {"3,5", false},   {"0x3", false},
        {"inf", false},       {"INF", false},     {"-INF", false},  {"nan", false},
        {"NaN", false},       {"1e999", false},   {"3m", false},    {"3%", false},
        {"-3", false},        {"0", false},       {"-0", false},    {"0.0009", false},
        {"100000001", false}, {"1e308", false},   {"3.4.5", false}, {"+-3", false},
        {"١", false},         {"3\u00a0", false},
    };
    struct editor_schema *schema = the_schema();
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        schema_and_reader_agree(
            schema, "<room version='1'><plan width='%s' depth='5' height='2'/></room>",
            numbers[i].text, numbers[i].good);
    static const char line[] = ROOM("<line from='1 1' to='1 3' points='%s'/>");
    static const char *const counts[] = {"2", "17", "+9", "007", " 5 ", "100000"};
    static const char *const none[] = {"1",   "0",   "-3", "2.0",
                                       "2e1", "1 7", "",   "100001"};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
        schema_and_reader_agree(schema, line, counts[i], true);
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        schema_and_reader_agree(schema, line, none[i], false);
    static const char from[] = ROOM("<line from='%s' to='1 3' points='5'/>");
    static const char *const pairs[] = {"1 2", " 1\t2 ", "1e0 -2.5", "0 0"};
    static const char *const odd[] = {"1", "1 2 3", "1,2", "1;2", "a b", "1 1e9", ""};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        schema_and_reader_agree(schema, from, pairs[i], true);
    for (size_t i = 0; i < sizeof odd / sizeof *odd; i++)
        schema_and_reader_agree(schema, from, odd[i], false);
    editor_schema_destroy(schema);
}

static void schema_and_reader_take_the_examples(void **state)
{
    (void)state;
    const char *source = getenv("srcdir");
    static const char *const examples[] = {
        "building", "classroom", "deep-office", "deep-office-obstructed",
        "l-shaped", "office",    "studio",      "workshop"};
    struct editor_schema *schema = the_schema();
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++) {
        char path[1024];
        struct pp_building *building;
        struct pp_mistakes mistakes;
        snprintf(path, sizeof path, "%s/examples/%s.xml", source ? source : ".",
                 examples[i]);
        pp_mistakes_init(&mistakes, path);
        assert_int_equal(pp_building_read(&building, path, &mistakes, NULL), PP_OK);
        size_t length;
        const char *text = pp_building_text(building, &length);
        assert_true(editor_schema_takes(schema, text, length));
        pp_building_destroy(building);
        pp_mistakes_clear(&mistakes);
    }
    editor_schema_destroy(schema);
}

/* The message for an attribute ends with the expected values. */
static void see_words(const struct pp_element_rule *rule, int depth, int *seen)
{
    for (int i = 0; i < rule->attribute_count; i++, ++*seen)
        if (!rule->attributes[i].kind->expected || !*rule->attributes[i].kind->expected)
            fail_msg("%s: %s has no words for what is expected", rule->name,
                     rule->attributes[i].name);
    for (int i = 0; i < rule->child_count && depth < 5; i++)
        see_words(rule->children[i].rule, depth + 1, seen);
}

static void every_attribute_says_what_it_expects(void **state)
{
    (void)state;
    int seen = 0;
    see_words(&pp_rule_building, 0, &seen);
    see_words(&pp_rule_room, 0, &seen);
    assert_true(seen > 200);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(schema_and_reader_know_the_same_names),
        cmocka_unit_test(schema_and_reader_read_the_same_numbers),
        cmocka_unit_test(schema_and_reader_take_the_examples),
        cmocka_unit_test(every_attribute_says_what_it_expects),
    };
    add_tests(tests, NULL, NULL);
}
