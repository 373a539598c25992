/* factors.c - chooses among the report's columns: simulation first, then hand
 * methods. */
#include "studies/criteria/factors.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "methods/default_methods.h"
#include "methods/evaluate.h"
#include "studies/criteria/grid/plane_share.h"

static const char traced[] = "traced", formula[] = "average-df";
static const char no_method[] =
    "no hand method gives the daylight factors of this room; use --simulate";

static bool gives_average(const struct pp_report *report, const char *name)
{
    const struct pp_column *column = pp_report_find(report, PP_DF, name);
    return column && isfinite(column->average.value);
}

enum pp_status pp_factors_by_hand(struct pp_report *report, struct pp_error *err)
{
    enum pp_status status = pp_methods_evaluate(report, formula, err);
    return status == PP_OK ? pp_methods_evaluate(
               report, pp_default_methods(report->world, &report->light, NULL, 0).name,
               err)
                           : status;
}

const char *pp_factors_refuse(const struct pp_inquiry *inquiry)
{
    const struct pp_sky *sky = &inquiry->light->sky;
    if (inquiry->rules) /* the rules' sky replaces the room's */
        return NULL;
    bool overcast =
        sky->kind == PP_SKY_OVERCAST || (sky->kind == PP_SKY_ISO && sky->iso == 1);
    return overcast ? NULL
                    : "the criterion is for an overcast sky, but the room has a "
                      "different sky";
}

/* Names the method on which the findings are based, once. */
static void set_basis(struct pp_finding_list *findings, const char *name)
{
    bool simulated = name == traced;
    char words[80];
    snprintf(words, sizeof words, "by %s%s", simulated ? "simulation" : name,
             simulated ? "" : ", not simulated");
    if (!strstr(findings->basis, words))
        pp_finding_list_add_basis(findings, "%s%s", findings->basis[0] ? "; " : "",
                                  words);
}

/* Reason why the column lacks a value at some point; NULL if every point has one. */
static const char *missing(const struct pp_column *column, int count)
{
    for (int i = 0; i < count; i++)
        if (!isfinite(column->points[i].value))
            return column->points[i].why ? column->points[i].why : "not computed";
    return NULL;
}

const struct pp_column *pp_factors_of_grid(const struct pp_inquiry *inquiry,
                                           struct pp_finding_list *findings,
                                           const char **why)
{
    const struct pp_report *report = inquiry->factors;
    *why = pp_factors_refuse(inquiry);
    if (!*why && report->receiver_count == 0)
        *why = inquiry->grid && inquiry->grid->is_too_fine
                   ? "the grid has more than 20000 points; expected a wider spacing"
                   : "no point of the grid is 0.5 m or more from the walls";
    if (*why)
        return NULL;
    const struct pp_column *column = pp_report_find(report, PP_DF, traced);
    if (column) {
        *why = missing(column, report->receiver_count);
        if (!*why)
            set_basis(findings, traced);
        return *why ? NULL : column;
    }
    const char *pair = pp_default_methods(report->world, &report->light, NULL, 0).name;
    column = pp_report_find(report, PP_DF, pair);
    if (column && !missing(column, report->receiver_count)) {
        set_basis(findings, pair);
        return column;
    }
    *why = no_method;
    return NULL;
}

const struct pp_column *pp_factors_average(const struct pp_inquiry *inquiry,
                                           struct pp_finding_list *findings,
                                           const char **why)
{
    const struct pp_report *report = inquiry->factors;
    const char *const names[] = {
        traced, formula,
        pp_default_methods(report->world, &report->light, NULL, 0).name};
    *why = pp_factors_refuse(inquiry);
    for (int i = 0; i < 3 && !*why; i++) {
        if (!gives_average(report, names[i]))
            continue;
        set_basis(findings, names[i]);
        return pp_report_find(report, PP_DF, names[i]);
    }
    if (!*why)
        *why = no_method;
    return NULL;
}

/* Level that a part of the plane reaches if all points are at the lower, or all at the
 * upper, ends of their bands. */
static enum pp_status level_at(double *level, const struct pp_band_ends *bands,
                               const struct pp_receiver *receivers, int count,
                               double part, bool upper, struct pp_error *err)
{
    struct pp_reading *ends = calloc((size_t)count + 1, sizeof *ends);
    struct pp_plane_share share;
    if (!ends)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        ends[i] = pp_reading_of(upper ? bands[i].high : bands[i].low);
    enum pp_status status =
        pp_plane_share(&share, ends, receivers, count, 0.0, part, 0.0, err);
    *level = share.level;
    free(ends);
    return status;
}

enum pp_status pp_factors_band(struct pp_band_ends *band,
                               const struct pp_column *column,
                               const struct pp_receiver *receivers, int count,
                               double part, struct pp_error *err)
{
    *band = pp_band_none();
    for (int i = 0; i < count; i++)
        if (!column->bands || !pp_band_is_known(column->bands[i]))
            return PP_OK;
    enum pp_status status =
        level_at(&band->low, column->bands, receivers, count, part, false, err);
    return status == PP_OK
               ? level_at(&band->high, column->bands, receivers, count, part, true, err)
               : status;
}

enum pp_status pp_factors_grid_error(struct pp_grid_error *error,
                                     const struct pp_inquiry *inquiry,
                                     const struct pp_column *column, double part,
                                     double target, struct pp_error *err)
{
    *error = (struct pp_grid_error){NAN, NAN};
    if (!inquiry->grid || inquiry->grid->count == 0)
        return PP_OK;
    return pp_grid_error(error, inquiry->grid, column->points, part, target, err);
}

/* Returns the probability nearer to 1/2, of two estimates for one event. */
static double less_certain(double a, double b)
{
    return fabs(a - 0.5) < fabs(b - 0.5) ? a : b;
}

void pp_factors_judge_share(struct pp_finding *finding,
                            const struct pp_plane_share *share,
                            const struct pp_grid_error *error, double scale)
{
    double grid = isfinite(error->level) ? scale * error->level : 0.0;
    finding->grid_error = scale * error->level;
    finding->over_error =
        hypot(error->over, isfinite(share->over_error) ? share->over_error : 0.0);
    if (!isfinite(share->probability)) {
        pp_finding_within(finding, grid);
        return;
    }
    double both = hypot(scale * share->std_error, grid);
    double probability = share->probability;
    if (grid > 0.0)
        probability = less_certain(
            probability,
            pp_finding_probability_at_least(finding->figure, both, finding->wanted));
    pp_finding_sampled(finding, both, probability);
}
