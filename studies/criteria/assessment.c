/* assessment.c - chooses criteria, computes the factors they need, and runs them in
 * turn. */
#include "studies/bands/report_bands.h"
#include "studies/criteria/assessment.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "studies/criteria/bearing.h"
#include "studies/criteria/capitals.h"
#include "studies/criteria/en17037_grid.h"
#include "studies/criteria/factors.h"
#include "studies/criteria/room_before.h"

/* Marks the criteria of a comma-separated list; NULL: all. */
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
                 options->of_weather ? "of the weather file" : "as given");
    } else if (options->place) {
        const struct pp_capital *capital = pp_capitals_find(options->place);
        median->lux = capital->median_lux;
        snprintf(median->how, sizeof median->how, "%s, as chosen", capital->name);
    } else {
        *median = pp_capitals_median(world->latitude_rad, world->longitude_rad,
                                     world->country);
    }
}

/* Gathers the daylight factors needed by criteria, without those of simulation. */
static enum pp_status gather_factors(struct pp_assessment *assessment,
                                     const struct pp_assess_options *options,
                                     struct pp_error *err)
{
    const struct pp_world *world = assessment->room->world;
    find_median(&assessment->median, world, options);
    assessment->report = (struct pp_report){
        .world = world, .light = assessment->room->light, .finished = true};
    if (!assessment->has_factors)
        return PP_OK;
    enum pp_status status = pp_en17037_grid(
        &assessment->grid, &assessment->report.receiver_count, world, err);
    assessment->report.receivers = assessment->grid;
    if (status == PP_OK)
        status = pp_factors_by_hand(&assessment->report, err);
    return status == PP_OK ? pp_report_bands_fill(&assessment->report, err) : status;
}

static enum pp_status judge_criteria(struct pp_assessment *assessment,
                                     const bool chosen[PP_CRITERIA_MOST],
                                     const char *country,
                                     const struct pp_assess_options *options,
                                     struct pp_error *err)
{
    const struct pp_inquiry inquiry = {
        .world = assessment->room->world,
        .light = &assessment->room->light,
        .before = assessment->before ? assessment->before->world : NULL,
        .pairs = assessment->pairs,
        .mirrored = assessment->mirrored ? assessment->mirrored->world : NULL,
        .mirrored_pairs = assessment->mirrored_pairs,
        .factors = assessment->has_factors ? &assessment->report : NULL,
        .median = assessment->median,
        .sunshine = options->sunshine,
        .french_m = options->french_m,
        .country = country,
    };
    assessment->answers = calloc(PP_CRITERIA_MOST, sizeof *assessment->answers);
    if (!assessment->answers)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    const struct pp_criterion *criterion;
    for (int i = 0; status == PP_OK && (criterion = pp_criteria_at(i)) != NULL; i++) {
        if (!chosen[i] || (criterion->needs_before && !inquiry.before)
            || (criterion->needs_mirror_image && !inquiry.mirrored)
            || (criterion->of_gardens && inquiry.world->garden_count == 0))
            continue;
        struct pp_answer *answer = &assessment->answers[assessment->answer_count++];
        answer->criterion = criterion;
        status = criterion->evaluate(&inquiry, &answer->findings, err);
    }
    return status;
}

/* Chooses the named criteria; otherwise those of the profile, or all, that apply to the
 * room. Choosing a profile implies its country's rules. */
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
        chosen[i] &= pp_bearing_bears(criterion, world, !profile);
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
    if (before && before->count > 0)
        status = pp_room_before_find(&assessment->before, &assessment->pairs, room,
                                     room_count, before, err);
    if (status == PP_OK && options->mirrored && options->mirrored->count > 0)
        status = pp_room_before_find(&assessment->mirrored, &assessment->mirrored_pairs,
                                     room, room_count, options->mirrored, err);
    return status == PP_OK ? gather_factors(assessment, options, err) : status;
}

enum pp_status pp_assessment_judge(struct pp_assessment *assessment,
                                   const struct pp_assess_options *options,
                                   struct pp_error *err)
{
    bool chosen[PP_CRITERIA_MOST];
    const struct pp_world *world = assessment->room->world;
    enum pp_status status = choose_criteria(chosen, world, options, err);
    const char *country = options->profile && !world->country[0]
                              ? options->profile->country
                              : world->country;
    if (status == PP_OK)
        status = judge_criteria(assessment, chosen, country, options, err);
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
    for (int i = 0; i < assessment->answer_count; i++)
        pp_finding_list_clear(&assessment->answers[i].findings);
    free(assessment->answers);
    pp_report_clear(&assessment->report);
    free(assessment->grid);
    free(assessment->pairs);
    free(assessment->mirrored_pairs);
}
