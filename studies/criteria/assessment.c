/* assessment.c - chooses criteria, computes the daylight factors that they need, and
 * evaluates each of them. */
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
#include "studies/criteria/pair_rooms.h"
#include "studies/criteria/room_before.h"
#include "studies/criteria/rules/rule_points.h"
#include "studies/criteria/windows/traced_windows.h"
#include "studies/criteria/year/assessed_year.h"
#include "studies/study_report.h"

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

static struct pp_inquiry inquiry_of(const struct pp_assessment *assessment,
                                    const struct pp_assess_options *options)
{
    const char *own = assessment->room->world->country;
    return (struct pp_inquiry){
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
        .year = assessment->has_year ? &assessment->year : NULL,
        .year_grid = assessment->year_grid.count > 0 ? &assessment->year_grid : NULL,
        .glare = assessment->has_glare ? &assessment->glare : NULL,
        .rules = options->rules,
        .points = assessment->point_list ? &assessment->points : NULL,
        .windows = assessment->windows,
        .french_m = options->french_m,
        .least_altitude_rad = options->least_altitude_rad,
        .shortest_h = options->shortest_h,
        .threads = options->study->threads,
        .country = options->profile && !own[0] ? options->profile->country : own,
    };
}

static void clear_answer_list(struct pp_answer_list *answers)
{
    for (int i = 0; i < answers->count; i++)
        pp_finding_list_clear(&answers->list[i].findings);
    free(answers->list);
    *answers = (struct pp_answer_list){0};
}

static bool any_criterion(const struct pp_criterion *criterion)
{
    (void)criterion;
    return true;
}

static bool is_of_factors(const struct pp_criterion *criterion)
{
    return criterion->of_factors;
}

static bool is_of_states(const struct pp_criterion *criterion)
{
    return criterion->of_states;
}

static int criteria_count(void)
{
    int count = 0;
    while (pp_criteria_at(count))
        count++;
    return count;
}

/* Assesses the room by the chosen criteria and the rules (if any) for which `applies`
 * is true. The watch shows progress; it cannot stop the work. */
static enum pp_status judge_criteria(struct pp_answer_list *answers,
                                     const struct pp_inquiry *inquiry,
                                     const bool chosen[PP_CRITERIA_MOST],
                                     bool (*applies)(const struct pp_criterion *),
                                     const struct pp_watch *watch, struct pp_error *err)
{
    *answers = (struct pp_answer_list){
        .list = calloc(PP_CRITERIA_MOST, sizeof *answers->list)};
    if (!answers->list)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    const struct pp_criterion *criterion;
    const int count = criteria_count();
    bool shown = pp_watch_begin(watch, inquiry->world->name);
    for (int i = 0; status == PP_OK && (criterion = pp_criteria_at(i)) != NULL; i++) {
        pp_watch_show(watch, shown, (double)i / count);
        if (!chosen[i] || !applies(criterion)
            || (criterion->needs_before && !inquiry->before)
            || (criterion->needs_mirror_image && !inquiry->mirrored)
            || (criterion->of_gardens && inquiry->world->garden_count == 0))
            continue;
        struct pp_answer *answer = &answers->list[answers->count++];
        answer->criterion = criterion;
        status = criterion->evaluate(inquiry, &answer->findings, err);
    }
    if (status == PP_OK && inquiry->rules && applies(&inquiry->rules->criterion)) {
        struct pp_answer *answer = &answers->list[answers->count++];
        answer->criterion = &inquiry->rules->criterion;
        status = answer->criterion->evaluate(inquiry, &answer->findings, err);
    }
    pp_watch_end(watch, shown);
    return status;
}

/* Assesses the proposed room. */
static enum pp_status judge_room(struct pp_assessment *assessment,
                                 const bool chosen[PP_CRITERIA_MOST],
                                 bool (*applies)(const struct pp_criterion *),
                                 const struct pp_assess_options *options,
                                 struct pp_error *err)
{
    const struct pp_inquiry inquiry = inquiry_of(assessment, options);
    return judge_criteria(&assessment->answers, &inquiry, chosen, applies,
                          &options->study->watch, err);
}

/* Assesses sky and sun in the cumulative state. */
static enum pp_status judge_cumulative(struct pp_assessment *assessment,
                                       const bool chosen[PP_CRITERIA_MOST],
                                       const struct pp_assess_options *options,
                                       struct pp_error *err)
{
    struct pp_inquiry inquiry = inquiry_of(assessment, options);
    inquiry.world = assessment->cumulative->world;
    inquiry.light = &assessment->cumulative->light;
    inquiry.pairs = assessment->cumulative_pairs;
    return judge_criteria(&assessment->cumulative_answers, &inquiry, chosen,
                          is_of_states, &options->study->watch, err);
}

/* ---- the grid ---- */

