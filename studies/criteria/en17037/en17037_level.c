/* en17037_level.c - see en17037_level.h. */
#include "studies/criteria/en17037/en17037_level.h"

#include <stdio.h>

const char *const pp_en17037_level_names[PP_EN17037_HIGH + 1] = {"none", "minimum",
                                                                 "medium", "high"};
const double pp_en17037_level_target_lx[PP_EN17037_HIGH + 1] = {0.0, 300.0, 500.0,
                                                                750.0};
const double pp_en17037_level_minimum_lx[PP_EN17037_HIGH + 1] = {0.0, 100.0, 300.0,
                                                                 500.0};
const double pp_en17037_level_half = 0.5, pp_en17037_level_nearly_all = 0.95;

/* Greatest slope of the glass of a rooflight. */
static const double level_rad = 15.0 * PP_RAD;

struct pp_en17037_level pp_en17037_level_of(const struct pp_finding_list *findings)
{
    struct pp_en17037_level result = {.judged = false};
    int count[PP_EN17037_HIGH + 1] = {0}, met[PP_EN17037_HIGH + 1] = {0},
                                open[PP_EN17037_HIGH + 1] = {0};
    for (int i = 0; i < findings->count; i++) {
        enum pp_verdict verdict = findings->list[i].verdict;
        int level = findings->list[i].level;
        if (level == PP_EN17037_NONE)
            continue;
        result.judged |= verdict != PP_NOT_JUDGED;
        count[level]++;
        met[level] += verdict == PP_MET;
        open[level] += verdict == PP_MET || verdict == PP_UNDECIDED;
    }
    for (int k = 1; k <= PP_EN17037_HIGH && count[k] > 0 && met[k] == count[k]; k++)
        result.reached = k;
    for (int k = 1; k <= PP_EN17037_HIGH && count[k] > 0 && open[k] == count[k]; k++)
        result.perhaps = k;
    return result;
}

void pp_en17037_level_words(char words[PP_EN17037_LEVEL_WORDS],
                            const struct pp_finding_list *findings)
{
    struct pp_en17037_level level = pp_en17037_level_of(findings);
    bool perhaps = level.perhaps > level.reached;
    snprintf(words, PP_EN17037_LEVEL_WORDS, "%s%s%s",
             pp_en17037_level_names[level.reached], perhaps ? ", perhaps " : "",
             perhaps ? pp_en17037_level_names[level.perhaps] : "");
}

bool pp_en17037_level_of_rooflights(const struct pp_world *world)
{
    bool all = world->opening_count > 0;
    for (int i = 0; i < world->opening_count; i++)
        all &= world->openings[i].slope_rad < level_rad;
    return all;
}
