/* test_df_json.c - the JSON of `pepperpot df`: valid, with the documented names, and
 * complete even if the run was interrupted. Runs ./pepperpot. */
#include "tests/lib/near.h"

#include <json.h>
#include <math.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

/* Path of an example; the caller frees it. */
static char *example(const char *name)
{
    char *path;
    const char *source = getenv("srcdir");
    assert_true(asprintf(&path, "%s/examples/%s", source ? source : ".", name) > 0);
    return path;
}

/* A process of ./pepperpot whose standard output is `out`. */
struct run {
    pid_t pid;
    FILE *out;
};

static struct run start(const char *const words[])
{
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    pid_t pid = fork();
    assert_true(pid >= 0);
    if (pid == 0) {
        /* As in a terminal, however the tests are started. */
        signal(SIGINT, SIG_DFL);
        signal(SIGTERM, SIG_DFL);
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        close(ends[1]);
        if (!freopen("/dev/null", "w", stderr))
            _exit(126);
        execv("./pepperpot", (char **)words);
        _exit(127);
    }
    close(ends[1]);
    return (struct run){pid, fdopen(ends[0], "r")};
}

/* Output of a process, parsed as strict JSON; *status as from waitpid. */
static struct json_object *finish(struct run run, int *status)
{
    char *text = NULL;
    size_t size = 0;
    ssize_t length = getdelim(&text, &size, EOF, run.out);
    fclose(run.out);
    assert_int_equal(waitpid(run.pid, status, 0), run.pid);
    assert_true(length > 0);
    struct json_tokener *tokener = json_tokener_new();
    json_tokener_set_flags(tokener, JSON_TOKENER_STRICT | JSON_TOKENER_VALIDATE_UTF8);
    struct json_object *object = json_tokener_parse_ex(tokener, text, (int)length + 1);
    if (json_tokener_get_error(tokener) != json_tokener_success)
        fail_msg("%s", json_tokener_error_desc(json_tokener_get_error(tokener)));
    json_tokener_free(tokener);
    free(text);
    return object;
}

static struct json_object *results(const char *const words[])
{
    int status;
    struct json_object *object = finish(start(words), &status);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 0);
    return object;
}

static struct json_object *member(struct json_object *object, const char *key)
{
    struct json_object *value;
    if (!json_object_object_get_ex(object, key, &value))
        fail_msg("there is no \"%s\"", key);
    return value;
}

static double value_of(struct json_object *components, const char *component,
                       const char *method, const char *key)
{
    return json_object_get_double(
        member(member(member(components, component), method), key));
}

/* Asserts that every entry is an object with a value, or with null and `why`; only
 * simulated values have `se`. */
static void check_entries(struct json_object *components)
{
    static const char *const names[] = {"sc", "erc", "irc", "df"};
    for (int i = 0; i < 4; i++) {
        struct json_object *methods;
        if (!json_object_object_get_ex(components, names[i], &methods))
            continue;
        json_object_object_foreach(methods, method, entry)
        {
            struct json_object *value = member(entry, "value");
            assert_true(value ? json_object_is_type(value, json_type_double)
                                    || json_object_is_type(value, json_type_int)
                              : json_object_get_string_len(member(entry, "why")) > 0);
            bool sampled = json_object_object_get_ex(entry, "se", NULL);
            assert_true(sampled == (value && strcmp(method, "traced") == 0));
        }
    }
}

static void check_room(struct json_object *room)
{
    assert_string_equal(json_object_get_string(member(room, "format")),
                        "pepperpot-df-1");
    member(room, "room");
    member(room, "sky");
    assert_false(json_object_object_get_ex(room, "finished", NULL));
    struct json_object *points = member(room, "points");
    assert_true(json_object_array_length(points) > 0);
    for (size_t i = 0; i < json_object_array_length(points); i++)
        check_entries(json_object_array_get_idx(points, i));
    check_entries(member(room, "average"));
}

static void the_deep_room_has_every_name_of_the_contract(void **state)
{
    (void)state;
    char *file = example("deep-office.xml");
    const char *const words[] = {"pepperpot",
                                 "df",
                                 "--format=json",
                                 "--methods",
                                 "default,exact+split-flux",
                                 "--simulate",
                                 "--samples=16",
                                 file,
                                 NULL};
    struct json_object *room = results(words);
    check_room(room);
    assert_string_equal(json_object_get_string(member(room, "room")), "Deep office");
    assert_string_equal(json_object_get_string(member(room, "sky")), "overcast");
    struct json_object *points = member(room, "points");
    assert_int_equal(json_object_array_length(points), 17);
    struct json_object *first = json_object_array_get_idx(points, 0);
    assert_near(json_object_get_double(member(first, "x")), 1.5, 0.0);
    assert_near(json_object_get_double(member(first, "y")), 0.5, 0.0);
    assert_near(json_object_get_double(member(first, "z")), 0.85, 0.0);

    static const struct {
        const char *component, *method;
    } names[] = {
        {"sc", "exact"},     {"sc", "brs-table"},     {"sc", "traced"},
        {"erc", "exact"},    {"erc", "brs-table"},    {"erc", "traced"},
        {"irc", "bre"},      {"irc", "split-flux"},   {"irc", "traced"},
        {"df", "exact+bre"}, {"df", "brs-table+bre"}, {"df", "exact+split-flux"},
        {"df", "traced"}};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        assert_true(value_of(first, names[i].component, names[i].method, "value")
                    >= 0.0);
    assert_true(value_of(member(room, "average"), "df", "average-df", "value") > 0.0);
    assert_true(value_of(member(room, "average"), "df", "traced", "se") > 0.0);

    /* A pair is the sum of its parts: numbers with two digits before the point are
     * printed to half of 1e-8, and two of them are subtracted here. */
    double sum = value_of(first, "sc", "exact", "value")
                 + value_of(first, "erc", "exact", "value")
                 + value_of(first, "irc", "bre", "value");
    assert_near(value_of(first, "df", "exact+bre", "value"), sum, 1.1e-8);
    json_object_put(room);
    free(file);
}

