/* test_format.c - figures as tables and files have them. */
#include "tests/lib/near.h"

#include <stdio.h>

#include "reports/parts/format.h"

enum { ROOM = 400 };

static void is_as_printf_has_it(double number)
{
    char expected[ROOM], text[ROOM];
    snprintf(expected, sizeof expected, "%.2f", number);
    pp_format_two_decimals(text, sizeof text, number);
    assert_string_equal(text, expected);
}

static void two_decimals_are_those_of_printf(void **state)
{
    (void)state;
    const double numbers[] = {0.0,      0.004999,  0.005, 0.0050001, 0.015, 0.1,
                              0.125,    0.375,     0.5,   1.0,       1.005, 2.675,
                              9.995,    9.9951,    99.99, 100.0,     1e4,   9999.994,
                              9999.995, 12345.678, 1e15,  1e300};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        is_as_printf_has_it(numbers[i]);
        is_as_printf_has_it(-numbers[i]);
    }
    is_as_printf_has_it(-0.001);
    is_as_printf_has_it(INFINITY);
    is_as_printf_has_it(-INFINITY);
    is_as_printf_has_it(NAN);
}

/* All thousandths up to 100, and numbers just beside those that lie halfway. */
static void what_lies_halfway_is_rounded_by_all_of_its_digits(void **state)
{
    (void)state;
    for (int i = 0; i <= 100000; i++) {
        double number = i / 1000.0;
        is_as_printf_has_it(number);
        if (i % 10 != 5)
            continue;
        is_as_printf_has_it(nextafter(number, 0.0));
        is_as_printf_has_it(nextafter(number, INFINITY));
    }
}

static void a_cell_that_is_too_short_keeps_its_end(void **state)
{
    (void)state;
    char text[8] = "       ";
    pp_format_two_decimals(text, 4, 12.34);
    assert_string_equal(text, "12.");
    assert_int_equal(text[4], ' ');
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_decimals_are_those_of_printf),
        cmocka_unit_test(what_lies_halfway_is_rounded_by_all_of_its_digits),
        cmocka_unit_test(a_cell_that_is_too_short_keeps_its_end),
    };
    add_tests(tests, NULL, NULL);
}
