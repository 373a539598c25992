/* test_hunt_switching.c - Hunt's probability of switching on, compared with values
 * calculated by hand. */
#include "tests/lib/near.h"

#include "studies/lighting/hunt_switching.h"

/* At 10^m lx: a + c/2 = -0.0175 + 0.51805. At 30 lx x - m = -0.34518 and
 * exp(-1.40954) = 0.24426: 1.0361/1.24426 - 0.0175. At 200 lx x - m = 0.47873 and
 * exp(1.95489) = 7.0632: 1.0361/8.0632 - 0.0175. */
static void half_of_the_people_switch_on_at_66_lx(void **state)
{
    (void)state;
    assert_near(pp_hunt_switching_probability(66.421), 0.50055, 1e-5);
    assert_near(pp_hunt_switching_probability(30.0), 0.81520, 1e-5);
    assert_near(pp_hunt_switching_probability(200.0), 0.11100, 1e-5);
}

static void all_switch_on_in_the_dark_and_none_in_bright_light(void **state)
{
    (void)state;
    assert_near(pp_hunt_switching_probability(0.0), 1.0, 0.0);
    assert_near(pp_hunt_switching_probability(6.9), 1.0, 0.0);
    assert_near(pp_hunt_switching_probability(658.0), 0.0, 0.0);
    assert_near(pp_hunt_switching_probability(30000.0), 0.0, 0.0);
}

/* Near its ends the curve is within 0.0001 of 1 and 0. */
static void the_curve_falls_without_steps(void **state)
{
    (void)state;
    double before = 1.0;
    for (double x = 0.5; x < 3.2; x += 0.001) {
        double P = pp_hunt_switching_probability(pow(10.0, x));
        assert_true(P <= before && before - P < 0.0015);
        before = P;
    }
    assert_near(before, 0.0, 0.0);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(half_of_the_people_switch_on_at_66_lx),
        cmocka_unit_test(all_switch_on_in_the_dark_and_none_in_bright_light),
        cmocka_unit_test(the_curve_falls_without_steps),
    };
    add_tests(tests, NULL, NULL);
}
