/* rule_year.c - rules on a simulated year (studies/year/annual.h): sDA and ASE,
 * illuminances in half of the daylight hours, and hours with an illuminance. */
#include "studies/criteria/rules/rule_year.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "studies/criteria/grid/share_finding.h"
#include "studies/criteria/rules/rule_quantity.h"

struct pp_finding pp_rule_year_share(const struct pp_annual_value *value, double wanted,
                                     bool at_most, const char *what)
{
    struct pp_finding finding =
        pp_finding_of(PP_FIGURE_SHARE, value->value, wanted, at_most, "%s", what);
    if (value->std_error > 0.0) {
        double reaches =
            pp_finding_probability_at_least(value->value, value->std_error, wanted);
        pp_finding_sampled(&finding, value->std_error,
                           at_most ? 1.0 - reaches : reaches);
    }
    return finding;
}

const char *pp_rule_year_missing(const struct pp_inquiry *inquiry)
{
    const struct pp_annual_sheet *year = inquiry->year;
    return !year ? "no year was simulated for this room; expected --weather FILE.epw, "
                   "no --by-hand, and space for points 0.5 m from the walls"
           : !year->finished           ? "the simulation of the year was interrupted"
           : year->receiver_count == 0 ? "no point of the grid is far enough from the "
                                         "walls"
                                       : NULL;
}

enum pp_status pp_rule_year_level(struct pp_finding *finding,
                                  const struct pp_inquiry *inquiry, double lux,
                                  double part, const char *what, struct pp_error *err)
{
    const struct pp_annual_sheet *year = inquiry->year;
    int count = year->receiver_count;
    struct pp_column column = {.common = 1.0};
    column.points = calloc((size_t)count + 1, sizeof *column.points);
    if (!column.points)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++) {
        column.points[i] = pp_reading_of(year->points[i].median_lx.value);
        column.points[i].std_error = year->points[i].median_lx.std_error;
    }
    const struct pp_share_target target = {PP_FIGURE_LUX, lux, part};
    enum pp_status status = pp_share_finding(finding, &target, &column, year->receivers,
                                             count, inquiry->year_grid, what, err);
    free(column.points);
    return status;
}

static enum pp_status add_missing_year(const struct pp_inquiry *inquiry,
                                       const char *what,
                                       struct pp_finding_list *findings,
                                       struct pp_error *err)
{
    struct pp_finding none =
        pp_finding_not_judged(pp_rule_year_missing(inquiry), "%s", what);
    return pp_finding_list_add(findings, &none, err);
}

/* Names the points of the year in the basis of the findings, once. */
static void add_year_basis(const struct pp_inquiry *inquiry,
                           struct pp_finding_list *findings)
{
    char words[PP_PLANE_GRID_WORDS];
    if (!inquiry->year_grid)
        return;
    pp_plane_grid_words(words, inquiry->year_grid);
    if (!strstr(findings->basis, words))
        pp_finding_list_add_basis(findings,
                                  "%ssimulated for every hour of a year, as by annual, "
                                  "on %s",
                                  findings->basis[0] ? "; " : "", words);
}

/* Adds the finding on `value`, sDA or ASE of LM-83: a fraction of the plane. */
static enum pp_status add_lm83(const struct pp_rule *rule,
                               const struct pp_inquiry *inquiry,
                               const struct pp_annual_value *value, bool at_most,
                               const char *what, struct pp_finding_list *findings,
                               struct pp_error *err)
{
    const char *why_not = pp_annual_sheet_leed(inquiry->year).why_not;
    struct pp_finding finding =
        why_not ? pp_finding_not_judged(why_not, "%s", what)
                : pp_rule_year_share(value, 0.01 * rule->threshold, at_most, what);
    add_year_basis(inquiry, findings);
    return pp_finding_list_add(findings, &finding, err);
}

static enum pp_status judge_sda(const struct pp_rule *rule,
                                const struct pp_inquiry *inquiry, const char *what,
                                struct pp_finding_list *findings, struct pp_error *err)
{
    return pp_rule_year_missing(inquiry)
               ? add_missing_year(inquiry, what, findings, err)
               : add_lm83(rule, inquiry, &inquiry->year->plane.sda, false, what,
                          findings, err);
}

static enum pp_status judge_ase(const struct pp_rule *rule,
                                const struct pp_inquiry *inquiry, const char *what,
                                struct pp_finding_list *findings, struct pp_error *err)
{
    return pp_rule_year_missing(inquiry)
               ? add_missing_year(inquiry, what, findings, err)
               : add_lm83(rule, inquiry, &inquiry->year->plane.ase, true, what,
                          findings, err);
}

