/* test_hostile.c - malicious room files are rejected, or read correctly, within seconds
 * and with limited memory. Short files are in tests/model/room/read/wrong. */
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "model/room/building.h"
#include "model/room/room_parts.h"
#include "model/room/read/read_elements.h"
#include "tests/lib/near.h"
#include "tests/lib/sized.h"

#define PLAN "<plan width='4.2' depth='5.3' height='2.7'/>"

/* Most of these files take a tenth of a second of processor time, half a second on a
 * slow machine. An algorithm of quadratic time would need minutes. More time is allowed
 * with sanitizers. */
static double seconds_allowed(void)
{
    const char *preloaded = getenv("LD_PRELOAD");
    if (PP_WATCHED)
        return 30.0;
    return preloaded && strstr(preloaded, "valgrind") ? 60.0 : 5.0;
}

struct outcome {
    enum pp_status status;
    int mistakes, rooms, line;
    char text[512]; /* of the first mistake */
};

static struct outcome parse(const char *bytes, size_t length)
{
    struct outcome outcome = {0};
    struct pp_building *building;
    struct pp_mistakes mistakes;
    struct pp_error err = {0};
    /* A copy of exactly this length, so that a read beyond its end is detected. */
    char *copy = malloc(length ? length : 1);
    assert_non_null(copy);
    memcpy(copy, bytes, length);
    pp_mistakes_init(&mistakes, "hostile.xml");
    clock_t start = clock();
    outcome.status = pp_building_parse(&building, copy, length, &mistakes, &err);
    double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    if (seconds > seconds_allowed())
        fail_msg("%.60s ... takes %.1f s", bytes, seconds);
    outcome.mistakes = mistakes.count;
    if (mistakes.count > 0) {
        outcome.line = mistakes.list[0].line;
        snprintf(outcome.text, sizeof outcome.text, "%s", mistakes.list[0].text);
    }
    outcome.rooms = building ? pp_building_room_count(building) : 0;
    assert_int_equal(outcome.status == PP_BAD_INPUT, mistakes.count > 0);
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
    free(copy);
    return outcome;
}

static struct outcome parse_text(const char *text)
{
    return parse(text, strlen(text));
}

/* head, then `unit` repeated as often as possible, then tail; at most `size` bytes. */
static char *repeated(const char *head, const char *unit, const char *tail, size_t size)
{
    size_t head_size = strlen(head), unit_size = strlen(unit), tail_size = strlen(tail);
    char *text = malloc(size + 1), *p = text;
    assert_non_null(text);
    memcpy(p, head, head_size);
    p += head_size;
    for (; (size_t)(p - text) + unit_size + tail_size <= size; p += unit_size)
        memcpy(p, unit, unit_size);
    memcpy(p, tail, tail_size + 1);
    return text;
}

/* Files for which a quadratic algorithm would be slow: 4 MiB; under sanitizers enough
 * for 200,000 elements. */
