/* test_wrong_rooms.c - each room file of tests/model/room/read/wrong is refused, for its own reason.
 *
 * tests/model/room/read/wrong/EXPECTED has a line a file: where its one mistake stands and what must be
 * said of it. The schema for editors gives the same verdict where it can.
 */
#include <libxml/parser.h>
#include <libxml/relaxng.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "model/room/corrections.h"
#include "model/light/finishes.h"
#include "model/light/glazings.h"
#include "model/room/building.h"
#include "tests/lib/near.h"

static void source_path(char *path, size_t size, const char *name)
{
    const char *source = getenv("srcdir");
    snprintf(path, size, "%s/%s", source ? source : ".", name);
}

struct expected {
    char file[128], kind[16], words[256];
    int line;
};

/* Calls visit for each line of the list; returns how many there are. */
static int each_wrong_room(void (*visit)(const struct expected *, const char *path,
                                         void *context),
                           void *context)
{
    char path[1024], line[512];
    source_path(path, sizeof path, "tests/model/room/read/wrong/EXPECTED");
    FILE *list = fopen(path, "r");
    assert_non_null(list);
    int count = 0;
    while (fgets(line, sizeof line, list)) {
        struct expected e;
        char name[256];
        if (line[0] == '#')
            continue;
        assert_int_equal(sscanf(line, "%127[^|]|%d|%15[^|]|%255[^\n]", e.file, &e.line,
                                e.kind, e.words),
                         4);
        snprintf(name, sizeof name, "tests/model/room/read/wrong/%s", e.file);
        source_path(path, sizeof path, name);
        visit(&e, path, context);
        count++;
    }
    fclose(list);
    return count;
}

static void refuse_by_reader(const struct expected *e, const char *path, void *context)
{
    int *failures = context;
    struct pp_building *building;
    struct pp_mistakes mistakes;
    struct pp_error err = {0};
    pp_mistakes_init(&mistakes, e->file);
    enum pp_status status = pp_building_read(&building, path, &mistakes, &err);
    for (int i = 0; building && i < pp_building_room_count(building); i++) {
        struct pp_world *world = NULL;
        enum pp_status made =
            pp_world_create(&world, pp_building_room(building, i), &mistakes, &err);
        status = made == PP_OK ? status : made;
        pp_world_destroy(world);
    }
    /* One mistake; but what does not close may be said of several edges. */
    bool sense = strcmp(e->kind, "sense") == 0, on_line = false, all_say = true;
    for (int i = 0; i < mistakes.count; i++) {
        on_line = on_line || mistakes.list[i].line == e->line;
        all_say = all_say && strstr(mistakes.list[i].text, e->words);
    }
    bool good =
        status == PP_BAD_INPUT && on_line && all_say && (mistakes.count == 1 || sense);
    if (!good) {
        print_message("# %s: status %d, %d mistakes, expected \"%s\" in line %d\n",
                      e->file, (int)status, mistakes.count, e->words, e->line);
        for (int i = 0; i < mistakes.count; i++)
            print_message("#   %d: %s\n", mistakes.list[i].line, mistakes.list[i].text);
        ++*failures;
    }
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
}

/* And the XML library says nothing of its own to the terminal meanwhile. */
static void two_hundred_wrong_rooms_are_refused_each_for_its_one_mistake(void **state)
{
    (void)state;
    int failures = 0;
    FILE *said = tmpfile();
    assert_non_null(said);
    fflush(stderr);
    int terminal = dup(STDERR_FILENO);
    dup2(fileno(said), STDERR_FILENO);
    int count = each_wrong_room(refuse_by_reader, &failures);
    fflush(stderr);
    dup2(terminal, STDERR_FILENO);
    close(terminal);
    assert_true(count >= 200);
    assert_int_equal(failures, 0);
    assert_int_equal(lseek(fileno(said), 0, SEEK_END), 0);
    fclose(said);
}

/* The schema, loaded once. */
struct schema {
    xmlRelaxNGPtr grammar;
    int failures;
};

static void no_words(void *context, const char *format, ...)
{
    (void)context, (void)format;
}

static void load_schema(struct schema *schema)
{
    char path[1024];
    source_path(path, sizeof path, "docs/room.rng");
    xmlRelaxNGParserCtxtPtr parser = xmlRelaxNGNewParserCtxt(path);
    assert_non_null(parser);
    *schema = (struct schema){.grammar = xmlRelaxNGParse(parser)};
    xmlRelaxNGFreeParserCtxt(parser);
    assert_non_null(schema->grammar);
}

