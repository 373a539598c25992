/* en17037_level.c - see en17037_level.h. */
#include "studies/criteria/en17037/en17037_level.h"

#include <stdio.h>
#include <string.h>

const char *const pp_en17037_level_names[PP_EN17037_HIGH + 1] = {"none", "minimum",
                                                                 "medium", "high"};
const double pp_en17037_level_target_lx[PP_EN17037_HIGH + 1] = {0.0, 300.0, 500.0,
                                                                750.0};
const double pp_en17037_level_minimum_lx[PP_EN17037_HIGH + 1] = {0.0, 100.0, 300.0,
                                                                 500.0};
const double pp_en17037_level_half = 0.5, pp_en17037_level_nearly_all = 0.95;

/* Greatest slope of the glass of a rooflight. */
static const double level_rad = 15.0 * PP_RAD;

/* Level that the finding belongs to; PP_EN17037_NONE: to no level. */
static int level_of_finding(const struct pp_finding *finding)
{
    for (int level = 1; level <= PP_EN17037_HIGH; level++) {
        char start[16], later[24];
        snprintf(start, sizeof start, "%s:", pp_en17037_level_names[level]);
        snprintf(later, sizeof later, ", %s", start);
        if (strncmp(finding->what, start, strlen(start)) == 0
            || strstr(finding->what, later))
            return level;
    }
    return PP_EN17037_NONE;
}

struct pp_en17037_level pp_en17037_level_of(const struct pp_finding_list *findings)
{
    struct pp_en17037_level result = {.judged = false};
    bool met[PP_EN17037_HIGH + 1] = {true, true, true, true};
    bool open[PP_EN17037_HIGH + 1] = {true, true, true, true};
    for (int i = 0; i < findings->count; i++) {
        enum pp_verdict verdict = findings->list[i].verdict;
        int level = level_of_finding(&findings->list[i]);
        if (level == PP_EN17037_NONE)
            continue;
        result.judged |= verdict != PP_NOT_JUDGED;
        met[level] &= verdict == PP_MET;
        open[level] &= verdict == PP_MET || verdict == PP_UNDECIDED;
    }
    while (result.judged && result.reached < PP_EN17037_HIGH && met[result.reached + 1])
        result.reached++;
    while (result.judged && result.perhaps < PP_EN17037_HIGH
           && open[result.perhaps + 1])
        result.perhaps++;
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