static void large_files_take_linear_time(void **state)
{
    (void)state;
    static const char room[] = "<room version='1'>" PLAN;
    static const struct {
        const char *head, *unit, *tail;
        const char *words; /* NULL: read without a mistake */
    } bulk[] = {
        {"<room", " a=''", "/>", "a tag of more than 65536 bytes"},
        {"<room name='", "x", "'/>", "a tag of more than 65536 bytes"},
        {room, "\"", "</room>", "text"},
        {room, "<", "</room>", "a tag of more than 65536 bytes"},
        {room, "&", "</room>", "expected a name"},
        {room, "&amp;", "</room>", "text \"&&&&"},
        {room, "x", "</room>", "text \"xxxx"},
        {room, "&uuml;", "</room>", "&uuml; is unknown"},
        {room, "]]>", "</room>", "there is a ]]> between elements"},
        {"<!DOCTYPE room [", "<!ENTITY a 'b'>", "]><room/>",
         "a DOCTYPE is not allowed"},
        {room, "x<a/>", "</room>", "text \"x\""},
        {room, "x<a/>\n", "</room>", "text \"x\""},
        {room, "<a>", "</room>", "nested more than 8 levels deep"},
        {room, "<a/>", "</room>", "more than 200000 elements"},
        {room, "<dor/>\n", "</room>", "more than 200000 elements"},
        {room, "<point x='1' y='nan'/>", "</room>", "y is \"nan\""},
        {room, "<p:point xmlns:p='q' x='1'/>", "</room>", "no namespaces"},
        {room, "<!-- a -->", "</room>", NULL},
        {room, "<!-- \n -->", "</room>", NULL},
        {"<room version='1'><!-- ", "a - b ", " -->" PLAN "</room>", NULL},
        {room, "<?a b?>", "</room>", NULL},
        {room, "\n", "</room>", NULL},
        {room, "<![CDATA[ ]]>", "</room>", NULL},
        {room, "<window wall='south' left='1' sill='1' width='1' height='1'/>",
         "</room>", NULL},
        {"<room version='1'><plan height='2'>", "<vertex x='1' y='1'/>",
         "</plan></room>", "limit of 1000 <vertex>"},
        {"<building version='1'>", "<room>" PLAN "</room>", "</building>", NULL},
        {"<building version='1'>", "<room/>\n", "</building>", "room: has no shape"},
    };
    const size_t size = PP_SIZED(4 << 20, 4 << 20, 3 << 19);
    for (size_t i = 0; i < sizeof bulk / sizeof *bulk; i++) {
        char *text = repeated(bulk[i].head, bulk[i].unit, bulk[i].tail, size);
        struct outcome outcome = parse_text(text);
        free(text);
        assert_int_equal(outcome.status, bulk[i].words ? PP_BAD_INPUT : PP_OK);
        if (bulk[i].words && !strstr(outcome.text, bulk[i].words))
            fail_msg("%s...: %s", bulk[i].unit, outcome.text);
    }
}

/* Exponential entity expansion ("billion laughs"), an external entity, and external and
 * parameter DTDs. */
static void entities_are_neither_expanded_nor_fetched(void **state)
{
    (void)state;
    static const char *const files[] = {
        "<!DOCTYPE room [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;'>"
        "<!ENTITY c '&b;&b;&b;&b;&b;&b;&b;&b;'><!ENTITY d '&c;&c;&c;&c;&c;&c;&c;&c;'>"
        "<!ENTITY e '&d;&d;&d;&d;&d;&d;&d;&d;'><!ENTITY f '&e;&e;&e;&e;&e;&e;&e;&e;'>"
        "<!ENTITY g '&f;&f;&f;&f;&f;&f;&f;&f;'><!ENTITY h '&g;&g;&g;&g;&g;&g;&g;&g;'>"
        "]><room version='1' name='&h;'>" PLAN "</room>",
        "<!DOCTYPE room [<!ENTITY a SYSTEM 'file:///etc/passwd'>]>"
        "<room version='1' name='&a;'>" PLAN "</room>",
        "<!DOCTYPE room SYSTEM 'http://example.org/room.dtd'><room version='1'/>",
        "<!DOCTYPE room PUBLIC '-//E//R' 'http://example.org/r.dtd'><room/>",
        "<!DOCTYPE room [<!ENTITY % a SYSTEM 'http://example.org/a'>%a;]><room/>",
        "<!DOCTYPE room><room version='1'>" PLAN "</room>",
        "<!DOCTYPE",
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct outcome outcome = parse_text(files[i]);
        assert_int_equal(outcome.status, PP_BAD_INPUT);
        assert_int_equal(outcome.mistakes, 1);
        assert_int_equal(outcome.rooms, 0);
        if (i < 6)
            assert_non_null(strstr(outcome.text, "DOCTYPE"));
    }
}

/* An XInclude element is an unknown element: the other file is not read. */
static void no_other_file_is_included(void **state)
{
    (void)state;
    char path[] = "/tmp/pepperpot-included-XXXXXX", text[512];
    int file = mkstemp(path);
    assert_true(file >= 0);
    assert_true(write(file, PLAN, sizeof PLAN - 1) == sizeof PLAN - 1);
    close(file);
    snprintf(text, sizeof text,
             "<room version='1'><xi:include href='%s' parse='xml'"
             " xmlns:xi='http://www.w3.org/2001/XInclude'/></room>",
             path);
    struct outcome outcome = parse_text(text);
    unlink(path);
    assert_int_equal(outcome.status, PP_BAD_INPUT);
    assert_non_null(strstr(outcome.text, "a room file has no namespaces"));
    assert_true(outcome.mistakes
                >= 2); /* include is not an element, and there is no plan */
}