static enum pp_status judge_year_lux(const struct pp_rule *rule,
                                     const struct pp_inquiry *inquiry, const char *what,
                                     struct pp_finding_list *findings,
                                     struct pp_error *err)
{
    struct pp_finding finding;
    if (pp_rule_year_missing(inquiry))
        return add_missing_year(inquiry, what, findings, err);
    int count = inquiry->year->receiver_count;
    double part = 0.01 * rule->share;
    if (strcmp(rule->bound, "over") == 0)
        part = fmin((floor(part * count + 1e-9) + 1.0) / count, 1.0);
    add_year_basis(inquiry, findings);
    enum pp_status status =
        pp_rule_year_level(&finding, inquiry, rule->threshold, part, what, err);
    return status == PP_OK ? pp_finding_list_add(findings, &finding, err) : status;
}

/* Mean or least illuminance of all points in an hour; 0 if it is not known. */
static double lux_of_hour(const struct pp_annual_sheet *year, int hour, bool least)
{
    double sum = 0.0, low = INFINITY;
    if (!year->hours[hour].known)
        return 0.0;
    for (int i = 0; i < year->receiver_count; i++) {
        double lx = pp_annual_sheet_lx(year, i, hour);
        sum += lx;
        low = fmin(low, lx);
    }
    return least ? low : sum / year->receiver_count;
}

/* Hours of the year in which the mean, or the least, of the points reaches a level,
 * with a small tolerance for the rounding of single-precision illuminances. */
static double hours_reaching(const struct pp_annual_sheet *year, double lux, bool least)
{
    double hours = 0.0;
    for (int h = 0; h < year->hour_count; h++)
        if (lux_of_hour(year, h, least) >= lux * (1.0 - 1e-6))
            hours += year->hours[h].length_h;
    return hours;
}

/* Relative standard error of the year's sum of illuminance: of the mean over the points
 * or, if `least`, the largest error of a point. */
static double year_noise(const struct pp_annual_sheet *year, bool least)
{
    double worst = 0.0;
    if (!least)
        return year->mean.year_lxh.value > 0.0
                   ? year->mean.year_lxh.std_error / year->mean.year_lxh.value
                   : 0.0;
    for (int i = 0; i < year->receiver_count; i++)
        if (year->points[i].year_lxh.value > 0.0)
            worst = fmax(worst, year->points[i].year_lxh.std_error
                                    / year->points[i].year_lxh.value);
    return worst;
}

/* Noise shifts the illuminances of all hours alike. The error of the hours is therefore
 * half the difference between the hours at two levels, one standard error below and
 * above lux. */
static enum pp_status add_hours(const struct pp_rule *rule,
                                const struct pp_inquiry *inquiry, bool least,
                                const char *what, struct pp_finding_list *findings,
                                struct pp_error *err)
{
    const struct pp_annual_sheet *year = inquiry->year;
    if (pp_rule_year_missing(inquiry))
        return add_missing_year(inquiry, what, findings, err);
    double hours = hours_reaching(year, rule->lux, least);
    double noise = year_noise(year, least);
    double error = 0.5
                   * (hours_reaching(year, rule->lux * (1.0 - noise), least)
                      - hours_reaching(year, rule->lux * (1.0 + noise), least));
    struct pp_finding finding =
        pp_finding_of(PP_FIGURE_HOURS, hours, rule->threshold, false, "%s", what);
    if (error > 0.0)
        pp_finding_sampled(
            &finding, error,
            pp_finding_probability_at_least(hours, error, rule->threshold));
    add_year_basis(inquiry, findings);
    return pp_finding_list_add(findings, &finding, err);
}

static enum pp_status judge_mean_hours(const struct pp_rule *rule,
                                       const struct pp_inquiry *inquiry,
                                       const char *what,
                                       struct pp_finding_list *findings,
                                       struct pp_error *err)
{
    return add_hours(rule, inquiry, false, what, findings, err);
}

static enum pp_status judge_least_hours(const struct pp_rule *rule,
                                        const struct pp_inquiry *inquiry,
                                        const char *what,
                                        struct pp_finding_list *findings,
                                        struct pp_error *err)
{
    return add_hours(rule, inquiry, true, what, findings, err);
}

const struct pp_rule_quantity pp_rule_sda = {"sda", judge_sda};
const struct pp_rule_quantity pp_rule_ase = {"ase", judge_ase};
const struct pp_rule_quantity pp_rule_year_lux = {"year-lux", judge_year_lux};
const struct pp_rule_quantity pp_rule_mean_lux_hours = {"mean-lux-hours",
                                                        judge_mean_hours};
const struct pp_rule_quantity pp_rule_least_lux_hours = {"least-lux-hours",
                                                         judge_least_hours};
