/* en17037_hours.c - daylight provision as recommended by [EN17037], by its second
 * method: illuminances of every hour of a year.
 *
 * The targets are those of the first method (en17037.c): 300, 500, 750 lx over half of
 * the plane and 100, 300, 500 lx over 95 %; under rooflights 300, 500, 750 lx over 95
 * %. Each target must be reached in half of the daylight hours, that is, in 2190 of the
 * 4380 hours with the greatest diffuse illuminance outside (studies/year/annual.h). A
 * point counts if it reaches the illuminance in that many hours; these hours may differ
 * from point to point. Blinds are open.
 */
#include <stdio.h>
#include <string.h>

#include "studies/criteria/bearing.h"
#include "studies/criteria/criteria.h"
#include "studies/criteria/en17037/en17037_level.h"
#include "studies/criteria/rules/rule_year.h"

/* Adds the finding on an illuminance to be reached on a part of the plane. */
static enum pp_status add_hours_target(const struct pp_inquiry *inquiry, int level,
                                       double lux, double part,
                                       struct pp_finding_list *findings,
                                       struct pp_error *err)
{
    char what[80];
    struct pp_finding finding;
    snprintf(what, sizeof what, "%s: %g lx over %g %%", pp_en17037_level_names[level],
             lux, 100.0 * part);
    enum pp_status status = pp_rule_year_level(&finding, inquiry, lux, part, what, err);
    finding.level = level;
    finding.is_optional = level > PP_EN17037_MINIMUM;
    return status == PP_OK ? pp_finding_list_add(findings, &finding, err) : status;
}

static enum pp_status assess_hours(const struct pp_inquiry *inquiry,
                                   struct pp_finding_list *findings,
                                   struct pp_error *err)
{
    bool rooflights = pp_en17037_level_of_rooflights(inquiry->world);
    const char *why = pp_rule_year_missing(inquiry);
    enum pp_status status = PP_OK;
    if (why) {
        struct pp_finding none =
            pp_finding_not_judged(why, "illuminances in half of the daylight hours");
        return pp_finding_list_add(findings, &none, err);
    }
    for (int level = 1; level <= PP_EN17037_HIGH && status == PP_OK; level++) {
        status = add_hours_target(inquiry, level, pp_en17037_level_target_lx[level],
                                  rooflights ? pp_en17037_level_nearly_all
                                             : pp_en17037_level_half,
                                  findings, err);
        if (status == PP_OK && !rooflights)
            status =
                add_hours_target(inquiry, level, pp_en17037_level_minimum_lx[level],
                                 pp_en17037_level_nearly_all, findings, err);
    }
    if (status != PP_OK)
        return status;
    char grid[PP_PLANE_GRID_WORDS], reached[PP_EN17037_LEVEL_WORDS];
    if (inquiry->year_grid)
        pp_plane_grid_words(grid, inquiry->year_grid);
    else
        snprintf(grid, sizeof grid, "%d points", inquiry->year->receiver_count);
    pp_en17037_level_words(reached, findings);
    pp_finding_list_add_basis(
        findings,
        "by simulation of every hour of %.*s, in 2190 of the 4380 hours with the most "
        "diffuse light (median %.0f lx by Perez's efficacy), on %s, each point by its "
        "own hours. Level reached: %s",
        (int)strcspn(inquiry->year->weather, ";"), inquiry->year->weather,
        inquiry->year->diffuse_median_lx, grid, reached);
    return PP_OK;
}

const struct pp_criterion pp_criterion_en17037_hours = {
    .name = "en17037-hours",
    .title = "EN 17037 daylight provision, method 2",
    .source = "EN17037",
    .summary = "the same illuminances by a simulated year; needs --weather, and is "
               "assessed only if named",
    .of_plane_year = true,
    .bears_on_use = pp_bearing_needs_daylight,
    .evaluate = assess_hours,
};
