/* assessment.c - chooses criteria, computes the daylight factors they need, and
 * evaluates them one by one. */
#include "studies/bands/report_bands.h"
#include "studies/criteria/assessment.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "studies/criteria/bearing.h"
#include "studies/criteria/capitals.h"
#include "studies/criteria/factors.h"
#include "studies/criteria/grid/plane_trace.h"
#include "studies/criteria/room_before.h"

/* Marks the criteria named in a comma-separated list; NULL: all. */
enum pp_status pp_assessment_choose(bool chosen[PP_CRITERIA_MOST], const char *list,
                                    struct pp_error *err)
{
    const char *names[PP_CRITERIA_MOST];
    int count = 0;
    for (; pp_criteria_at(count); count++) {
        names[count] = pp_criteria_at(count)->name;
        chosen[count] = !list;
    }
    while (list) {
        char word[64];
        snprintf(word, sizeof word, "%.*s", (int)strcspn(list, ","), list);
        int i = 0;
        while (i < count && !pp_criteria_is_called(pp_criteria_at(i), word))
            i++;
        if (i == count)
            return pp_text_unknown(err, word, names, count, NULL,
                                   "there is no criterion \"%s\"", word);
        chosen[i] = true;
        list = strchr(list, ',');
        list = list ? list + 1 : NULL;
    }
    return PP_OK;
}

static void find_median(struct pp_median *median, const struct pp_world *world,
                        const struct pp_assess_options *options)
{
    if (options->median_lux > 0.0) {
        median->lux = options->median_lux;
        snprintf(median->how, sizeof median->how, "%s",
                 options->of_weather ? "from the weather file" : "as given");
    } else if (options->place) {
        const struct pp_capital *capital = pp_capitals_find(options->place);
        median->lux = capital->median_lux;
        snprintf(median->how, sizeof median->how, "%s, as chosen", capital->name);
    } else {
        *median = pp_capitals_median(world->latitude_rad, world->longitude_rad,
                                     world->country);
    }
}

/* Judges by all chosen criteria, or by those of daylight factors alone. */
static enum pp_status judge_criteria(struct pp_assessment *assessment,
                                     const bool chosen[PP_CRITERIA_MOST],
                                     bool factors_only,
                                     const struct pp_assess_options *options,
                                     struct pp_error *err)
{
    const char *own = assessment->room->world->country;
    const char *country = options->profile && !own[0] ? options->profile->country : own;
    const struct pp_inquiry inquiry = {
        .world = assessment->room->world,
        .light = &assessment->room->light,
        .before = assessment->before ? assessment->before->world : NULL,
        .pairs = assessment->pairs,
        .mirrored = assessment->mirrored ? assessment->mirrored->world : NULL,
        .mirrored_pairs = assessment->mirrored_pairs,
        .factors = assessment->has_factors ? &assessment->report : NULL,
        .grid = assessment->has_factors ? &assessment->grid : NULL,
        .median = assessment->median,
        .sunshine = options->sunshine,
        .french_m = options->french_m,
        .least_altitude_rad = options->least_altitude_rad,
        .country = country,
    };
    assessment->answers = calloc(PP_CRITERIA_MOST, sizeof *assessment->answers);
    if (!assessment->answers)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    const struct pp_criterion *criterion;
    for (int i = 0; status == PP_OK && (criterion = pp_criteria_at(i)) != NULL; i++) {
        if (!chosen[i] || (factors_only && !criterion->of_factors)
            || (criterion->needs_before && !inquiry.before)
            || (criterion->needs_mirror_image && !inquiry.mirrored)
            || (criterion->of_gardens && inquiry.world->garden_count == 0))
            continue;
        struct pp_answer *answer = &assessment->answers[assessment->answer_count++];
        answer->criterion = criterion;
        status = criterion->evaluate(&inquiry, &answer->findings, err);
    }
    return status;
}

/* ---- the grid ---- */

/* Relative error of a figure by the grid below which the grid is fine enough. */
static const double small_error = 0.02;

/* Limits for a grid that the user has not chosen: number of halvings, and of points. */
enum { HALVINGS_MOST = 3, POINTS_MOST = 4000 };