static void a_building_is_an_array_of_its_rooms(void **state)
{
    (void)state;
    char *file = example("building.xml");
    const char *const words[] = {"pepperpot", "df",  "-f", "json",
                                 "-m",        "all", file, NULL};
    struct json_object *rooms = results(words);
    assert_true(json_object_is_type(rooms, json_type_array));
    assert_int_equal(json_object_array_length(rooms), 4);
    for (size_t i = 0; i < 4; i++)
        check_room(json_object_array_get_idx(rooms, i));
    json_object_put(rooms);
    free(file);
}

static void several_files_are_an_array_with_their_names(void **state)
{
    (void)state;
    char *one = example("deep-office.xml"), *other = example("l-shaped.xml");
    const char *const words[] = {"pepperpot", "df", "-f", "json", one, other, NULL};
    struct json_object *rooms = results(words);
    assert_int_equal(json_object_array_length(rooms), 2);
    for (size_t i = 0; i < 2; i++) {
        struct json_object *room = json_object_array_get_idx(rooms, i);
        check_room(room);
        assert_string_equal(json_object_get_string(member(room, "file")),
                            i == 0 ? one : other);
    }
    json_object_put(rooms);
    free(one);
    free(other);
}

/* True if the process already catches this signal. */
static bool catches(pid_t pid, int signal_number)
{
    char path[64], line[128];
    unsigned long long caught = 0;
    snprintf(path, sizeof path, "/proc/%ld/status", (long)pid);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    while (fgets(line, sizeof line, file))
        sscanf(line, "SigCgt: %llx", &caught);
    fclose(file);
    return caught >> (signal_number - 1) & 1;
}

/* Processor time of the process (s). */
static double busy_s(pid_t pid)
{
    char path[64];
    unsigned long user = 0, system = 0;
    snprintf(path, sizeof path, "/proc/%ld/stat", (long)pid);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    int count =
        fscanf(file, "%*d %*s %*c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %lu %lu",
               &user, &system);
    fclose(file);
    assert_int_equal(count, 2);
    return (double)(user + system) / (double)sysconf(_SC_CLK_TCK);
}

/* Waits until a simulation has results, on any machine: signals are caught when the
 * simulation begins, and results exist long before it has worked for a second. If none
 * has begun after two minutes the test fails. */
static void wait_for_simulation(pid_t pid, int signal_number)
{
    double begun = INFINITY;
    for (int tries = 0; tries < 12000; tries++) {
        if (isinf(begun) && catches(pid, signal_number))
            begun = busy_s(pid);
        if (busy_s(pid) > begun + 1.0)
            return;
        usleep(10000);
    }
    fail_msg("there is no simulation to interrupt");
}

/* Interrupts a run that would take hours, soon after its simulation began. */
static void interrupt(int signal_number, int rooms_wanted, const char *name)
{
    char *file = example(name);
    const char *const words[] = {"pepperpot", "df",  "--format", "json", "--simulate",
                                 "--time",    "10h", file,       NULL};
    struct run run = start(words);
    wait_for_simulation(run.pid, signal_number);
    kill(run.pid, signal_number);
    int status;
    struct json_object *object = finish(run, &status);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 130);

    bool list = json_object_is_type(object, json_type_array);
    int count = list ? (int)json_object_array_length(object) : 1;
    assert_int_equal(count, rooms_wanted);
    for (int i = 0; i < count; i++) {
        struct json_object *room =
            list ? json_object_array_get_idx(object, (size_t)i) : object;
        assert_false(json_object_get_boolean(member(room, "finished")));
        struct json_object *point =
            json_object_array_get_idx(member(room, "points"), 0);
        check_entries(point);
        assert_true(value_of(point, "df", "exact+bre", "value") > 0.0);
        if (i == 0)
            assert_true(value_of(point, "df", "traced", "se") > 0.0);
    }
    json_object_put(object);
    free(file);
}

static void an_interrupted_run_gives_its_results_so_far(void **state)
{
    (void)state;
    interrupt(SIGINT, 1, "deep-office.xml");
}

static void a_terminated_run_of_a_building_keeps_all_its_rooms(void **state)
{
    (void)state;
    interrupt(SIGTERM, 4, "building.xml");
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_deep_room_has_every_name_of_the_contract),
        cmocka_unit_test(a_building_is_an_array_of_its_rooms),
        cmocka_unit_test(several_files_are_an_array_with_their_names),
        cmocka_unit_test(an_interrupted_run_gives_its_results_so_far),
        cmocka_unit_test(a_terminated_run_of_a_building_keeps_all_its_rooms),
    };
    add_tests(tests, NULL, NULL);
}