/* A mistake is reported at its cause, not at the position where reading stopped. */
static void malformed_xml_is_named_with_its_line(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int line;
        const char *words;
    } files[] = {
        {"<room version='1'>" PLAN "\n<a>\n<b><c><d><e><f><g>\n<h/></g></f></e></d></c>"
         "</b></a></room>",
         4, "elements are nested more than 8 levels deep"},
        {"<room version='1'>\n" PLAN "\n<!-- a\n b", 3, "a comment <!-- has no end"},
        {"<room version='1'>\n<![CDATA[\n", 2, "a <![CDATA[ has no end"},
        {"<room version='1'>\n<plan\n width='4\n depth='5'/></room>", 4,
         "expected a space"},
        {"<room version='1'>\n<plan\n width='4\n depth=5/>\n<point/></room>", 3,
         "a missing quotation mark"},
        {"<room version='1'>\n<plan width='4'\n depth='5\n", 2,
         "the file ends inside the tag"},
        {"<room version='1'>\n<plan width='4' width='5'/></room>", 2,
         "the attribute \"width\" is given twice"},
        {"<room version='1'>\n<plan width='&#xFFFFFFFF;'/></room>", 2,
         "this character reference &#...;"},
        {"<room version='1'>\r\n\r\n<plan width='4'\r\n depth='x' height='2'/></room>",
         4, "depth is \"x\""},
        {"<room version='1'>\n<plan width='&#49;\n'\n depth='x' height='2'/></room>", 4,
         "depth is \"x\""},
        {"<room version='1'>" PLAN "\n <!-- \n -->\n  B\xC3\xBCro\n </room>", 4,
         "text \"B\xC3\xBCro\""},
        {"<room version='1'>" PLAN "\n <![CDATA[\n x\n]]>\n </room>", 3, "text \"x\""},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct outcome outcome = parse_text(files[i].text);
        assert_int_equal(outcome.status, PP_BAD_INPUT);
        if (outcome.line != files[i].line || !strstr(outcome.text, files[i].words))
            fail_msg("%s: line %d: %s", files[i].text, outcome.line, outcome.text);
    }
}

/* Writes to `sink` until the reader closes it, then reports the number of bytes. */
static void write_nesting_for_ever(int sink, int tell)
{
    char chunk[30000];
    long bytes = 0;
    for (size_t i = 0; i < sizeof chunk; i += 3)
        memcpy(chunk + i, "<a>", 3);
    signal(SIGPIPE, SIG_IGN);
    for (ssize_t n; (n = write(sink, chunk, sizeof chunk)) > 0;)
        bytes += n;
    _exit(write(tell, &bytes, sizeof bytes) == sizeof bytes ? 0 : 1);
}

static void endless_input_is_left_at_the_limit_of_size(void **state)
{
    (void)state;
    int data[2], count[2];
    assert_int_equal(pipe(data), 0);
    assert_int_equal(pipe(count), 0);
    pid_t writer = fork();
    assert_true(writer >= 0);
    if (writer == 0) {
        close(data[0]);
        write_nesting_for_ever(data[1], count[1]);
    }
    close(data[1]);
    int input = dup(STDIN_FILENO);
    dup2(data[0], STDIN_FILENO);
    close(data[0]);

    struct pp_building *building;
    struct pp_mistakes mistakes;
    struct pp_error err = {0};
    pp_mistakes_init(&mistakes, "standard input");
    clock_t start = clock();
    assert_int_equal(pp_building_read(&building, "-", &mistakes, &err), PP_BAD_INPUT);
    assert_true((double)(clock() - start) / CLOCKS_PER_SEC <= seconds_allowed());
    dup2(input, STDIN_FILENO); /* only the child still reads the pipe */
    close(input);
    assert_null(building);
    assert_int_equal(mistakes.count, 1);
    assert_non_null(strstr(mistakes.list[0].text, "larger than 8 MiB"));
    pp_mistakes_clear(&mistakes);

    long written = 0;
    assert_int_equal(read(count[0], &written, sizeof written), sizeof written);
    close(count[0]);
    close(count[1]);
    assert_int_equal(waitpid(writer, NULL, 0), writer);
    /* Bytes read, and those still in the pipe (64 KiB, and a chunk in progress). */
    assert_true(written <= PP_READ_ELEMENTS_BYTES_MOST + 1 + (1 << 20));
}