/* True if the grid causes more error than noise does and may change the verdict. A
 * minimum (without a share of the plane) is left out, because it depends on every
 * grid. */
static bool is_coarse(const struct pp_finding *finding)
{
    if (!(finding->grid_error > 0.0) || !isfinite(finding->reached_over))
        return false;
    double noise = 0.0;
    if (isfinite(finding->std_error))
        noise = sqrt(fmax(finding->std_error * finding->std_error
                              - finding->grid_error * finding->grid_error,
                          0.0));
    return finding->grid_error > noise
           && (finding->verdict == PP_UNDECIDED
               || finding->grid_error > small_error * finding->figure);
}

/* True if the grid should be halved and may be. */
static bool wants_finer_grid(const struct pp_assessment *assessment,
                             const struct pp_assess_options *options)
{
    if (options->grid.largest || options->grid.spacing_m > 0.0
        || assessment->grid.halvings >= HALVINGS_MOST
        || 4 * assessment->grid.count > POINTS_MOST)
        return false;
    for (int i = 0; i < assessment->answer_count; i++)
        for (int k = 0; k < assessment->answers[i].findings.count; k++)
            if (is_coarse(&assessment->answers[i].findings.list[k]))
                return true;
    return false;
}

static void clear_answers(struct pp_assessment *assessment)
{
    for (int i = 0; i < assessment->answer_count; i++)
        pp_finding_list_clear(&assessment->answers[i].findings);
    free(assessment->answers);
    assessment->answers = NULL;
    assessment->answer_count = 0;
}

/* Makes the grid, and a report with the daylight factors of hand methods at its
 * points. */
static enum pp_status lay_grid(struct pp_assessment *assessment, int halvings,
                               const struct pp_assess_options *options,
                               struct pp_error *err)
{
    const struct pp_study_room *room = assessment->room;
    pp_report_clear(&assessment->report);
    pp_plane_grid_clear(&assessment->grid);
    enum pp_status status = pp_plane_grid_make(
        &assessment->grid, room->world, room->room, &options->grid, halvings, err);
    assessment->report = (struct pp_report){.world = room->world,
                                            .light = room->light,
                                            .receivers = assessment->grid.receivers,
                                            .receiver_count = assessment->grid.count,
                                            .finished = true};
    return status == PP_OK ? pp_factors_by_hand(&assessment->report, err) : status;
}

/* Computes the daylight factors that criteria need, by hand methods, on a grid that is
 * fine enough for their verdicts. */
static enum pp_status gather_factors(struct pp_assessment *assessment,
                                     const bool chosen[PP_CRITERIA_MOST],
                                     const struct pp_assess_options *options,
                                     struct pp_error *err)
{
    const struct pp_world *world = assessment->room->world;
    find_median(&assessment->median, world, options);
    assessment->report = (struct pp_report){
        .world = world, .light = assessment->room->light, .finished = true};
    if (!assessment->has_factors)
        return PP_OK;
    enum pp_status status = PP_OK;
    bool finer = true;
    for (int halvings = 0; finer && status == PP_OK; halvings++) {
        status = lay_grid(assessment, halvings, options, err);
        if (status == PP_OK)
            status = judge_criteria(assessment, chosen, true, options, err);
        finer = status == PP_OK && wants_finer_grid(assessment, options);
        clear_answers(assessment);
    }
    return status == PP_OK ? pp_report_bands_fill(&assessment->report, err) : status;
}

/* Halves the grid and simulates again. */
static enum pp_status trace_finer(struct pp_assessment *assessment,
                                  const struct pp_assess_options *options,
                                  struct pp_error *err)
{
    enum pp_status status =
        lay_grid(assessment, assessment->grid.halvings + 1, options, err);
    if (status == PP_OK)
        status = pp_report_bands_fill(&assessment->report, err);
    return status == PP_OK
               ? pp_plane_trace(&assessment->report, options->study,
                                assessment->has_average, &assessment->by_clock, err)
               : status;
}

