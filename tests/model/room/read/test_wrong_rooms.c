/* test_wrong_rooms.c - every wrong room is rejected because of its one mistake.
 *
 * The rooms are in the text files of tests/model/room/read/wrong, which wrong_rooms.h
 * describes; each is a test named by its title. Without arguments all tests run;
 *
 *    srcdir=FOLDER test_wrong_rooms --write TITLE        writes that room to standard output
 *    srcdir=FOLDER test_wrong_rooms --write-all FOLDER   writes every room, as TITLE.xml
 *
 * A file name has - instead of the blanks of a title.
 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "model/room/building.h"
#include "tests/lib/editor_schema.h"
#include "tests/lib/near.h"
#include "tests/model/room/read/wrong_rooms.h"

/* ---- rejected by the reader, and by the schema ---- */

struct verdict {
    enum pp_status status;
    struct pp_mistakes mistakes;
};

/* Result of reading the room and creating its world; the caller clears its mistakes. */
static struct verdict verdict_on(const char *bytes, size_t length)
{
    struct verdict verdict;
    struct pp_building *building = NULL;
    struct pp_error err = {0};
    pp_mistakes_init(&verdict.mistakes, "wrong.xml");
    verdict.status =
        pp_building_parse(&building, bytes, length, &verdict.mistakes, &err);
    for (int i = 0; building && i < pp_building_room_count(building); i++) {
        struct pp_world *world = NULL;
        enum pp_status made = pp_world_create(&world, pp_building_room(building, i),
                                              &verdict.mistakes, &err);
        verdict.status = made == PP_OK ? verdict.status : made;
        pp_world_destroy(world);
    }
    pp_building_destroy(building);
    return verdict;
}

/* As above; fails if anything is written to standard error. */
static struct verdict silent_verdict_on(const struct wrong_room *room)
{
    FILE *said = tmpfile();
    assert_non_null(said);
    fflush(stderr);
    int terminal = dup(STDERR_FILENO);
    dup2(fileno(said), STDERR_FILENO);
    struct verdict verdict = verdict_on(room->bytes, room->length);
    fflush(stderr);
    dup2(terminal, STDERR_FILENO);
    close(terminal);
    off_t length = lseek(fileno(said), 0, SEEK_END);
    fclose(said);
    if (length != 0)
        fail_msg("%s:%d: %s: something is said on standard error", room->file, room->at,
                 room->title);
    return verdict;
}

/* There must be one mistake; only a room of WRONG_SENSE may have several, all with the
 * expected words: an envelope that is not closed has one for each edge. */
static bool is_as_expected(const struct verdict *verdict, const struct wrong_room *room)
{
    const struct pp_mistakes *mistakes = &verdict->mistakes;
    bool on_line = false, all_say = true;
    for (int i = 0; i < mistakes->count; i++) {
        on_line = on_line || mistakes->list[i].line == room->line;
        all_say = all_say && strstr(mistakes->list[i].text, room->words);
    }
    return verdict->status == PP_BAD_INPUT && on_line && all_say
           && (mistakes->count == 1 || room->kind == WRONG_SENSE);
}

/* A room, and the schema that validates it. */
struct wrong_case {
    const struct wrong_room *room;
    const struct editor_schema *schema;
};

/* Fails with the position in the text file and the actual messages. */
static void fail_with(const struct wrong_room *room, const struct pp_mistakes *said)
{
    print_message("# %s:%d: %s: expected line %d: %s\n", room->file, room->at,
                  room->title, room->line, room->words);
    for (int i = 0; i < said->count; i++)
        print_message("#     said: line %d: %s\n", said->list[i].line,
                      said->list[i].text);
    fail();
}

static void room_is_refused(void **state)
{
    const struct wrong_case *wrong = *state;
    const struct wrong_room *room = wrong->room;
    struct verdict verdict = silent_verdict_on(room);
    if (!is_as_expected(&verdict, room))
        fail_with(room, &verdict.mistakes);
    pp_mistakes_clear(&verdict.mistakes);
    if (room->kind == WRONG_XML)
        return;
    bool takes = editor_schema_takes(wrong->schema, room->bytes, room->length);
    if (takes != (room->kind == WRONG_SENSE))
        fail_msg("%s:%d: %s: the schema %s it", room->file, room->at, room->title,
                 takes ? "takes" : "refuses");
}

/* ---- further properties of the cases ---- */

static void source_path(char *path, size_t size, const char *name)
{
    const char *source = getenv("srcdir");
    snprintf(path, size, "%s/tests/model/room/read/wrong%s", source ? source : ".",
             name);
}

