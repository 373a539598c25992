/* averages.c - the average daylight factor and its uniformity.
 *
 *   average     1 % in bedrooms, 1.5 % in living rooms, 2 % in kitchens  [BS8206], over
 *               the whole working plane: simulated, else by the formula that the code
 *               gives, `average-df`, else by a pair of hand methods
 *   uniformity  minimum over average: 0.3 in rooms lit from the side, 0.7 under glazed
 *               roofs [BREEAM14], at the points of the grid (plane_grid.h), which
 *               leaves out 0.5 m along the walls
 *
 * A room is under a glazed roof if more than half of the area of its openings slopes
 * less than 75 degrees.
 */
#include <math.h>
#include <string.h>

#include "studies/criteria/bearing.h"
#include "studies/criteria/criteria.h"
#include "studies/criteria/factors.h"
#include "studies/criteria/grid/plane_share.h"

/* Largest ratio of the simulated average to the average by average-df, over all example
 * rooms; see the manual's section on accuracy. */
static const double LOWEST_BY_FORMULA = 1.75;

/* True if the target may be missed only because average-df is too low. */
static bool is_low_by_formula(const struct pp_finding *finding,
                              const struct pp_finding_list *findings)
{
    return strstr(findings->basis, "average-df") && finding->verdict == PP_NOT_MET
           && finding->wanted < LOWEST_BY_FORMULA * finding->figure;
}

static enum pp_status evaluate_average(const struct pp_inquiry *inquiry,
                                       struct pp_finding_list *findings,
                                       struct pp_error *err)
{
    static const struct {
        const char *room;
        enum pp_dwelling_room kind;
        double least;
    } minima[] = {{"bedroom", PP_DWELLING_BEDROOM, 0.01},
                  {"living room", PP_DWELLING_LIVING_ROOM, 0.015},
                  {"kitchen", PP_DWELLING_KITCHEN, 0.02}};
    const char *why;
    const struct pp_column *column = pp_factors_average(inquiry, findings, &why);
    const struct pp_reading *average = column ? &column->average : NULL;
    enum pp_status status = PP_OK;
    int rooms = pp_bearing_dwelling_rooms(inquiry->world->use);
    for (int i = 0; i < 3 && status == PP_OK; i++) {
        if (rooms && !(rooms & minima[i].kind))
            continue;
        struct pp_finding finding =
            pp_finding_not_judged(why ? why : "", "%s", minima[i].room);
        if (average)
            finding = pp_finding_of(PP_FIGURE_FACTOR, average->value, minima[i].least,
                                    false, "%s", minima[i].room);
        if (column)
            pp_finding_by_hand(&finding, column->average_band);
        if (average && average->std_error > 0.0)
            pp_finding_sampled(&finding, average->std_error,
                               pp_finding_probability_at_least(average->value,
                                                               average->std_error,
                                                               minima[i].least));
        if (average && is_low_by_formula(&finding, findings))
            pp_finding_note(&finding,
                            "in some rooms of the manual, average-df is up to 43 %% "
                            "too low: do not rely on this verdict");
        status = pp_finding_list_add(findings, &finding, err);
    }
    return status;
}

static bool has_glazed_roof(const struct pp_world *world)
{
    double roof_m2 = 0.0, all_m2 = 0.0;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        all_m2 += opening->inner.area_m2;
        if (opening->slope_rad < 75.0 * PP_RAD)
            roof_m2 += opening->inner.area_m2;
    }
    return roof_m2 > 0.5 * all_m2;
}

static enum pp_status evaluate_uniformity(const struct pp_inquiry *inquiry,
                                          struct pp_finding_list *findings,
                                          struct pp_error *err)
{
    static const char what[] = "minimum over average";
    const char *why;
    const struct pp_column *column = pp_factors_of_grid(inquiry, findings, &why);
    int count = inquiry->factors->receiver_count;
    const struct pp_receiver *receivers = inquiry->factors->receivers;
    double mean =
        column ? pp_plane_share_mean(column->points, receivers, count, column->common)
                     .value
               : 0.0;
    if (column && !(mean > 0.0))
        why = "no light reaches the plane";
    if (why) {
        struct pp_finding finding = pp_finding_not_judged(why, what);
        return pp_finding_list_add(findings, &finding, err);
    }
    double wanted = has_glazed_roof(inquiry->world) ? 0.7 : 0.3;
    struct pp_plane_share share;
    struct pp_grid_error error;
    enum pp_status status = pp_plane_share(&share, column->points, receivers, count,
                                           column->common, 1.0, wanted * mean, err);
    if (status == PP_OK)
        status =
            pp_factors_grid_error(&error, inquiry, column, 1.0, wanted * mean, err);
    if (status != PP_OK)
        return status;
    struct pp_finding finding =
        pp_finding_of(PP_FIGURE_RATIO, share.level / mean, wanted, false, what);
    pp_factors_judge_share(&finding, &share, &error, 1.0 / mean);
    pp_finding_note(&finding, "minimum %.4g %% and average %.4g %% of %d points",
                    100.0 * share.level, 100.0 * mean, count);
    return pp_finding_list_add(findings, &finding, err);
}

const struct pp_criterion pp_criterion_average = {
    .name = "average",
    .alias = "adf",
    .title = "Average daylight factor in dwellings",
    .source = "BS8206",
    .withdrawn = "BS 8206-2 was withdrawn in 2019, when BS EN 17037 replaced it",
    .summary = "at least 1 % in bedrooms, 1.5 % in living rooms, 2 % in kitchens",
    .of_factors = true,
    .bears_on_use = pp_bearing_is_dwelling,
    .countries = "GB IE",
    .evaluate = evaluate_average,
};

const struct pp_criterion pp_criterion_uniformity = {
    .name = "uniformity",
    .title = "Uniformity",
    .source = "BREEAM14",
    .withdrawn = "later versions of BREEAM replaced the 2014 version",
    .summary = "minimum over average is at least 0.3, or 0.7 under glazed roofs",
    .of_factors = true,
    .bears_on_use = pp_bearing_needs_daylight,
    .evaluate = evaluate_uniformity,
};