/* Chooses the named criteria; otherwise those of the profile that apply to the room, or
 * all in force that do. Choosing a profile implies its country's rules. */
static enum pp_status choose_criteria(bool chosen[PP_CRITERIA_MOST],
                                      const struct pp_world *world,
                                      const struct pp_assess_options *options,
                                      struct pp_error *err)
{
    const struct pp_profile *profile = options->criteria ? NULL : options->profile;
    enum pp_status status = pp_assessment_choose(
        chosen, profile ? profile->criteria : options->criteria, err);
    if (status != PP_OK || options->criteria)
        return status;
    const struct pp_criterion *criterion;
    for (int i = 0; (criterion = pp_criteria_at(i)) != NULL; i++)
        chosen[i] &= pp_bearing_bears(criterion, world, !profile)
                     && (profile || options->withdrawn || !criterion->withdrawn);
    return PP_OK;
}

static bool any_of_factors(const bool chosen[PP_CRITERIA_MOST])
{
    const struct pp_criterion *criterion;
    for (int i = 0; (criterion = pp_criteria_at(i)) != NULL; i++)
        if (chosen[i] && criterion->of_factors)
            return true;
    return false;
}

static bool is_chosen(const bool chosen[PP_CRITERIA_MOST],
                      const struct pp_criterion *criterion)
{
    for (int i = 0; pp_criteria_at(i); i++)
        if (pp_criteria_at(i) == criterion)
            return chosen[i];
    return false;
}

enum pp_status pp_assessment_begin(struct pp_assessment *assessment,
                                   const struct pp_study_room *room, int room_count,
                                   const struct pp_rooms_before *before,
                                   const struct pp_assess_options *options,
                                   struct pp_error *err)
{
    bool chosen[PP_CRITERIA_MOST];
    *assessment = (struct pp_assessment){.room = room};
    enum pp_status status = choose_criteria(chosen, room->world, options, err);
    if (status != PP_OK)
        return status;
    assessment->has_factors = any_of_factors(chosen);
    assessment->has_average =
        options->of_averages || is_chosen(chosen, &pp_criterion_average);
    if (before && before->count > 0)
        status = pp_room_before_find(&assessment->before, &assessment->pairs, room,
                                     room_count, before, err);
    if (status == PP_OK && options->mirrored && options->mirrored->count > 0)
        status = pp_room_before_find(&assessment->mirrored, &assessment->mirrored_pairs,
                                     room, room_count, options->mirrored, err);
    return status == PP_OK ? gather_factors(assessment, chosen, options, err) : status;
}

enum pp_status pp_assessment_judge(struct pp_assessment *assessment,
                                   const struct pp_assess_options *options,
                                   struct pp_error *err)
{
    bool chosen[PP_CRITERIA_MOST];
    const struct pp_world *world = assessment->room->world;
    enum pp_status status = choose_criteria(chosen, world, options, err);
    if (status == PP_OK)
        status = judge_criteria(assessment, chosen, false, options, err);
    while (status == PP_OK && options->trace_again && assessment->report.finished
           && pp_report_find(&assessment->report, PP_DF, "traced")
           && wants_finer_grid(assessment, options)) {
        clear_answers(assessment);
        status = trace_finer(assessment, options, err);
        if (status == PP_OK)
            status = judge_criteria(assessment, chosen, false, options, err);
    }
    assessment->has_gains =
        !options->criteria && !options->profile && !options->verdicts_only;
    if (status == PP_OK && assessment->has_gains)
        status = pp_gains_find(&assessment->gains, assessment->room->room,
                               assessment->room->world, &assessment->room->light, err);
    if (status == PP_OK && assessment->has_gains && options->study->simulate)
        status = pp_gains_simulate(&assessment->gains, assessment->room->room,
                                   assessment->room->world, &assessment->room->light,
                                   options->study, err);
    return status;
}

void pp_assessment_clear(struct pp_assessment *assessment)
{
    clear_answers(assessment);
    pp_report_clear(&assessment->report);
    pp_plane_grid_clear(&assessment->grid);
    free(assessment->pairs);
    free(assessment->mirrored_pairs);
}
