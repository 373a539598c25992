/* long_tracer_coverage.c - the tracer's values are within their standard errors as
 * often as Student's t predicts: over 200 rooms, and over 60 seeds of 12 rooms. */
#include "tests/lib/random_rooms.h"

static void assert_true_errors(struct pp_coverage c)
{
    print_message("# %d values: %.1f %% within 1, %.1f %% within 2, %.2f %% beyond 4\n",
                  c.count, 100.0 * c.within_1 / c.count, 100.0 * c.within_2 / c.count,
                  100.0 * c.beyond_4 / c.count);
    assert_in_range(1000 * c.within_1 / c.count, 640, 740);
    assert_in_range(1000 * c.within_2 / c.count, 935, 970);
    assert_in_range(1000 * c.beyond_4, 0, 3 * c.count);
}

static void sky_components_of_200_rooms_lie_within_their_errors(void **state)
{
    (void)state;
    assert_true_errors(pp_test_sky_coverage(1000, 200));
}

static void daylight_factors_lie_within_their_errors_over_seeds(void **state)
{
    (void)state;
    assert_true_errors(pp_test_df_coverage(2000, 12, 60));
}

/* Averages of rooms lit by slits, with a target error of 0.5 %: one in ten may have
 * more than twice this error, none more than five times. */
static void the_target_error_is_about_reached_behind_slits(void **state)
{
    (void)state;
    enum { SEEDS = 30 };
    static const char *const rooms[] = {
        "<plan width='4' depth='5' height='2.7'/>"
        "<window wall='south' left='1.97' sill='0.3' width='0.06' height='2.2' "
        "reveal='0.2' glazing='clear-double'/>",
        "<plan width='3' depth='6' height='3'/>"
        "<window wall='west' left='2' sill='1.9' width='1.5' height='0.05' "
        "reveal='0.3'/>",
        "<plan width='5' depth='5' height='3'/>"
        "<window wall='south' left='1' sill='0.2' width='0.1' height='2.4' "
        "reveal='0.4'/>"};
    int missed = 0, count = 0;
    double worst = 0.0;
    for (size_t i = 0; i < sizeof rooms / sizeof *rooms; i++) {
        char xml[600];
        snprintf(xml, sizeof xml, "<room version='1'>%s<point x='2' y='1'/></room>",
                 rooms[i]);
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, xml);
        for (int seed = 1; seed <= SEEDS; seed++, count++) {
            struct pp_tracer_options options = {
                .error = 0.005, .seed = (uint64_t)seed, .average = true};
            struct pp_reading(*traced)[4] =
                pp_test_trace(world, &light, world->receivers, 1, &options, NULL);
            const struct pp_reading *df = &traced[1][PP_DF];
            double times =
                df->std_error / fmax(0.005 * df->value, PP_TRACER_LEAST_ERROR);
            missed += times > 2.0;
            worst = fmax(worst, times);
            free(traced);
        }
        pp_world_destroy(world);
    }
    print_message("# %d of %d averages over twice the error, the worst %.1f times\n",
                  missed, count, worst);
    assert_in_range(missed, 0, count / 10);
    assert_true(worst < 5.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_target_error_is_about_reached_behind_slits),
        cmocka_unit_test(sky_components_of_200_rooms_lie_within_their_errors),
        cmocka_unit_test(daylight_factors_lie_within_their_errors_over_seeds),
    };
    return cmocka_run_group_tests_name("long_tracer_coverage", tests, NULL, NULL);
}
