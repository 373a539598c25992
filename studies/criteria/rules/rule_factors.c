/* rule_factors.c - rules on daylight factors in the room: the mean over the working
 * plane, the value at points, the level over a part of the plane, and the
 * uniformity. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/results/sheets/point_areas.h"
#include "studies/criteria/criteria.h"
#include "studies/criteria/factors.h"
#include "studies/criteria/grid/share_finding.h"
#include "studies/criteria/rules/rule_quantity.h"

static enum pp_status add_unjudged(struct pp_finding_list *findings, const char *why,
                                   const char *what, struct pp_error *err)
{
    struct pp_finding finding = pp_finding_not_judged(why, "%s", what);
    return pp_finding_list_add(findings, &finding, err);
}

/* Adds the finding on one daylight factor: the mean, or the value at a point. */
static enum pp_status add_factor(const struct pp_rule *rule,
                                 const struct pp_reading *reading,
                                 struct pp_band_ends band, const char *what,
                                 struct pp_finding_list *findings, struct pp_error *err)
{
    double wanted = 0.01 * rule->threshold;
    struct pp_finding finding =
        pp_finding_of(PP_FIGURE_FACTOR, reading->value, wanted, false, "%s", what);
    pp_finding_by_hand(&finding, band);
    if (reading->std_error > 0.0)
        pp_finding_sampled(&finding, reading->std_error,
                           pp_finding_probability_at_least(reading->value,
                                                           reading->std_error, wanted));
    return pp_finding_list_add(findings, &finding, err);
}

static enum pp_status judge_mean(const struct pp_rule *rule,
                                 const struct pp_inquiry *inquiry, const char *what,
                                 struct pp_finding_list *findings, struct pp_error *err)
{
    const char *why;
    const struct pp_column *column = pp_factors_average(inquiry, findings, &why);
    return column ? add_factor(rule, &column->average, column->average_band, what,
                               findings, err)
                  : add_unjudged(findings, why, what, err);
}

/* Assesses the point with the lowest daylight factor. */
static enum pp_status judge_point(const struct pp_rule *rule,
                                  const struct pp_inquiry *inquiry, const char *what,
                                  struct pp_finding_list *findings,
                                  struct pp_error *err)
{
    const char *why;
    if (inquiry->world->opening_count == 0) {
        struct pp_finding none = pp_finding_of(
            PP_FIGURE_FACTOR, 0.0, 0.01 * rule->threshold, false, "%s", what);
        pp_finding_note(&none, "the room has no openings");
        return pp_finding_list_add(findings, &none, err);
    }
    if (!inquiry->points || inquiry->points->receiver_count == 0)
        return add_unjudged(findings,
                            strcmp(rule->point, "file") == 0
                                ? "the room file has no point; expected <point> at "
                                  "each work place"
                                : "the room is not a box with windows in one wall, or "
                                  "is 2 m wide or less",
                            what, err);
    struct pp_inquiry of_points = *inquiry;
    of_points.factors = inquiry->points;
    of_points.grid = NULL;
    const struct pp_column *column = pp_factors_of_grid(&of_points, findings, &why);
    if (!column)
        return add_unjudged(findings, why, what, err);
    int least = 0;
    for (int i = 1; i < inquiry->points->receiver_count; i++)
        if (column->points[i].value < column->points[least].value)
            least = i;
    enum pp_status status = add_factor(
        rule, &column->points[least],
        column->bands ? column->bands[least] : pp_band_none(), what, findings, err);
    if (status == PP_OK) {
        const struct pp_vec3 at = inquiry->points->receivers[least].position;
        pp_finding_note(&findings->list[findings->count - 1],
                        "lowest of %d points, at %.2f, %.2f, %.2f m",
                        inquiry->points->receiver_count, at.x, at.y, at.z);
    }
    return status;
}

static enum pp_status judge_share(const struct pp_rule *rule,
                                  const struct pp_inquiry *inquiry, const char *what,
                                  struct pp_finding_list *findings,
                                  struct pp_error *err)
{
    const char *why;
    char grid[PP_PLANE_GRID_WORDS];
    const struct pp_column *column = pp_factors_of_grid(inquiry, findings, &why);
    if (!column)
        return add_unjudged(findings, why, what, err);
    pp_plane_grid_words(grid, inquiry->grid);
    if (!strstr(findings->basis, grid))
        pp_finding_list_add_basis(findings, ", on %s", grid);
    int count = inquiry->factors->receiver_count;
    const struct pp_receiver *receivers = inquiry->factors->receivers;
    bool over = strcmp(rule->bound, "over") == 0, open = isnan(rule->share);
    double part = open ? 0.5 : 0.01 * rule->share;
    if (over && pp_point_areas_differ(receivers, count))
        part += 1e-6; /* any more area */
    else if (over)    /* smallest number of points that exceeds the required fraction */
        part = (floor(part * count + 1e-9) + 1.0) / count;
    const struct pp_share_target target = {PP_FIGURE_FACTOR, 0.01 * rule->threshold,
                                           fmin(part, 1.0)};
    struct pp_finding finding;
    enum pp_status status = pp_share_finding(&finding, &target, column, receivers,
                                             count, inquiry->grid, what, err);
    if (status == PP_OK && open) { /* the rule states no fraction: only the figure is
                                    * stated */
        double over_share = finding.reached_over, error = finding.over_error;
        finding =
            pp_finding_of(PP_FIGURE_SHARE, over_share, NAN, false,
                          "%s, above %g %%: share of the plane", what, rule->threshold);
        finding.std_error = error;
    }
    return status == PP_OK ? pp_finding_list_add(findings, &finding, err) : status;
}

static enum pp_status judge_uniformity(const struct pp_rule *rule,
                                       const struct pp_inquiry *inquiry,
                                       const char *what,
                                       struct pp_finding_list *findings,
                                       struct pp_error *err)
{
    (void)rule;
    int first = findings->count;
    enum pp_status status = pp_criterion_uniformity.evaluate(inquiry, findings, err);
    if (status == PP_OK)
        snprintf(findings->list[first].what, sizeof findings->list[first].what, "%s",
                 what);
    return status;
}

const struct pp_rule_quantity pp_rule_mean_factor = {"mean-df", judge_mean};
const struct pp_rule_quantity pp_rule_point_factor = {"point-df", judge_point};
const struct pp_rule_quantity pp_rule_share_factor = {"share-df", judge_share};
const struct pp_rule_quantity pp_rule_uniformity = {"uniformity", judge_uniformity};
