/* test_hand_explain.c - the explanations of hand methods for the year, recalculated
 * from their printed digits. */
#include "tests/studies/year/hand/made_hand_year.h"

#include <stdlib.h>

#include "model/results/step_text.h"
#include "tests/lib/interval_formula.h"

/* Recalculates all formulae from the figures printed above them; returns their
 * number. */
static int recompute_steps(const struct pp_steps *steps, const char *name)
{
    struct figures *figures = calloc(1, sizeof *figures);
    int formulae = 0;
    assert_non_null(figures);
    for (int i = 0; i < steps->count; i++) {
        const struct pp_calculation_step *step = &steps->list[i];
        char text[48], message[128];
        struct interval again;
        pp_step_text_value(text, sizeof text, step, false);
        struct interval printed = figure_as_printed(text);
        /* Numbers of hours, and zeros, are printed in full. */
        if (step->value == 0.0
            || (step->unit == PP_UNIT_COUNT && fabs(atof(text) - step->value) < 1e-9))
            printed.low = printed.high = step->value;
        if (step->formula[0]) {
            if (!formula_evaluate(&again, step->formula, figures, message))
                fail_msg("%s: %s = %s: %s", name, step->symbol, step->formula, message);
            if (!(again.low <= printed.high && printed.low <= again.high))
                fail_msg("%s: %s = %s comes to %.9g ... %.9g, printed is %s", name,
                         step->symbol, step->formula, again.low, again.high, text);
            /* Figures are printed to at least four digits; ten of them give 0.5 %. */
            if (again.high - again.low > 0.005 * fabs(printed.low + printed.high)
                                             + (step->unit == PP_UNIT_LUX ? 0.3 : 2e-3))
                fail_msg("%s: %s = %s: by what is printed it may be %.9g ... %.9g",
                         name, step->symbol, step->formula, again.low, again.high);
            formulae++;
        }
        if (step->symbol[0])
            figures_add(figures, step->symbol, printed);
    }
    free(figures);
    return formulae;
}

/* Fills six hours of different clearness, two for each pair of standard skies that
 * four-skies mixes. */
static void fill_mixed_year(struct made_hand_year *year)
{
    static const double clearness[] = {1.0, 1.13, 1.9, 2.7, 4.2, 7.0};
    static const int bins[] = {1, 2, 4, 5, 6, 8};
    made_hand_year_init(year);
    for (int i = 0; i < 6; i++) {
        struct pp_perez_sky sky =
            pp_standard_sky_of(i < 2 ? PP_STANDARD_OVERCAST : PP_STANDARD_TURBID,
                               made_hand_year_sun(14.3 + 7.1 * i, 113.0 + 23.0 * i));
        sky.clearness = clearness[i];
        sky.brightness = 0.17;
        sky.bin = bins[i];
        made_hand_year_add(year, 3 + i / 3, 8.0 + i, sky, 9000.0 + 1700.0 * i,
                           14000.0 * i, 1.0 - 0.13 * i);
    }
}

static void every_hour_and_year_is_recomputed_from_its_digits(void **state)
{
    (void)state;
    struct made_hand_year year;
    struct made_hand_room made;
    fill_mixed_year(&year);
    made_hand_room_init(&made, 30, "all");
    made.options.explain = true;
    for (int i = 0; i < 6; i++) {
        struct pp_hand_year_sheet hand;
        made.options.date = year.hours[i].date;
        made.options.clock_h = year.hours[i].start_h + 0.4;
        assert_int_equal(pp_hand_year_of_room(&hand, &made.room, &year.year,
                                              &made.annual, &made.options, NULL),
                         PP_OK);
        /* Every method of the list applies. */
        assert_null(pp_year_methods[hand.column_count]);
        for (int k = 0; k < hand.column_count; k++) {
            const struct pp_hand_column *column = &hand.columns[k];
            assert_null(column->why);
            assert_true(recompute_steps(&column->hour, column->name) >= 1);
            assert_int_equal(recompute_steps(&column->year, column->name), 6);
        }
        pp_hand_year_sheet_clear(&hand);
    }
    made_hand_room_clear(&made);
}

/* The number of hours in the year's calculation is that of the hours whose own
 * calculation reaches the target; states count with their probability. */
static void year_counts_its_hours(void **state)
{
    (void)state;
    struct made_hand_year year;
    struct made_hand_room made;
    fill_mixed_year(&year);
    made_hand_room_init(&made, 30, "all");
    made.options.explain = true;
    double reached[PP_YEAR_METHODS_MOST] = {0.0}, sums[PP_YEAR_METHODS_MOST] = {0.0};
    struct pp_hand_year_sheet hand = {.columns = NULL};
    for (int i = 0; i < 6; i++) {
        pp_hand_year_sheet_clear(&hand);
        made.options.date = year.hours[i].date;
        made.options.clock_h = year.hours[i].start_h;
        assert_int_equal(pp_hand_year_of_room(&hand, &made.room, &year.year,
                                              &made.annual, &made.options, NULL),
                         PP_OK);
        for (int k = 0; k < hand.column_count; k++) {
            const struct pp_steps *hour = &hand.columns[k].hour;
            const struct pp_calculation_step *E = pp_steps_find(hour, 0, "E");
            const struct pp_calculation_step *p = pp_steps_find(hour, 0, "p");
            if (E) {
                reached[k] += E->value >= 300.0;
                sums[k] += E->value;
                continue;
            }
            double clear_lx = pp_steps_find(hour, 0, "E_c")->value;
            double dull_lx = pp_steps_find(hour, 0, "E_o")->value;
            reached[k] +=
                p->value * (clear_lx >= 300.0) + (1.0 - p->value) * (dull_lx >= 300.0);
            sums[k] += p->value * clear_lx + (1.0 - p->value) * dull_lx;
        }
    }
    for (int k = 0; k < hand.column_count; k++) {
        assert_near(hand.columns[k].points[0].autonomy[0], reached[k] / 6.0, 1e-9);
        assert_near(hand.columns[k].points[0].mean_lx, sums[k] / 6.0, 1e-6);
    }
    pp_hand_year_sheet_clear(&hand);
    made_hand_room_clear(&made);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_hour_and_year_is_recomputed_from_its_digits),
        cmocka_unit_test(year_counts_its_hours),
    };
    add_tests(tests, NULL, NULL);
}
