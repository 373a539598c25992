/* test_explain.c - recalculates the output of --explain: every formula of every method,
 * in every example room, from the figures printed above it, in text and in JSON. Runs
 * ./pepperpot. */
#include "tests/lib/near.h"

#include <glob.h>
#include <json.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/lib/interval_formula.h"
#include "tests/lib/sized.h"

/* ---- runs of the program ---- */

static char *run(const char *const words[])
{
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    pid_t pid = fork();
    assert_true(pid >= 0);
    if (pid == 0) {
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        close(ends[1]);
        setenv("LC_ALL", "C", 1);
        execv("./pepperpot", (char **)words);
        _exit(127);
    }
    close(ends[1]);
    FILE *out = fdopen(ends[0], "r");
    char *text = NULL;
    size_t size = 0;
    ssize_t length = getdelim(&text, &size, EOF, out);
    int status;
    fclose(out);
    assert_int_equal(waitpid(pid, &status, 0), pid);
    if (status != 0 || length <= 0)
        fail_msg("pepperpot %s %s failed", words[1], words[2]);
    return text;
}

/* ---- one step recalculated ---- */

/* An explained calculation: the figures printed so far, for the formulae below them. */
struct sheet {
    struct figures figures;
    char of[512]; /* place and method, for messages */
    int formulae; /* number of formulae recalculated */
};

static void begin(struct sheet *sheet, const char *of)
{
    sheet->figures.count = 0;
    snprintf(sheet->of, sizeof sheet->of, "%s", of);
}

/* Recalculates the next step from the figures above it, each known to its printed
 * digits. The printed value must be in the interval of the formula's results, and the
 * interval must be narrow: 1 %, or ten units of the fourth decimal, the coarsest
 * precision of printed figures. */
static void recompute(struct sheet *sheet, const char *symbol, const char *formula,
                      struct interval printed)
{
    char message[128];
    struct interval again;
    if (formula[0]) {
        if (!formula_evaluate(&again, formula, &sheet->figures, message))
            fail_msg("%s: %s = %s: %s", sheet->of, symbol, formula, message);
        double rounding = 1e-12 * (fabs(again.low) + fabs(again.high));
        if (!(again.low - rounding <= printed.high
              && printed.low <= again.high + rounding))
            fail_msg("%s: %s = %s comes to %.9g ... %.9g, printed is %.9g", sheet->of,
                     symbol, formula, again.low, again.high,
                     (printed.low + printed.high) / 2.0);
        double wide = again.high - again.low,
               value = fabs(printed.low + printed.high) / 2.0;
        if (wide > 0.01 * value && wide > 1e-3)
            fail_msg("%s: %s = %s: by what is printed it may be %.9g ... %.9g",
                     sheet->of, symbol, formula, again.low, again.high);
        sheet->formulae++;
    }
    if (symbol[0])
        figures_add(&sheet->figures, symbol, printed);
}

/* ---- JSON ---- */

static const char *word_of(struct json_object *object, const char *key)
{
    struct json_object *value;
    return json_object_object_get_ex(object, key, &value)
               ? json_object_get_string(value)
               : "";
}

/* Ten significant digits are printed, without trailing zeros. */
static struct interval json_figure(double value)
{
    double half = value != 0.0 ? 0.5 * pow(10.0, floor(log10(fabs(value))) - 9.0) : 0.0;
    return (struct interval){value - half, value + half};
}

/* Steps of an entry; the last figure called SC, IRC or DF is the value of the entry. */
static void check_entry(struct sheet *sheet, const char *of, struct json_object *entry,
                        const char *total)
{
    struct json_object *steps, *value;
    if (!json_object_object_get_ex(entry, "steps", &steps))
        return;
    begin(sheet, of);
    double last = NAN;
    for (size_t i = 0; i < json_object_array_length(steps); i++) {
        struct json_object *step = json_object_array_get_idx(steps, i);
        assert_true(json_object_object_get_ex(step, "value", &value));
        double printed = json_object_get_double(value);
        recompute(sheet, word_of(step, "symbol"), word_of(step, "formula"),
                  json_figure(printed));
        if (strcmp(word_of(step, "symbol"), total) == 0)
            last = printed;
    }
    assert_true(json_object_object_get_ex(entry, "value", &value));
    assert_near(last, json_object_get_double(value), 1e-9 * (1.0 + fabs(last)));
}

