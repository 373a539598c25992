/* test_progress.c - the progress line of a long calculation. */
#include "tests/lib/near.h"

#include <locale.h>
#include <stdio.h>
#include <stdlib.h>

#include "cli/progress.h"
#include "reports/parts/format.h"

/* The line as printed; the caller frees it. */
static char *line_of(const char *label, double done, double error, double left_s,
                     int columns)
{
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    assert_non_null(out);
    pp_progress_print(out, label, done, error, left_s, columns);
    assert_int_equal(fclose(out), 0);
    return text;
}

static void shows(const char *expected, const char *label, double done, double error,
                  double left_s, int columns)
{
    char *text = line_of(label, done, error, left_s, columns);
    assert_string_equal(text, expected);
    free(text);
}

static void the_line_says_how_far_and_how_long(void **state)
{
    (void)state;
    for (int columns = 80; columns <= 200; columns += 120) {
        shows("Deep office [                        ]   0 %", "Deep office", 0.0, NAN,
              NAN, columns);
        shows("Deep office [============            ]  50 %, 12 s left", "Deep office",
              0.5, NAN, 11.2, columns);
        shows("Deep office [========================] 100 %, error 2.1 %, 0 s left",
              "Deep office", 1.0, 0.021, 0.0, columns);
    }
}

static void times_are_as_people_say_them(void **state)
{
    (void)state;
    shows("a [                        ]   1 %, 99 s left", "a", 0.013, NAN, 98.9, 80);
    shows("a [                        ]   1 %, 2 min left", "a", 0.013, NAN, 130.0, 80);
    shows("a [                        ]   1 %, 2.5 h left", "a", 0.013, NAN, 9000.0,
          80);
}

/* First the bar is shortened, then the end of the name. */
static void a_narrow_terminal_has_a_shorter_line(void **state)
{
    (void)state;
    shows("Deep office [=====     ]  50 %, 12 s left", "Deep office", 0.5, NAN, 12.0,
          42);
    shows("Deep office  50 %, 12 s left", "Deep office", 0.5, NAN, 12.0, 32);
    shows("Deep off  50 %, error 2.1 %, 12 min left", "Deep office", 0.5, 0.021, 720.0,
          41);
}

/* For any name the line ends before the last column of the terminal: there the next
 * character would begin a new line, which is not erased. */
static void the_line_never_fills_the_terminal(void **state)
{
    (void)state;
    static const char *const labels[] = {
        "", "a", "Wohnküche im Dachgeschoß, Nordseite",
        "An L the other way round, with its window in the short leg", "\33[2J\n\200"};
    for (size_t i = 0; i < sizeof labels / sizeof labels[0]; i++)
        for (int columns = 40; columns < 100; columns++) {
            char *text =
                line_of(labels[i], 0.123, columns % 2 ? 0.12 : NAN, 3e8, columns);
            assert_true(pp_format_utf8_width(text) < columns);
            assert_null(strchr(text, '\n'));
            assert_null(strchr(text, '\33'));
            free(text);
        }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_line_says_how_far_and_how_long),
        cmocka_unit_test(times_are_as_people_say_them),
        cmocka_unit_test(a_narrow_terminal_has_a_shorter_line),
        cmocka_unit_test(the_line_never_fills_the_terminal),
    };
    add_tests(tests, NULL, NULL);
}
