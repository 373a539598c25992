/* hand_figures.c - see hand_figures.h. */
#include "studies/year/hand/hand_figures.h"

#include <math.h>
#include <stdio.h>

/* Sums over the occupied hours. */
struct hand_sums {
    double reached_h[PP_ANNUAL_ILLUMINANCES_MOST]; /* hours with at least each target
                                                    * illuminance */
    double low_h, good_h, above_h; /* hours with 100 lx or more, with 300 lx or more,
                                    * and with more than 3000 lx */
    double lxh;
};

static void add_state(struct hand_sums *sums, double hours, double lx,
                      const double *illuminances_lx, int illuminance_count)
{
    for (int i = 0; i < illuminance_count; i++)
        sums->reached_h[i] += lx >= illuminances_lx[i] ? hours : 0.0;
    sums->low_h += lx >= 100.0 ? hours : 0.0;
    sums->good_h += lx >= 300.0 ? hours : 0.0;
    sums->above_h += lx > 3000.0 ? hours : 0.0;
    sums->lxh += lx * hours;
}

static void add_share_step(struct pp_steps *steps, const char *symbol,
                           const char *formula, double value, const char *what,
                           double lx)
{
    pp_steps_add_worked(steps, PP_UNIT_DAYLIGHT_FACTOR, value, symbol, formula, what,
                        lx);
}

/* Records the figures as calculated from the sums. */
static void record_year(struct pp_steps *steps, const struct hand_sums *sums,
                        const struct pp_hand_figures *figures, double all_h,
                        const double *illuminances_lx, int illuminance_count)
{
    char symbol[16], formula[64];
    pp_steps_add_named(steps, PP_UNIT_COUNT, all_h, "t", "occupied hours");
    for (int i = 0; i < illuminance_count; i++) {
        snprintf(symbol, sizeof symbol, "t_%d", i + 1);
        pp_steps_add_named(steps, PP_UNIT_COUNT, sums->reached_h[i], symbol,
                           "occupied hours with %g lx or more", illuminances_lx[i]);
        snprintf(formula, sizeof formula, "100 t_%d / t", i + 1);
        snprintf(symbol, sizeof symbol, "DA_%d", i + 1);
        add_share_step(steps, symbol, formula, figures->autonomy[i],
                       "daylight autonomy at %g lx", illuminances_lx[i]);
    }
    pp_steps_add_named(steps, PP_UNIT_COUNT, sums->low_h, "t_a",
                       "occupied hours with 100 lx or more");
    pp_steps_add_named(steps, PP_UNIT_COUNT, sums->good_h, "t_b",
                       "occupied hours with 300 lx or more");
    pp_steps_add_named(steps, PP_UNIT_COUNT, sums->above_h, "t_c",
                       "occupied hours above 3000 lx");
    add_share_step(steps, "U_1", "100 (t - t_a) / t", figures->udi_below,
                   "useful daylight illuminance: below %g lx", 100.0);
    add_share_step(steps, "U_2", "100 (t_a - t_b) / t", figures->udi_low,
                   "useful daylight illuminance: 100 to %g lx", 300.0);
    add_share_step(steps, "U_3", "100 (t_b - t_c) / t", figures->udi_good,
                   "useful daylight illuminance: 300 to %g lx", 3000.0);
    add_share_step(steps, "U_4", "100 t_c / t", figures->udi_above,
                   "useful daylight illuminance: above %g lx", 3000.0);
    pp_steps_add_named(steps, PP_UNIT_COUNT, sums->lxh / 1000.0, "S",
                       "sum of E times hours, klx h");
    pp_steps_add_worked(steps, PP_UNIT_LUX, figures->mean_lx, "E_m", "1000 S / t",
                        "mean illuminance");
}

struct pp_hand_figures pp_hand_figures_none(void)
{
    struct pp_hand_figures none;
    for (int i = 0; i < PP_HAND_FIGURES; i++)
        ((double *)&none)[i] = NAN;
    return none;
}

void pp_hand_figures_of(struct pp_hand_figures *figures, const struct pp_hand_case *of,
                        const struct pp_year_method *method, const void *tools,
                        const struct pp_formulary *formulary, int point,
                        const double *illuminances_lx, int illuminance_count,
                        struct pp_steps *steps)
{
    struct hand_sums sums = {.lxh = 0.0};
    for (int i = 0; i < of->hour_count; i++) {
        const struct pp_hand_hour *hour = &of->hours[i];
        struct pp_worksheet sheet = {.formulary = formulary};
        struct pp_year_states states;
        if (!(hour->occupied_h > 0.0))
            continue;
        method->evaluate(of, tools, point, hour, &sheet, &states);
        for (int k = 0; k < states.count; k++)
            if (isnan(states.list[k].lx)) {
                *figures = pp_hand_figures_none();
                return;
            }
        for (int k = 0; k < states.count; k++)
            add_state(&sums, hour->occupied_h * states.list[k].share, states.list[k].lx,
                      illuminances_lx, illuminance_count);
    }
    double all = of->all_occupied_h;
    *figures = (struct pp_hand_figures){.udi_below = 1.0 - sums.low_h / all,
                                        .udi_low = (sums.low_h - sums.good_h) / all,
                                        .udi_good = (sums.good_h - sums.above_h) / all,
                                        .udi_above = sums.above_h / all,
                                        .mean_lx = sums.lxh / all};
    for (int i = 0; i < illuminance_count; i++)
        figures->autonomy[i] = sums.reached_h[i] / all;
    if (steps)
        record_year(steps, &sums, figures, all, illuminances_lx, illuminance_count);
}

void pp_hand_figures_hour(const struct pp_hand_case *of,
                          const struct pp_year_method *method, const void *tools,
                          const struct pp_formulary *formulary, int point,
                          const struct pp_hand_hour *hour, struct pp_steps *steps)
{
    struct pp_worksheet sheet = {.steps = steps, .formulary = formulary};
    struct pp_year_states states;
    method->evaluate(of, tools, point, hour, &sheet, &states);
}