/* All entries of a point or of the average. */
static void check_components(struct sheet *sheet, const char *of,
                             struct json_object *place)
{
    static const char *const names[][2] = {{"sc", "SC"}, {"irc", "IRC"}, {"df", "DF"}};
    for (int c = 0; c < 3; c++) {
        struct json_object *component;
        if (!json_object_object_get_ex(place, names[c][0], &component))
            continue;
        json_object_object_foreach(component, method, entry)
        {
            char whose[256];
            snprintf(whose, sizeof whose, "%s, %s by %s", of, names[c][0], method);
            check_entry(sheet, whose, entry, names[c][1]);
        }
    }
}

static void check_json(struct sheet *sheet, const char *of, struct json_object *room)
{
    struct json_object *points, *average;
    assert_true(json_object_object_get_ex(room, "points", &points));
    for (size_t i = 0; i < json_object_array_length(points); i++)
        check_components(sheet, of, json_object_array_get_idx(points, i));
    assert_true(json_object_object_get_ex(room, "average", &average));
    check_components(sheet, of, average);
}

/* ---- text ---- */

enum { HEAD = 2, SYMBOL = 6, MORE = 10, WHAT = 15 };

/* The number at the end of a line, before its unit; empty if there is none. Returns true
 * if the line ends with a unit. */
static bool value_of(char digits[32], const char *line)
{
    const char *end = line + strlen(line);
    static const char *const units[] = {" %", " deg", " m2", " lx", " m"};
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        size_t length = strlen(units[i]);
        if (end - line > (int)length && strncmp(end - length, units[i], length) == 0) {
            end -= length;
            break;
        }
    }
    bool has_unit = *end;
    const char *start = end;
    while (start > line && strchr("0123456789.-", start[-1]))
        start--;
    snprintf(digits, 32, "%.*s", (int)(end - start), start);
    return has_unit;
}

/* Recalculates the steps in a report's text: formula lines begin in the column of
 * symbols and contain " = ", their continuation is indented; the next line ends with
 * the value. */
static void check_text(struct sheet *sheet, const char *of, char *text)
{
    char symbol[32] = "", formula[256] = "", digits[32];
    bool on_sheet = false, open = false;
    for (char *line; (line = strsep(&text, "\n")) != NULL;) {
        size_t indent = strspn(line, " ");
        if (!line[0] || indent < SYMBOL) {
            if (indent == HEAD && strstr(line, " by ")) {
                char whose[512];
                snprintf(whose, sizeof whose, "%s, text, %s", of, line + indent);
                begin(sheet, whose);
                on_sheet = true;
            } else if (!line[0]) {
                on_sheet = false;
            }
            continue;
        }
        if (!on_sheet)
            continue;
        char *equals = strstr(line, " = ");
        if (indent == SYMBOL && equals) {
            int length = (int)(equals - line) - SYMBOL; /* -1: no symbol */
            snprintf(symbol, sizeof symbol, "%.*s", length > 0 ? length : 0,
                     line + SYMBOL);
            snprintf(formula, sizeof formula, "%s", equals + 3);
            open = true;
        } else if (open && indent == MORE) {
            size_t length = strlen(formula);
            snprintf(formula + length, sizeof formula - length, " %s", line + indent);
        } else if (indent == WHAT + 2) {
            continue; /* more words of the meaning */
        } else {
            bool has_unit = value_of(digits, line);
            if (!digits[0])
                fail_msg("%s: a step without a value: %s", sheet->of, line);
            if (!open)
                snprintf(symbol, sizeof symbol, "%.*s",
                         indent == SYMBOL ? (int)strcspn(line + SYMBOL, " ") : 0,
                         line + SYMBOL);
            /* Counts, whole or in tenths, are not rounded; a plain 0 is less than
             * 1e-7. */
            struct interval printed = figure_as_printed(digits);
            const char *point = strchr(digits, '.');
            if (!point || (strlen(point + 1) == 1 && !has_unit))
                printed.low = printed.high = strtod(digits, NULL);
            if (strcmp(digits, "0") == 0)
                printed = (struct interval){-1e-7, 1e-7};
            recompute(sheet, symbol, open ? formula : "", printed);
            open = false;
            formula[0] = symbol[0] = '\0';
        }
    }
}

