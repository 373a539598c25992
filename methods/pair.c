/* pair.c - daylight factors of two methods. */
#include "methods/pair.h"

#include <stdio.h>

#include "methods/component_steps.h"

/* sc + erc + irc, or why there is no sum: the reason of the direct part comes first. */
static struct pp_reading pair_of(struct pp_reading sc, struct pp_reading erc,
                                 struct pp_reading irc)
{
    if (sc.why)
        return sc;
    return irc.why ? irc : pp_reading_of(sc.value + erc.value + irc.value);
}

/* Records the reading of a column at a point. */
static void add_column_step(struct pp_steps *steps, const struct pp_column *column,
                            int point)
{
    pp_steps_add_named(steps, PP_UNIT_DAYLIGHT_FACTOR, column->points[point].value,
                       pp_component_steps_symbols[column->component], "%s by %s",
                       pp_component_steps_names[column->component], column->name);
}

enum pp_status pp_pair_add(struct pp_report *report, const char *direct,
                           const char *internal, struct pp_error *err)
{
    char name[sizeof report->columns->name];
    snprintf(name, sizeof name, "%s+%s", direct, internal);
    if (pp_report_find(report, PP_DF, name))
        return PP_OK;
    struct pp_column *df = pp_report_add(report, PP_DF, name, true);
    if (!df)
        return pp_fail_memory(err);
    const struct pp_column *sc = pp_report_find(report, PP_SC, direct);
    const struct pp_column *erc = pp_report_find(report, PP_ERC, direct);
    const struct pp_column *irc = pp_report_find(report, PP_IRC, internal);
    df->average = pair_of(sc->average, erc->average, irc->average);
    for (int i = 0; i < report->receiver_count; i++) {
        df->points[i] = pair_of(sc->points[i], erc->points[i], irc->points[i]);
        if (!report->explain || df->points[i].why)
            continue;
        struct pp_steps *steps = pp_report_steps(report);
        add_column_step(steps, sc, i);
        add_column_step(steps, erc, i);
        add_column_step(steps, irc, i);
        pp_steps_add_worked(steps, PP_UNIT_DAYLIGHT_FACTOR, df->points[i].value,
                            pp_component_steps_symbols[PP_DF], "SC + ERC + IRC", "%s",
                            pp_component_steps_names[PP_DF]);
        if (!steps || steps->failed)
            return pp_fail_memory(err);
        df->points[i].steps = steps;
    }
    return PP_OK;
}