/* The grid is fine enough if the relative error that it causes in a figure is below
 * this. */
static const double small_error = 0.02;

/* Limits for a grid that the user has not chosen: number of halvings, and of points. */
enum { HALVINGS_MOST = 3, POINTS_MOST = 4000 };

/* True if the error due to the grid exceeds that due to noise, and either the verdict
 * is undecided or that error is above small_error. A minimum is excluded (it has no
 * fraction of the plane), because it changes with every refinement of the grid. */
static bool is_coarse(const struct pp_finding *finding)
{
    if (!(finding->grid_error > 0.0) || !isfinite(finding->reached_over)
        || finding->kind == PP_FIGURE_LUX) /* evaluated at the points of the year, not
                                            * on this grid */
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

/* True if the grid's spacing should be halved, and halving is permitted. */
static bool wants_finer_grid(const struct pp_assessment *assessment,
                             const struct pp_assess_options *options)
{
    if (options->grid.largest || options->grid.spacing_m > 0.0
        || assessment->grid.halvings >= HALVINGS_MOST
        || 4 * assessment->grid.count > POINTS_MOST)
        return false;
    for (int i = 0; i < assessment->answers.count; i++)
        for (int k = 0; k < assessment->answers.list[i].findings.count; k++)
            if (is_coarse(&assessment->answers.list[i].findings.list[k]))
                return true;
    return false;
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

/* Computes by hand methods the daylight factors that criteria need, on a grid fine
 * enough for their verdicts. */
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
            status = judge_room(assessment, chosen, is_of_factors, options, err);
        finer = status == PP_OK && wants_finer_grid(assessment, options);
        clear_answer_list(&assessment->answers);
    }
    return status == PP_OK ? pp_report_bands_fill(&assessment->report, err) : status;
}

/* Halves the grid's spacing and simulates again. */
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

/* Chooses the criteria that are named. If none are named, chooses those of the profile
 * that apply to the use of the room, whatever its country. Without a profile, chooses
 * all criteria that apply to the room, except those that use a year or glare and,
 * unless requested, withdrawn ones. With rules, chooses none. */