/* ---- all example rooms ---- */

/* The middle one of a room's reference points, in the format of --points. */
static void middle_point(char point[64], struct json_object *room)
{
    struct json_object *points, *at;
    double xyz[3];
    assert_true(json_object_object_get_ex(room, "points", &points));
    struct json_object *middle =
        json_object_array_get_idx(points, json_object_array_length(points) / 2);
    static const char *const names[] = {"x", "y", "z"};
    for (int i = 0; i < 3; i++) {
        assert_true(json_object_object_get_ex(middle, names[i], &at));
        xyz[i] = json_object_get_double(at);
    }
    snprintf(point, 64, "%.9g,%.9g,%.9g", xyz[0], xyz[1], xyz[2]);
}

/* One room at its middle point, in text and, if requested, in JSON. */
static void check_room(struct sheet *sheet, const char *path, struct json_object *room,
                       bool in_json)
{
    char point[64], of[256];
    const char *name = word_of(room, "room");
    middle_point(point, room);
    snprintf(of, sizeof of, "%s", name);
    struct json_object *points;
    assert_true(json_object_object_get_ex(room, "points", &points));
    enum { FIXED = 8 };
    const char *words[FIXED + 5] = {"pepperpot", "df",       "--explain", "--methods",
                                    "all",       "--format", "json",      path};
    int count = FIXED;
    if (json_object_array_length(points) > 1) {
        words[count++] = "--points";
        words[count++] = point;
    }
    if (name[0]) {
        words[count++] = "--room";
        words[count++] = name;
    }
    if (in_json) {
        char *text = run(words);
        struct json_object *answer = json_tokener_parse(text);
        if (json_object_is_type(answer, json_type_array))
            check_json(sheet, of, json_object_array_get_idx(answer, 0));
        else
            check_json(sheet, of, answer);
        json_object_put(answer);
        free(text);
    }
    words[6] = "text";
    char *text = run(words);
    check_text(sheet, of, text);
    free(text);
}

/* Counts the formulae recalculated in a file's rooms; every third room under
 * sanitizers, where a run of the program takes a quarter of a second. */
static int check_file(const char *path, bool in_json)
{
    struct sheet *sheet = calloc(1, sizeof *sheet);
    assert_non_null(sheet);
    const char *const list[] = {"pepperpot", "df",   "--methods", "average-df",
                                "--format",  "json", path,        NULL};
    char *text = run(list);
    struct json_object *rooms = json_tokener_parse(text);
    free(text);
    if (json_object_is_type(rooms, json_type_array))
        for (size_t i = 0; i < json_object_array_length(rooms); i += PP_SIZED(1, 1, 3))
            check_room(sheet, path, json_object_array_get_idx(rooms, i), in_json);
    else
        check_room(sheet, path, rooms, in_json);
    json_object_put(rooms);
    int formulae = sheet->formulae;
    free(sheet);
    return formulae;
}

static void printed_formulae_recompute_from_printed_figures(void **state)
{
    (void)state;
    char pattern[1024];
    const char *source = getenv("srcdir");
    snprintf(pattern, sizeof pattern, "%s/examples/*.xml", source ? source : ".");
    glob_t files;
    assert_int_equal(glob(pattern, 0, NULL, &files), 0);
    assert_true(files.gl_pathc >= 8);
    for (size_t i = 0; i < files.gl_pathc; i += PP_SIZED(1, 1, 3))
        assert_true(check_file(files.gl_pathv[i], true) >= 4);
    globfree(&files);
}