static bool schema_takes(const struct schema *schema, xmlDocPtr document)
{
    assert_non_null(document);
    xmlRelaxNGValidCtxtPtr valid = xmlRelaxNGNewValidCtxt(schema->grammar);
    assert_non_null(valid);
    xmlRelaxNGSetValidErrors(valid, no_words, no_words, NULL);
    int verdict = xmlRelaxNGValidateDoc(valid, document);
    assert_true(verdict >= 0);
    xmlRelaxNGFreeValidCtxt(valid);
    xmlFreeDoc(document);
    return verdict == 0;
}

static void refuse_by_schema(const struct expected *e, const char *path, void *context)
{
    struct schema *schema = context;
    if (strcmp(e->kind, "xml") == 0)
        return;
    bool takes = schema_takes(schema, xmlReadFile(path, NULL, XML_PARSE_NONET));
    if (takes != (strcmp(e->kind, "sense") == 0)) {
        print_message("# %s: a mistake of %s, and the schema %s it\n", e->file, e->kind,
                      takes ? "takes" : "refuses");
        schema->failures++;
    }
}

static void the_schema_refuses_what_is_wrong_in_form(void **state)
{
    (void)state;
    struct schema schema;
    load_schema(&schema);
    each_wrong_room(refuse_by_schema, &schema);
    xmlRelaxNGFree(schema.grammar);
    assert_int_equal(schema.failures, 0);
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

static void schema_and_reader_agree(const struct schema *schema, const char *format,
                                    const char *value, bool expected)
{
    char xml[1024];
    snprintf(xml, sizeof xml, format, value);
    xmlDocPtr document = xmlReadMemory(xml, (int)strlen(xml), NULL, NULL, 0);
    bool by_reader = reader_takes(xml), by_schema = schema_takes(schema, document);
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
    struct schema schema;
    load_schema(&schema);
    schema_and_reader_agree(&schema, window, "none", true);
    for (int i = 0; i < pp_glazings_count(); i++)
        schema_and_reader_agree(&schema, window, pp_glazings_at(i)->name, true);
    for (int i = 0; i < pp_finishes_count(); i++)
        schema_and_reader_agree(&schema, finish, pp_finishes_at(i)->name, true);
    static const char frame[] = ROOM("<window wall='south' left='0.9' sill='0.8' "
                                     "width='2.4' height='1.5' frame-factor='%s'/>");
    static const char curtains[] = ROOM("<window wall='south' left='0.9' sill='0.8' "
                                        "width='2.4' height='1.5' curtains='%s'/>");
    for (int i = 0; i < pp_frames.count; i++)
        schema_and_reader_agree(&schema, frame, pp_frames.list[i].name, true);
    for (int i = 0; i < pp_curtains.count; i++)
        schema_and_reader_agree(&schema, curtains, pp_curtains.list[i].name, true);
    schema_and_reader_agree(&schema, frame, "white", false);
    schema_and_reader_agree(&schema, curtains, "metal", false);
    schema_and_reader_agree(&schema, frame, "0.35", true);
    schema_and_reader_agree(&schema, curtains, "0.35", true);
    static const char *const states[] = {"auto", "0.9",  "0", "1",
                                         "1.01", "-0.1", "",  "new"};
    for (int i = 0; i < 8; i++)
        schema_and_reader_agree(&schema, ROOM("<finishes decorations='%s'/>"),
                                states[i], i < 4);
    static const char *const works[] = {"clean", "dirty", "", "Clean"};
    for (int i = 0; i < 4; i++)
        schema_and_reader_agree(&schema, ROOM("<site work='%s'/>"), works[i], i < 2);
    for (int i = 0; i <= 16; i++) {
        char type[16];
        snprintf(type, sizeof type, "iso-%d", i);
        schema_and_reader_agree(&schema, sky, type, i >= 1 && i <= 15);
        bool alone = i == 1 || i == 3 || i == 5;
        schema_and_reader_agree(&schema, ROOM("<sky type='%s'/>"), type, alone);
    }
    xmlRelaxNGFree(schema.grammar);
}

static void schema_and_reader_read_the_same_numbers(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        bool good;
    } numbers[] = {
        {"3", true},       {"3.", true},       {".5", true},     {"0.5", true},
        {"+3", true},      {"3e1", true},      {"3E+1", true},   {"30e-1", true},
        {" 3 ", true},     {"\n3", true},      {"0003", true},   {"1e5", true},
        {"0.001", true},   {"100000.0", true}, {"1e-3", true},   {"", false},
        {" ", false},      {".", false},       {"+", false},     {"e3", false},
        {"3e", false},     {"3 4", false},     {"3,5", false},   {"0x3", false},
        {"inf", false},    {"INF", false},     {"-INF", false},  {"nan", false},
        {"NaN", false},    {"1e999", false},   {"3m", false},    {"3%", false},
        {"-3", false},     {"0", false},       {"-0", false},    {"0.0009", false},
        {"100001", false}, {"1e308", false},   {"3.4.5", false}, {"+-3", false},
        {"١", false},      {"3\u00a0", false},
    };
    struct schema schema;
    load_schema(&schema);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        schema_and_reader_agree(
            &schema, "<room version='1'><plan width='%s' depth='5' height='2'/></room>",
            numbers[i].text, numbers[i].good);
    static const char line[] = ROOM("<line from='1 1' to='1 3' points='%s'/>");
    static const char *const counts[] = {"2", "17", "+9", "007", " 5 ", "100000"};
    static const char *const none[] = {"1",   "0",   "-3", "2.0",
                                       "2e1", "1 7", "",   "100001"};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
        schema_and_reader_agree(&schema, line, counts[i], true);
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        schema_and_reader_agree(&schema, line, none[i], false);
    static const char from[] = ROOM("<line from='%s' to='1 3' points='5'/>");
    static const char *const pairs[] = {"1 2", " 1\t2 ", "1e0 -2.5", "0 0"};
    static const char *const odd[] = {"1", "1 2 3", "1,2", "1;2", "a b", "1 1e6", ""};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        schema_and_reader_agree(&schema, from, pairs[i], true);
    for (size_t i = 0; i < sizeof odd / sizeof *odd; i++)
        schema_and_reader_agree(&schema, from, odd[i], false);
    xmlRelaxNGFree(schema.grammar);
}