static enum pp_status choose_criteria(bool chosen[PP_CRITERIA_MOST],
                                      const struct pp_assessment *assessment,
                                      const struct pp_assess_options *options,
                                      struct pp_error *err)
{
    const struct pp_world *world = assessment->room->world;
    const struct pp_profile *profile = options->criteria ? NULL : options->profile;
    if (options->rules) {
        memset(chosen, 0, PP_CRITERIA_MOST * sizeof *chosen);
        return PP_OK;
    }
    const char *list = options->criteria;
    if (profile)
        list = assessment->before && profile->of_neighbours ? profile->of_neighbours
               : assessment->is_new && profile->of_new      ? profile->of_new
                                                            : profile->criteria;
    enum pp_status status = pp_assessment_choose(chosen, list, err);
    if (status != PP_OK || options->criteria)
        return status;
    const struct pp_criterion *criterion;
    for (int i = 0; (criterion = pp_criteria_at(i)) != NULL; i++)
        chosen[i] &= pp_bearing_bears(criterion, world, !profile)
                     && (profile || options->withdrawn || !criterion->withdrawn)
                     && (profile
                         || !(criterion->of_year || criterion->of_plane_year
                              || criterion->of_glare));
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

bool pp_assessment_needs_year(const char *criteria, const struct pp_profile *profile,
                              bool optional)
{
    bool chosen[PP_CRITERIA_MOST];
    const char *list = criteria ? criteria : profile ? profile->criteria : NULL;
    if (!list || pp_assessment_choose(chosen, list, NULL) != PP_OK)
        return false;
    for (int i = 0; pp_criteria_at(i); i++)
        if (chosen[i]
            && (pp_criteria_at(i)->of_year
                || (optional
                    && (pp_criteria_at(i)->of_plane_year
                        || pp_criteria_at(i)->of_glare))))
            return true;
    return false;
}

/* Finds the room's counterparts in the other states of its site. */
static enum pp_status find_counterparts(struct pp_assessment *assessment,
                                        int room_count,
                                        const struct pp_rooms_before *before,
                                        const struct pp_assess_options *options,
                                        struct pp_error *err)
{
    const struct pp_study_room *room = assessment->room;
    const struct pp_rooms_before *mirrored = options->mirrored;
    const struct pp_rooms_before *cumulative = options->cumulative;
    enum pp_status status = PP_OK;
    if (before && before->count > 0)
        status = pp_room_before_find(&assessment->before, &assessment->pairs, room,
                                     room_count, before, err);
    assessment->is_new = before && before->is_state && before->count > 0
                         && pp_building_has_states(room->building)
                         && !assessment->before;
    if (status == PP_OK && mirrored && mirrored->count > 0)
        status = pp_room_before_find(&assessment->mirrored, &assessment->mirrored_pairs,
                                     room, room_count, mirrored, err);
    int *same = NULL; /* the cumulative state has the openings in the same order */
    if (status == PP_OK && cumulative && cumulative->count > 0)
        status = pp_room_before_find(&assessment->cumulative, &same, room, room_count,
                                     cumulative, err);
    free(same);
    if (status == PP_OK && assessment->cumulative && assessment->before)
        status =
            pp_pair_rooms(&assessment->cumulative_pairs, assessment->cumulative->world,
                          assessment->before->world, err);
    return status;
}

enum pp_status pp_assessment_begin(struct pp_assessment *assessment,
                                   const struct pp_study_room *room, int room_count,
                                   const struct pp_rooms_before *before,
                                   const struct pp_assess_options *options,
                                   struct pp_error *err)
{
    bool chosen[PP_CRITERIA_MOST];
    *assessment = (struct pp_assessment){.room = room};
    enum pp_status status =
        find_counterparts(assessment, room_count, before, options, err);
    if (status == PP_OK)
        status = choose_criteria(chosen, assessment, options, err);
    if (status != PP_OK)
        return status;
    const struct pp_rule_set *rules = options->rules;
    assessment->has_factors =
        any_of_factors(chosen) || (rules && rules->criterion.of_factors);
    assessment->has_average = options->of_averages
                              || is_chosen(chosen, &pp_criterion_average)
                              || (rules && rules->of_average);
    status = gather_factors(assessment, chosen, options, err);
    return status == PP_OK && rules && rules->point ? pp_rule_points_report(
               &assessment->points, &assessment->point_list, room, rules->point, err)
                                                    : status;
}

enum pp_status pp_assessment_judge(struct pp_assessment *assessment,
                                   const struct pp_assess_options *options,
                                   struct pp_error *err)
{
    bool chosen[PP_CRITERIA_MOST];
    enum pp_status status = choose_criteria(chosen, assessment, options, err);
    if (status == PP_OK)
        status = pp_assessed_year_simulate(
            assessment, chosen,
            pp_assessment_needs_year(options->criteria, options->profile, false),
            options, err);
    if (status == PP_OK && assessment->points.receiver_count > 0
        && options->study->simulate) {
        status = pp_study_report_traced(&assessment->points, options->study,
                                        &assessment->by_clock, err);
        assessment->report.finished &= assessment->points.finished;
    }
    if (status == PP_OK && options->rules && options->rules->of_windows
        && options->study->simulate)
        status = pp_traced_windows_light(
            &assessment->windows, assessment->room->world, &assessment->room->light,
            options->study, &assessment->report.finished, &assessment->by_clock, err);
    if (status == PP_OK)
        status = judge_room(assessment, chosen, any_criterion, options, err);
    while (status == PP_OK && options->trace_again && assessment->report.finished
           && pp_report_find(&assessment->report, PP_DF, "traced")
           && wants_finer_grid(assessment, options)) {
        clear_answer_list(&assessment->answers);
        status = trace_finer(assessment, options, err);
        if (status == PP_OK)
            status = judge_room(assessment, chosen, any_criterion, options, err);
    }
    if (status == PP_OK && assessment->cumulative)
        status = judge_cumulative(assessment, chosen, options, err);
    assessment->has_gains = !options->criteria && !options->profile && !options->rules
                            && !options->verdicts_only;
    if (status == PP_OK && assessment->has_gains)
        status = pp_gains_find(&assessment->gains, assessment->room->room,
                               assessment->room->world, &assessment->room->light,
                               &options->study->watch, err);
    if (status == PP_OK && assessment->has_gains && options->study->simulate)
        status = pp_gains_simulate(&assessment->gains, assessment->room->room,
                                   assessment->room->world, &assessment->room->light,
                                   options->study, err);
    const struct pp_column *traced =
        pp_report_find(&assessment->report, PP_DF, "traced");
    if (status == PP_OK && assessment->has_gains && traced)
        pp_gains_relate(&assessment->gains, traced->average.value);
    return status;
}

void pp_assessment_clear(struct pp_assessment *assessment)
{
    clear_answer_list(&assessment->answers);
    clear_answer_list(&assessment->cumulative_answers);
    pp_report_clear(&assessment->report);
    pp_plane_grid_clear(&assessment->grid);
    pp_annual_sheet_clear(&assessment->year);
    pp_glare_sheet_clear(&assessment->glare);
    pp_plane_grid_clear(&assessment->year_grid);
    pp_report_clear(&assessment->points);
    free(assessment->point_list);
    free(assessment->windows);
    free(assessment->pairs);
    free(assessment->mirrored_pairs);
    free(assessment->cumulative_pairs);
}