/* Otherwise a case might be rejected because of its base room. */
static void base_rooms_are_right(void **state)
{
    (void)state;
    static const char *const bases[] = {"/study.xml", "/corner.xml", "/tent.xml",
                                        "/flats.xml", "/canopy.xml", "/hatch.xml"};
    for (size_t i = 0; i < sizeof bases / sizeof *bases; i++) {
        char path[1024];
        struct pp_building *building;
        struct pp_mistakes mistakes;
        source_path(path, sizeof path, bases[i]);
        pp_mistakes_init(&mistakes, path);
        assert_int_equal(pp_building_read(&building, path, &mistakes, NULL), PP_OK);
        size_t length;
        const char *text = pp_building_text(building, &length);
        struct verdict verdict = verdict_on(text, length);
        assert_int_equal(verdict.status, PP_OK);
        pp_mistakes_clear(&verdict.mistakes);
        pp_building_destroy(building);
        pp_mistakes_clear(&mistakes);
    }
}

/* Otherwise a text file might have been omitted. */
static void wrong_rooms_are_hundreds(void **state)
{
    const struct wrong_rooms *rooms = *state;
    assert_true(rooms->count > 350);
}

/* All mistakes are reported together, in the order of the lines. */
static void all_mistakes_of_one_file_are_reported(void **state)
{
    (void)state;
    static const char xml[] = "<room version='2' north='up'>\n"
                              "  <plan width='-3' depth='4' hight='2.5'/>\n"
                              "  <window wall='south' left='1'\n"
                              "          sill='low'\n"
                              "          width='1.2' height='9,5' glazing='double'/>\n"
                              "  <sky type='iso-12'/>\n"
                              "  <gate/>\n"
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
        {6, "the position of the sun"},
        {7, "\"gate\" is unknown"},
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

/* ---- the program ---- */

static int test_all(struct wrong_rooms *rooms)
{
    struct editor_schema *schema = editor_schema_create();
    size_t count = (size_t)rooms->count;
    struct CMUnitTest *tests = calloc(count + 3, sizeof *tests);
    struct wrong_case *cases = calloc(count, sizeof *cases);
    if (!schema || !tests || !cases)
        abort();
    for (size_t i = 0; i < count; i++) {
        cases[i] = (struct wrong_case){&rooms->list[i], schema};
        tests[i] = (struct CMUnitTest){.name = rooms->list[i].title,
                                       .test_func = room_is_refused,
                                       .initial_state = &cases[i]};
    }
    tests[count] = (struct CMUnitTest)cmocka_unit_test(base_rooms_are_right);
    tests[count + 1] =
        (struct CMUnitTest)cmocka_unit_test_prestate(wrong_rooms_are_hundreds, rooms);
    tests[count + 2] =
        (struct CMUnitTest)cmocka_unit_test(all_mistakes_of_one_file_are_reported);
    int failed = _cmocka_run_group_tests("wrong rooms", tests, count + 3, NULL, NULL);
    free(cases);
    free(tests);
    editor_schema_destroy(schema);
    return failed;
}

static int write_one(const struct wrong_rooms *rooms, const char *title)
{
    const struct wrong_room *room = wrong_rooms_find(rooms, title);
    if (!room) {
        fprintf(stderr, "no wrong room has the title \"%s\"\n", title);
        return 2;
    }
    fwrite(room->bytes, 1, room->length, stdout);
    return fflush(stdout) == 0 ? 0 : 1;
}

static int write_all(const struct wrong_rooms *rooms, const char *folder)
{
    for (int i = 0; i < rooms->count; i++) {
        const struct wrong_room *room = &rooms->list[i];
        char title[128], path[1024];
        snprintf(title, sizeof title, "%s", room->title);
        for (char *c = strchr(title, ' '); c; c = strchr(c, ' '))
            *c = '-';
        snprintf(path, sizeof path, "%s/%s.xml", folder, title);
        FILE *file = fopen(path, "w");
        if (!file) {
            perror(path);
            return 1;
        }
        bool whole = fwrite(room->bytes, 1, room->length, file) == room->length;
        if (fclose(file) != 0 || !whole)
            return 1;
    }
    return 0;
}

int main(int argc, char **argv)
{
    struct wrong_rooms rooms;
    char folder[1024];
    int status = 2;
    source_path(folder, sizeof folder, "");
    wrong_rooms_read(&rooms, folder);
    if (argc == 1)
        status = test_all(&rooms);
    else if (argc == 3 && strcmp(argv[1], "--write") == 0)
        status = write_one(&rooms, argv[2]);
    else if (argc == 3 && strcmp(argv[1], "--write-all") == 0)
        status = write_all(&rooms, argv[2]);
    else
        fprintf(stderr,
                "usage: test_wrong_rooms [--write TITLE | --write-all FOLDER]\n");
    wrong_rooms_clear(&rooms);
    return status;
}