/* The tests above used little memory: twice the file and its tree, with a margin. */
/* AddressSanitizer keeps freed memory, so memory is not measured here. */
static void memory_stays_bounded(void **state)
{
    (void)state;
    if (PP_WATCHED)
        skip();
    struct rusage usage;
    assert_int_equal(getrusage(RUSAGE_SELF, &usage), 0);
    assert_true(usage.ru_maxrss < 600 * 1024);
}

static void the_limit_of_size_is_exact(void **state)
{
    (void)state;
    static const char room[] = "<room version='1'>" PLAN "</room>";
    char *text = malloc(PP_READ_ELEMENTS_BYTES_MOST + 1);
    assert_non_null(text);
    memset(text, ' ', PP_READ_ELEMENTS_BYTES_MOST + 1);
    memcpy(text, room, sizeof room - 1);
    struct outcome outcome = parse(text, PP_READ_ELEMENTS_BYTES_MOST);
    assert_int_equal(outcome.status, PP_OK);
    assert_int_equal(outcome.rooms, 1);
    outcome = parse(text, PP_READ_ELEMENTS_BYTES_MOST + 1);
    assert_int_equal(outcome.status, PP_BAD_INPUT);
    assert_non_null(strstr(outcome.text, "larger than 8 MiB"));
    free(text);
}

/* Some parsers store line numbers in 16 bits. */
static void lines_beyond_65535_are_counted_rightly(void **state)
{
    (void)state;
    char *lines = repeated("", "\n", "", 69999);
    size_t size = strlen(lines) + 1024;
    char *text = malloc(size);
    assert_non_null(text);

    snprintf(text, size,
             "<room version='1'>" PLAN "%s<window wall='south' left='1'\n"
             "  sill='1' width='1'\n  height='high'/></room>",
             lines);
    struct outcome outcome = parse_text(text);
    assert_int_equal(outcome.mistakes, 1);
    assert_int_equal(outcome.line, 70002);
    assert_non_null(strstr(outcome.text, "height is \"high\""));

    snprintf(text, size, "<room version='1'>" PLAN "%s</building>", lines);
    outcome = parse_text(text);
    assert_int_equal(outcome.line, 70000);
    assert_non_null(strstr(outcome.text, "to close the element on line 1"));

    snprintf(text, size, "<room version='1'>" PLAN "%s<point x='1'\ny='2'/></room>",
             lines);
    struct pp_building *building;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "long.xml");
    assert_int_equal(pp_building_parse(&building, text, strlen(text), &mistakes, NULL),
                     PP_OK);
    assert_int_equal(pp_building_room(building, 0)->receivers[0].line, 70000);
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
    free(text);
    free(lines);
}

