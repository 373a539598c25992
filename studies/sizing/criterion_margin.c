/* criterion_margin.c - see criterion_margin.h. */
#include "studies/sizing/criterion_margin.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/base/text.h"
#include "studies/criteria/assessment.h"
#include "studies/criteria/grid/plane_trace.h"

enum { NAME_BYTES = 64 };

static const double most_share = 1e6; /* ratio used for an upper limit if the figure is
                                       * 0 */

/* Distance between a figure and its one-sided 95 % limit (PP_SURE), in standard
 * errors. */
static const double sure_errors = 1.6449;

static const double just_below = 1e-6;

static void requirement_name(char name[NAME_BYTES], const char *words)
{
    snprintf(name, NAME_BYTES, "%.*s", (int)strcspn(words, ":"), words);
}

/* Text after the colon; empty if all findings are to be considered. */
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
                       "\"%.100s\" contains a comma; expected one criterion", words);
    requirement_name(name, words);
    if (pp_assessment_needs_year(name, NULL, true))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s needs a simulated year, which size does not calculate; "
                       "expected another criterion",
                       name);
    return pp_assessment_choose(chosen, name, err);
}

/* True if the name of a finding begins with these words. A hyphen also matches a blank,
 * as in "living-room". */
static bool begins_with(const char *what, const char *beginning)
{
    for (; *beginning; beginning++, what++)
        if (*beginning != *what && !(*beginning == '-' && *what == ' '))
            return false;
    return true;
}

/* Ratio of a figure to its target. For a sampled figure, the 95 % limit on the
 * unfavourable side is used; the ratio is then below 1 unless the verdict is "met". */
static double finding_share(const struct pp_finding *finding)
{
    double limit = finding->figure;
    if (isfinite(finding->std_error))
        limit += (finding->at_most ? 1.0 : -1.0) * sure_errors * finding->std_error;
    double share = finding->at_most ? finding->wanted / limit : limit / finding->wanted;
    if (isfinite(finding->std_error) && finding->verdict != PP_MET)
        share = fmin(share, 1.0 - just_below);
    return fmin(share, most_share);
}

/* Writes a message that no finding begins with these words, and lists the existing
 * findings. */
static void say_none(char *why, size_t why_bytes,
                     const struct pp_finding_list *findings, const char *beginning)
{
    if (!beginning[0]) {
        snprintf(why, why_bytes,
                 "this criterion has no requirement with a limit for this room");
        return;
    }
    snprintf(why, why_bytes,
             "no requirement begins with \"%.40s\"; available:", beginning);
    for (int i = 0; i < findings->count; i++)
        if (isfinite(findings->list[i].wanted))
            pp_text_append(why, why_bytes, "%s \"%s\"", i > 0 ? "," : "",
                           findings->list[i].what);
}

/* Finds the least ratio among the findings that are considered. */
static void take_least(struct pp_reading *least, char *why, size_t why_bytes,
                       const struct pp_finding_list *findings, const char *beginning)
{
    bool found = false;
    for (int i = 0; i < findings->count; i++) {
        const struct pp_finding *finding = &findings->list[i];
        if (!begins_with(finding->what, beginning))
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
        *least = pp_reading_of(share);
    }
    if (!found)
        say_none(why, why_bytes, findings, beginning);
}

enum pp_status pp_criterion_margin(struct pp_reading *reading, char *why,
                                   size_t why_bytes, const char *words,
                                   const struct pp_study_room *room,
                                   const struct pp_world *world,
                                   const struct pp_grid_choice *grid,
                                   const struct pp_study_options *traced,
                                   struct pp_error *err)
{
    char name[NAME_BYTES];
    requirement_name(name, words);
    const struct pp_study_options by_hand = PP_STUDY_OPTIONS_NONE;
    const struct pp_assess_options wanted = {.study = traced ? traced : &by_hand,
                                             .criteria = name,
                                             .verdicts_only = true,
                                             .grid = *grid,
                                             .trace_again = traced != NULL};
    struct pp_study_room changed = *room;
    struct pp_assessment assessment;
    changed.world = (struct pp_world *)world;
    *reading = pp_reading_none(NULL);
    why[0] = '\0';
    enum pp_status status =
        pp_assessment_begin(&assessment, &changed, 1, NULL, &wanted, err);
    bool is_traced = traced && assessment.has_factors;
    if (status == PP_OK && is_traced)
        status = pp_plane_trace(&assessment.report, traced, assessment.has_average,
                                &assessment.by_clock, err);
    if (status == PP_OK && !assessment.report.finished)
        status = pp_fail(err, PP_INTERRUPTED, "interrupted before a size was found");
    if (status == PP_OK && (!traced || is_traced))
        status = pp_assessment_judge(&assessment, &wanted, err);
    if (status == PP_OK && assessment.answers.count > 0)
        take_least(reading, why, why_bytes, &assessment.answers.list[0].findings,
                   beginning_of(words));
    else if (status == PP_OK && !traced)
        snprintf(why, why_bytes,
                 "this criterion needs an existing state (assess --before) or gardens");
    pp_assessment_clear(&assessment);
    return status;
}
