/* criterion_margin.c - see criterion_margin.h. */
#include "studies/sizing/criterion_margin.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "studies/criteria/assessment.h"
#include "studies/study_report.h"

enum { NAME_BYTES = 64 };

static const double most_share = 1e6; /* of an upper bound, where the figure is 0 */

static void requirement_name(char name[NAME_BYTES], const char *words)
{
    snprintf(name, NAME_BYTES, "%.*s", (int)strcspn(words, ":"), words);
}

/* Text after the colon; empty: all findings. */
static const char *beginning_of(const char *words)
{
    const char *colon = strchr(words, ':');
    return colon ? colon + 1 : "";
}

enum pp_status pp_criterion_margin_check(const char *words, struct pp_error *err)
{
    bool chosen[PP_CRITERIA_MOST];
    char name[NAME_BYTES];
    if (strchr(words, ','))
        return pp_fail(err, PP_BAD_INPUT,
                       "\"%.100s\" has a comma; expected one criterion", words);
    requirement_name(name, words);
    return pp_assessment_choose(chosen, name, err);
}

static double finding_share(const struct pp_finding *finding)
{
    double share = finding->at_most ? finding->wanted / finding->figure
                                    : finding->figure / finding->wanted;
    return fmin(share, most_share);
}

/* The least share of the findings that count. */
static void take_least(struct pp_reading *least, char *why, size_t why_bytes,
                       const struct pp_finding_list *findings, const char *beginning)
{
    bool found = false;
    for (int i = 0; i < findings->count; i++) {
        const struct pp_finding *finding = &findings->list[i];
        if (strncmp(finding->what, beginning, strlen(beginning)) != 0)
            continue;
        if (!isfinite(finding->figure)) {
            *least = pp_reading_none(NULL);
            snprintf(why, why_bytes, "%s: %s", finding->what, finding->note);
            return;
        }
        if (!isfinite(finding->wanted))
            continue;
        double share = finding_share(finding);
        if (found && !(share < least->value))
            continue;
        found = true;
        least->value = share;
        least->std_error = finding->std_error * share / finding->figure;
    }
    if (!found)
        snprintf(why, why_bytes, "it has no finding%s%s with a bound",
                 beginning[0] ? " that begins with " : "", beginning);
}

enum pp_status pp_criterion_margin(struct pp_reading *reading, char *why,
                                   size_t why_bytes, const char *words,
                                   const struct pp_study_room *room,
                                   const struct pp_world *world,
                                   const struct pp_study_options *traced,
                                   struct pp_error *err)
{
    char name[NAME_BYTES];
    requirement_name(name, words);
    const struct pp_assess_options wanted = {.criteria = name, .verdicts_only = true};
    struct pp_study_room changed = *room;
    struct pp_assessment assessment;
    changed.world = (struct pp_world *)world;
    *reading = pp_reading_none(NULL);
    why[0] = '\0';
    enum pp_status status =
        pp_assessment_begin(&assessment, &changed, 1, NULL, &wanted, err);
    bool is_traced = traced && assessment.has_factors;
    if (status == PP_OK && is_traced)
        status = pp_study_report_traced(&assessment.report, traced,
                                        &assessment.by_clock, err);
    if (status == PP_OK && !assessment.report.finished)
        status = pp_fail(err, PP_INTERRUPTED, "interrupted before a size was found");
    if (status == PP_OK && (!traced || is_traced))
        status = pp_assessment_judge(&assessment, &wanted, err);
    if (status == PP_OK && assessment.answer_count > 0)
        take_least(reading, why, why_bytes, &assessment.answers[0].findings,
                   beginning_of(words));
    else if (status == PP_OK && !traced)
        snprintf(why, why_bytes, "it judges by what was there before, or by gardens");
    pp_assessment_clear(&assessment);
    return status;
}