static void schema_and_reader_take_the_examples(void **state)
{
    (void)state;
    static const char *const examples[] = {
        "building", "classroom", "deep-office", "deep-office-obstructed",
        "l-shaped", "office",    "studio",      "workshop"};
    struct schema schema;
    load_schema(&schema);
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++) {
        char name[64], path[1024];
        struct pp_building *building;
        struct pp_mistakes mistakes;
        snprintf(name, sizeof name, "examples/%s.xml", examples[i]);
        source_path(path, sizeof path, name);
        assert_true(schema_takes(&schema, xmlReadFile(path, NULL, XML_PARSE_NONET)));
        pp_mistakes_init(&mistakes, path);
        assert_int_equal(pp_building_read(&building, path, &mistakes, NULL), PP_OK);
        pp_building_destroy(building);
        pp_mistakes_clear(&mistakes);
    }
    xmlRelaxNGFree(schema.grammar);
}

/* All that is wrong is said at once, in the order of the lines. */
static void many_mistakes_of_one_file_are_all_told(void **state)
{
    (void)state;
    static const char xml[] = "<room version='2' north='up'>\n"
                              "  <plan width='-3' depth='4' hight='2.5'/>\n"
                              "  <window wall='south' left='1'\n"
                              "          sill='low'\n"
                              "          width='1.2' height='9,5' glazing='double'/>\n"
                              "  <sky type='iso-12'/>\n"
                              "  <door/>\n"
                              "  <finish wall='east' reflectance='1.2'/>\n"
                              "  words\n"
                              "  <point x='1'/>\n"
                              "</room>\n";
    static const struct {
        int line;
        const char *words;
    } told[] = {
        {1, "version is \"2\""},
        {1, "north is \"up\""},
        {2, "did you mean \"height\""},
        {2, "width is \"-3\""},
        {4, "sill is \"low\""},
        {5, "height is \"9,5\""},
        {5, "did you mean \"clear-double\""},
        {6, "where the sun stands"},
        {7, "\"door\" is not known"},
        {8, "reflectance is \"1.2\""},
        {9, "text \"words\""},
        {10, "y is missing"},
    };
    struct pp_building *building;
    struct pp_mistakes mistakes;
    struct pp_error err = {0};
    pp_mistakes_init(&mistakes, "many.xml");
    assert_int_equal(pp_building_parse(&building, xml, strlen(xml), &mistakes, &err),
                     PP_BAD_INPUT);
    assert_string_equal(err.message, "many.xml: 12 mistakes");
    assert_non_null(building);
    assert_int_equal(mistakes.count, sizeof told / sizeof *told);
    for (int i = 0; i < mistakes.count; i++) {
        assert_int_equal(mistakes.list[i].line, told[i].line);
        if (!strstr(mistakes.list[i].text, told[i].words))
            fail_msg("%s, not %s", mistakes.list[i].text, told[i].words);
    }
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_hundred_wrong_rooms_are_refused_each_for_its_one_mistake),
        cmocka_unit_test(the_schema_refuses_what_is_wrong_in_form),
        cmocka_unit_test(schema_and_reader_know_the_same_names),
        cmocka_unit_test(schema_and_reader_read_the_same_numbers),
        cmocka_unit_test(schema_and_reader_take_the_examples),
        cmocka_unit_test(many_mistakes_of_one_file_are_all_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