static const char sample[] =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<!-- B\xC3\xBCro -->\n"
    "<room version=\"1\" name=\"B\xC3\xBCro &amp; Flur\" north='12.5'>\n"
    "  <site latitude=\"51.5\" surroundings=\"urban\" ground-level=\"-1\"/>\n"
    "  <sky type=\"iso-7\" sun-altitude=\"30\" sun-bearing=\"170\"/>\n"
    "  <envelope>\n"
    "    <face role=\"floor\" name=\"f\"><vertex x=\"0\" y=\"0\" z=\"0\"/>\n"
    "      <vertex x=\"1\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"1\" z=\"0\"/></face>\n"
    "    <face role=\"wall\" name=\"a\"><vertex x=\"0\" y=\"0\" z=\"0\"/>\n"
    "      <vertex x=\"0\" y=\"0\" z=\"1\"/><vertex x=\"1\" y=\"0\" z=\"0\"/></face>\n"
    "    <face role=\"wall\" name=\"b\"><vertex x=\"0\" y=\"0\" z=\"0\"/>\n"
    "      <vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></face>\n"
    "    <face role=\"ceiling\" name=\"c\"><vertex x=\"1\" y=\"0\" z=\"0\"/>\n"
    "      <vertex x=\"0\" y=\"0\" z=\"1\"/><vertex x=\"0\" y=\"1\" z=\"0\"/></face>\n"
    "  </envelope>\n"
    "  <finishes floor=\"oak-floor\" walls=\"0.6\"/><finish wall=\"a\" "
    "reflectance=\"light\"/>\n"
    "  <opening glazing=\"clear-double\" maintenance=\"auto\">\n"
    "    <vertex x=\".1\" y=\"0\" z=\".1\"/><vertex x=\".1\" y=\"0\" z=\".2\"/>\n"
    "    <vertex x=\"2e-1\" y=\"0\" z=\".1\"/></opening>\n"
    "  <block x=\"9\" y=\"9\" width=\"1\" depth=\"1\" height=\"1\"/>\n"
    "  <line from=\"0.1 0.1\" to=\"0.2 0.1\" points=\"3\"/>\n"
    "</room>";

static void a_file_cut_anywhere_is_refused_for_that_alone(void **state)
{
    (void)state;
    size_t length = sizeof sample - 1;
    assert_int_equal(parse(sample, length).status, PP_OK);
    for (size_t cut = 0; cut < length; cut += PP_SIZED(1, 1, 3)) {
        struct outcome outcome = parse(sample, cut);
        assert_int_equal(outcome.status, PP_BAD_INPUT);
        assert_int_equal(outcome.rooms, 0);
        if (outcome.mistakes != 1)
            fail_msg("cut at %zu: %d mistakes, %s", cut, outcome.mistakes,
                     outcome.text);
        assert_true(outcome.line >= 1);
    }
}

/* With any single byte changed, reading ends with a result. */
static void any_single_byte_may_be_replaced_by_a_dangerous_one(void **state)
{
    (void)state;
    static const char dangerous[] = {'\0', '<', '>', '"', '&', '/', '=', '\n', '\xFF'};
    char bytes[sizeof sample];
    for (size_t k = 0; k < sizeof dangerous; k++)
        for (size_t i = 0; i < sizeof sample - 1; i += PP_SIZED(1, 1, 7)) {
            memcpy(bytes, sample, sizeof sample);
            bytes[i] = dangerous[k];
            struct outcome outcome = parse(bytes, sizeof sample - 1);
            if (dangerous[k] == '\0' || dangerous[k] == '\xFF')
                assert_int_equal(outcome.status, PP_BAD_INPUT);
        }
}

/* An unreadable file is reported as such, not as a mistake in its contents. */
static void an_unreadable_file_is_reported_as_such(void **state)
{
    (void)state;
    struct pp_building *building;
    struct pp_mistakes mistakes;
    struct pp_error err = {0};
    pp_mistakes_init(&mistakes, "x");
    assert_int_equal(pp_building_read(&building, "no such.xml", &mistakes, &err),
                     PP_BAD_INPUT);
    assert_null(building);
    assert_non_null(strstr(err.message, "no such.xml: cannot be opened"));
    assert_int_equal(pp_building_read(&building, "/", &mistakes, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "/: cannot be read"));
    assert_int_equal(mistakes.count, 0);
    pp_mistakes_clear(&mistakes);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(large_files_take_linear_time),
        cmocka_unit_test(entities_are_neither_expanded_nor_fetched),
        cmocka_unit_test(no_other_file_is_included),
        cmocka_unit_test(malformed_xml_is_named_with_its_line),
        cmocka_unit_test(endless_input_is_left_at_the_limit_of_size),
        cmocka_unit_test(the_limit_of_size_is_exact),
        cmocka_unit_test(lines_beyond_65535_are_counted_rightly),
        cmocka_unit_test(a_file_cut_anywhere_is_refused_for_that_alone),
        cmocka_unit_test(any_single_byte_may_be_replaced_by_a_dangerous_one),
        cmocka_unit_test(an_unreadable_file_is_reported_as_such),
        cmocka_unit_test(memory_stays_bounded),
    };
    add_tests(tests, NULL, NULL);
}
