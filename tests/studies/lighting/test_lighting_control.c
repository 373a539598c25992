/* test_lighting_control.c - photoelectric controls compared with values calculated by
 * hand. */
#include "tests/lib/near.h"

#include "studies/lighting/lighting_control.h"

static double power_at(const struct pp_lighting_control *control, double E)
{
    bool on = true;
    return pp_lighting_control_power(control, E, &on);
}

/* The lamps are switched on below 310 lx, and off at 480 lx and more; between these
 * levels their state does not change. */
static void a_differential_keeps_the_state_between_two_levels(void **state)
{
    (void)state;
    const struct pp_lighting_control control = {
        .kind = PP_LIGHTING_ON_OFF, .target_lx = 310.0, .differential_lx = 170.0};
    static const double E[] = {0.0, 310.0, 479.9, 480.0, 320.0, 310.0, 309.9, 400.0};
    static const double power[] = {1, 1, 1, 0, 0, 0, 1, 1};
    bool on = true;
    for (int i = 0; i < 8; i++)
        assert_near(pp_lighting_control_power(&control, E[i], &on), power[i], 0.0);
}

static void groups_go_out_at_equal_parts_of_the_target(void **state)
{
    (void)state;
    struct pp_lighting_control control = {
        .kind = PP_LIGHTING_STEPPED, .target_lx = 390.0, .steps = 3};
    assert_near(power_at(&control, 129.9), 1.0, 0.0);
    assert_near(power_at(&control, 130.0), 2.0 / 3.0, 1e-12);
    assert_near(power_at(&control, 259.9), 2.0 / 3.0, 1e-12);
    assert_near(power_at(&control, 260.0), 1.0 / 3.0, 1e-12);
    assert_near(power_at(&control, 390.0), 0.0, 0.0);
    control.steps = 1; /* equivalent to on-off without a differential */
    assert_near(power_at(&control, 389.9), 1.0, 0.0);
    assert_near(power_at(&control, 390.0), 0.0, 0.0);
}

/* A light output of 0.6 is 0.5/0.9 of the way from a tenth of the output, with a
 * quarter of the power, to full output: 0.25 + 0.75 x 0.5/0.9 = 2/3. */
static void dimmed_lamps_supply_what_is_missing(void **state)
{
    (void)state;
    struct pp_lighting_control control = {.kind = PP_LIGHTING_DIMMED,
                                          .target_lx = 500.0,
                                          .residual_light = 0.1,
                                          .residual_power = 0.25};
    assert_near(power_at(&control, 0.0), 1.0, 1e-12);
    assert_near(power_at(&control, 200.0), 2.0 / 3.0, 1e-12);
    assert_near(power_at(&control, 450.0), 0.25, 1e-12);
    assert_near(power_at(&control, 9000.0), 0.25, 0.0);
    control.switches_off = true;
    assert_near(power_at(&control, 449.0), 0.25 + 0.75 * 0.002 / 0.9, 1e-12);
    assert_near(power_at(&control, 451.0), 0.0, 0.0);
    control.residual_light = control.residual_power = 0.0;
    assert_near(power_at(&control, 385.0), 0.23, 1e-12);
}

/* Without standby power, dimmed lamps use at most as much as lamps switched in steps,
 * and these at most as much as lamps that are either all on or all off. */
static void finer_controls_save_more(void **state)
{
    (void)state;
    struct pp_lighting_control control = {.target_lx = 470.0, .steps = 4};
    for (double E = 0.0; E < 600.0; E += 7.3) {
        double power[3];
        for (int kind = PP_LIGHTING_ON_OFF; kind <= PP_LIGHTING_DIMMED; kind++) {
            control.kind = (enum pp_lighting_kind)kind;
            power[kind] = power_at(&control, E);
        }
        assert_true(power[PP_LIGHTING_DIMMED] <= power[PP_LIGHTING_STEPPED] + 1e-12);
        assert_true(power[PP_LIGHTING_STEPPED] <= power[PP_LIGHTING_ON_OFF]);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_differential_keeps_the_state_between_two_levels),
        cmocka_unit_test(groups_go_out_at_equal_parts_of_the_target),
        cmocka_unit_test(dimmed_lamps_supply_what_is_missing),
        cmocka_unit_test(finer_controls_save_more),
    };
    add_tests(tests, NULL, NULL);
}
