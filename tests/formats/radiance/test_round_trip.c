/* test_round_trip.c - rooms exported as Radiance scenes have the same daylight factors.
 * The long test (long_round_trip.c) does the same with a fifth of the error. */
#include "tests/lib/round_trip.h"

static void every_example_is_as_light_when_it_comes_back(void **state)
{
    (void)state;
    pp_test_examples_beside(0.03);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_example_is_as_light_when_it_comes_back),
    };
    add_tests(tests, NULL, NULL);
}
