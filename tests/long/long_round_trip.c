/* long_round_trip.c - rooms exported as Radiance scenes have the same daylight factors:
 * those of the tracer to 0.6 %, those of the scene to 1.8 %. */
#include "tests/lib/round_trip.h"

static void every_example_is_as_light_when_it_comes_back(void **state)
{
    (void)state;
    pp_test_examples_beside(0.006);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_example_is_as_light_when_it_comes_back),
    };
    return cmocka_run_group_tests_name("long_round_trip", tests, NULL, NULL);
}
