/* Figures of a point from its illuminances. */
#include "tests/lib/near.h"

#include "studies/year/blind_groups.h"
#include "studies/year/year_metrics.h"

/* Eight lit hours of twelve occupied ones. */
static double occupied[] = {1, 1, 1, 1, 1, 1, 1, 1};
static double lengths[] = {1, 1, 1, 1, 1, 1, 1, 1};
static bool daylight[] = {true, true, true, true, true, true, false, false};
static const struct pp_year_clock twelve = {.sky_count = 8,
                                            .occupied_h = occupied,
                                            .length_h = lengths,
                                            .is_daylight = daylight,
                                            .all_occupied_h = 12.0,
                                            .median_rank = 2};
static const float E[] = {100.0f,  99.0f,   300.0f, 299.0f,
                          3000.0f, 3001.0f, 600.0f, 30.0f};
static const float sun[] = {0, 1000.0f, 1001.0f, 0, 0, 2000.0f, 0, 0};

static struct pp_annual_figures figures_of(void)
{
    static const double targets[] = {300.0, 600.0};
    struct pp_annual_figures figures;
    float space[8], zero[8] = {0};
    const struct pp_year_values values = {
        .open = E, .sky = E, .sun = sun, .sun_reflected = zero, .space = space};
    pp_year_metrics_of(&figures, &values, &twelve, targets, 2);
    return figures;
}

static void limits_belong_to_the_bins_that_they_should(void **state)
{
    (void)state;
    struct pp_annual_figures f = figures_of();
    assert_near(f.autonomy[0].value, 4.0 / 12.0, 1e-12); /* 300 counts, 299 does not */
    assert_near(f.autonomy[1].value, 3.0 / 12.0, 1e-12);
    assert_near(f.udi_below.value, 6.0 / 12.0, 1e-12); /* with the four dark hours */
    assert_near(f.udi_low.value, 2.0 / 12.0, 1e-12);
    assert_near(f.udi_good.value, 3.0 / 12.0, 1e-12); /* 3000 is useful */
    assert_near(f.udi_above.value, 1.0 / 12.0, 1e-12);
    assert_near(f.sun_h.value, 2.0, 0.0); /* more than 1000 */
    assert_true(isnan(f.blinds_autonomy.value));
}

/* Relative useful exposure, as DIN 5034 has it: the sum of min(E, target) over target. */
static void continuous_autonomy_gives_part_of_an_hour(void **state)
{
    (void)state;
    double sum = (100.0 + 99.0 + 300.0 + 299.0 + 300.0 + 300.0 + 300.0 + 30.0) / 300.0;
    assert_near(figures_of().continuous[0].value, sum / 12.0, 1e-9);
}

/* Of the six daylight hours the third in rank: 3001, 3000, 300. */
static void the_median_is_of_daylight_hours(void **state)
{
    (void)state;
    assert_near(figures_of().median_lx.value, 300.0, 0.0);
}

/* For a mean the jackknife is the standard error of the mean, s / sqrt(n). */
static void the_jackknife_is_that_of_a_mean(void **state)
{
    (void)state;
    static const double x[] = {3.1, 2.7, 4.4, 3.9, 1.8};
    double without[5], sum = 0.0, squares = 0.0;
    for (int i = 0; i < 5; i++)
        sum += x[i];
    for (int i = 0; i < 5; i++) {
        without[i] = (sum - x[i]) / 4.0;
        squares += (x[i] - sum / 5.0) * (x[i] - sum / 5.0);
    }
    assert_near(pp_year_metrics_error(without, 5), sqrt(squares / 4.0 / 5.0), 1e-12);
    for (int i = 0; i < 5; i++)
        without[i] = 0.1;
    assert_near(pp_year_metrics_error(without, 5), 0.0, 0.0);
}

static void blinds_close_for_more_than_two_per_cent(void **state)
{
    (void)state;
    assert_false(pp_blind_groups_closes(2, 100));
    assert_true(pp_blind_groups_closes(3, 100));
    assert_false(pp_blind_groups_closes(0, 24));
    assert_true(pp_blind_groups_closes(1, 24));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(limits_belong_to_the_bins_that_they_should),
        cmocka_unit_test(continuous_autonomy_gives_part_of_an_hour),
        cmocka_unit_test(the_median_is_of_daylight_hours),
        cmocka_unit_test(the_jackknife_is_that_of_a_mean),
        cmocka_unit_test(blinds_close_for_more_than_two_per_cent),
    };
    add_tests(tests, NULL, NULL);
}