/* Points that are upright, diffusing panes, skies with a sun, dozens of windows, none.
 */
static void printed_formulae_of_odd_rooms_give_their_values(void **state)
{
    (void)state;
    char path[1024];
    const char *source = getenv("srcdir");
    snprintf(path, sizeof path, "%s/tests/cli/df/explain.xml", source ? source : ".");
    assert_true(check_file(path, false) >= PP_SIZED(100, 100, 25));
}

/* ---- tests of the evaluator ---- */

static const struct figures some = {
    3, {{"A", {2.0, 2.0}}, {"R_fw", {0.5, 0.5}}, {"A", {4.0, 4.0}}}};

static double value_by(const char *formula)
{
    struct interval value;
    char message[128];
    if (!formula_evaluate(&value, formula, &some, message))
        fail_msg("%s: %s", formula, message);
    assert_true(value.low <= value.high);
    return (value.low + value.high) / 2.0;
}

static void formulae_are_read_as_people_read_them(void **state)
{
    (void)state;
    assert_near(value_by("1 + 2 * 3 - 4"), 3.0, 0.0);
    assert_near(value_by("0.85 A / (2 (1 - R_fw)) (3 R_fw + 5)"), 22.1, 1e-14);
    assert_near(value_by("12 / 2 / 3"), 2.0, 1e-15);
    assert_near(value_by("-A^2 + 3 A"), -4.0, 0.0);
    assert_near(value_by("2^3^2"), 512.0, 1e-12);
    assert_near(value_by("atan(tan(33.7))"), 33.7, 1e-12);
    assert_near(value_by("cos(60) sqrt(A) exp(log(7))"), 7.0, 1e-14);
    assert_near(value_by("max(A, 3, -2) min(A, 3) sum(1, 2, 3)"), 72.0, 0.0);
}

static void senseless_formulae_and_unknown_symbols_are_found(void **state)
{
    (void)state;
    static const char *const wrong[] = {"B",      "A +",   "(A",       "A)",
                                        "A / 0",  "2 $ 3", "sin A",    "sin(1, 2)",
                                        "R_fw_2", "",      "max(A, )", "R"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        struct interval value;
        char message[128];
        if (formula_evaluate(&value, wrong[i], &some, message))
            fail_msg("%s was let through", wrong[i]);
    }
}

/* Limits calculated by hand: of (10 +- 0.5)(-1.0 +- 0.05), of the sine from 80 to 100
 * degrees, and of 1/(-1.0 +- 0.05). */
static void intervals_hold_all_that_rounding_allows(void **state)
{
    (void)state;
    struct figures figures = {0};
    figures_add(&figures, "x", figure_as_printed("10"));
    figures_add(&figures, "y", figure_as_printed("-1.0"));
    figures_add(&figures, "a", (struct interval){80.0, 100.0});
    struct interval value;
    char message[128];
    assert_true(formula_evaluate(&value, "x y", &figures, message));
    assert_near(value.low, -10.5 * 1.05, 1e-12);
    assert_near(value.high, -9.5 * 0.95, 1e-12);
    assert_true(formula_evaluate(&value, "sin(a)", &figures, message));
    assert_near(value.low, sin(80.0 * M_PI / 180.0), 1e-15);
    assert_near(value.high, 1.0, 0.0);
    assert_true(formula_evaluate(&value, "1 / y", &figures, message));
    assert_near(value.low, -1.0 / 0.95, 1e-15);
    assert_false(formula_evaluate(&value, "1 / (y + 1)", &figures, message));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(formulae_are_read_as_people_read_them),
        cmocka_unit_test(senseless_formulae_and_unknown_symbols_are_found),
        cmocka_unit_test(intervals_hold_all_that_rounding_allows),
        cmocka_unit_test(printed_formulae_recompute_from_printed_figures),
        cmocka_unit_test(printed_formulae_of_odd_rooms_give_their_values),
    };
    add_tests(tests, NULL, NULL);
}
