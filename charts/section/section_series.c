/* section_series.c - chooses the columns of the report to be drawn, and their line
 * styles. */
#include "charts/section/section_series.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "charts/sheet/page.h"

static bool is_sampled(const struct pp_report *report, const struct pp_column *column)
{
    for (int i = 0; i < report->receiver_count; i++)
        if (isfinite(column->points[i].value) && isfinite(column->points[i].std_error))
            return true;
    return false;
}

static int values_in(const struct pp_report *report, const struct pp_column *column,
                     const char **why)
{
    int count = 0;
    *why = 0;
    for (int i = 0; i < report->receiver_count; i++) {
        if (isfinite(column->points[i].value))
            count++;
        else if (!*why)
            *why = column->points[i].why;
    }
    return count;
}

/* Adds a note at the foot if a column has no value at some points; why: the reason. */
static void account(struct pp_section_plot *plot, const struct pp_column *column,
                    int count, const char *why)
{
    int all = column->points ? plot->report->receiver_count : 1;
    if (count == all)
        return;
    char where[64] = "";
    if (column->points && count > 0)
        snprintf(where, sizeof where, " at %d of %d points", all - count, all);
    /* Removes the method's name from the start of a reason. */
    size_t length = strlen(column->name);
    if (why && strncmp(why, column->name, length) == 0 && why[length] == ':')
        why += length + 1 + strspn(why + length + 1, " ");
    pp_page_say(plot->foot, sizeof plot->foot, "%s has no value%s%s%s.", column->name,
                where, why ? ": " : "", why ? why : "");
}

static void name_series(struct pp_series *series)
{
    struct pp_key *key = &series->key;
    const struct pp_column *column = series->column;
    key->curve = series->look;
    key->grey = PP_INK;
    if (series->kind == PP_SAMPLED) {
        key->kind = PP_KEY_SAMPLED;
        snprintf(key->words, sizeof key->words, "%s \u00b1 standard error",
                 strcmp(column->name, "traced") == 0 ? "simulated" : column->name);
    } else if (series->kind == PP_LEVEL) {
        char percent[32];
        pp_style_percent(percent, sizeof percent, column->average.value);
        key->kind = PP_KEY_LINE;
        snprintf(key->words, sizeof key->words, "%s, room average %s", column->name,
                 percent);
    } else {
        key->kind = PP_KEY_LINE;
        snprintf(key->words, sizeof key->words, "%s", column->name);
    }
}

/* True if any column of daylight factors was simulated. */
static bool has_samples(const struct pp_report *report)
{
    for (int i = 0; i < report->column_count; i++)
        if (report->columns[i].component == PP_DF && report->columns[i].points
            && is_sampled(report, &report->columns[i]))
            return true;
    return false;
}

void pp_section_series_choose(struct pp_section_plot *plot)
{
    /* Solid lines are reserved for simulated values. If there are any, hand
     * calculations are dashed. */
    int lines = has_samples(plot->report) ? 1 : 0, sampled = 0;
    for (int i = 0; i < plot->report->column_count; i++) {
        const struct pp_column *column = &plot->report->columns[i];
        if (column->component != PP_DF)
            continue;
        struct pp_series *series = &plot->series[plot->series_count];
        *series = (struct pp_series){.column = column, .kind = PP_CURVE};
        const char *why = column->average.why;
        int count = isfinite(column->average.value);
        if (!column->points) {
            series->kind = PP_LEVEL;
        } else {
            count = values_in(plot->report, column, &why);
            if (is_sampled(plot->report, column))
                series->kind = PP_SAMPLED;
        }
        account(plot, column, count, why);
        if (count == 0)
            continue;
        series->look =
            series->kind == PP_SAMPLED
                ? (struct pp_curve_style){.marker = sampled++ ? PP_DIAMOND : PP_CIRCLE,
                                          .weight = 0.7}
                : pp_style_curve(lines++);
        if (series->kind == PP_LEVEL)
            series->look.weight *= 0.6;
        plot->curve_count += series->kind == PP_CURVE;
        name_series(series);
        plot->series_count++;
    }
    for (int i = 0; i < plot->series_count; i++)
        if (plot->series[i].kind == PP_CURVE && plot->curve_count > 4)
            plot->series[i].key.kind = PP_KEY_MARKED_LINE;
}
