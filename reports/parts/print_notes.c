/* print_notes.c - collects the reasons for missing values. Each reason is listed once,
 * with its columns. */
#include "reports/parts/print_notes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reports/parts/print.h"
#include "methods/method.h"
#include "studies/engines/engine.h"
#include "model/base/text.h"
#include "model/base/array.h"

const struct pp_reading *pp_print_notes_reading(const struct pp_report *report,
                                                const struct pp_column *column, int row)
{
    if (row == report->receiver_count)
        return &column->average;
    return column->points ? &column->points[row] : NULL;
}

bool pp_print_notes_is_zero(const struct pp_report *report, enum pp_component component)
{
    bool any = false;
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        if (column->component != component)
            continue;
        any = true;
        for (int row = 0; row <= report->receiver_count; row++) {
            const struct pp_reading *reading =
                pp_print_notes_reading(report, column, row);
            if (reading && reading->value != 0.0)
                return false;
        }
    }
    return any;
}

/* Reason why a row has no value; NULL: it has a value, or there is no reason. */
static const char *why_at(const struct pp_report *report,
                          const struct pp_column *column, int row)
{
    const struct pp_reading *reading = pp_print_notes_reading(report, column, row);
    return reading && !isfinite(reading->value) ? reading->why : NULL;
}

/* The different reasons in a report, in the order of its columns; not owned. */
struct reasons {
    const char **list;
    int count;
};

static bool add_reason(struct reasons *reasons, const char *why)
{
    for (int i = 0; i < reasons->count; i++)
        if (reasons->list[i] == why || strcmp(reasons->list[i], why) == 0)
            return true;
    if (pp_array_append(&reasons->list, reasons->count, sizeof *reasons->list, NULL)
        != PP_OK)
        return false;
    reasons->list[reasons->count++] = why;
    return true;
}

static bool collect_reasons(struct reasons *reasons, const struct pp_report *report)
{
    for (int c = 0; c < report->column_count; c++)
        for (int row = 0; row <= report->receiver_count; row++) {
            const char *why = why_at(report, &report->columns[c], row);
            if (why && !add_reason(reasons, why))
                return false;
        }
    return true;
}

/* Number of rows before `end` in which a column has no value for that reason. */
static int count_rows(const struct pp_report *report, const struct pp_column *column,
                      const char *why, int end)
{
    int count = 0;
    for (int row = 0; row < end; row++) {
        const char *own = why_at(report, column, row);
        count += own && (own == why || strcmp(own, why) == 0);
    }
    return count;
}

/* True if the name is in a comma-separated list. Several columns may have the same
 * name: those for the components of a method. */
static bool is_listed(const char *names, const char *name)
{
    size_t length = strlen(name);
    for (const char *at = names; (at = strstr(at, name)) != NULL; at += length)
        if ((at == names || at[-1] == ' ') && (at[length] == ',' || !at[length]))
            return true;
    return false;
}

/* True if the reason begins with the name of one of the columns, as in "bre: ...".
 * Reasons of pairs begin so, because they come from one of the two methods. */
static bool names_itself(const char *names, const char *why)
{
    char first[64];
    const char *colon = strchr(why, ':');
    if (!colon || colon - why >= (int)sizeof first)
        return false;
    snprintf(first, sizeof first, "%.*s", (int)(colon - why), why);
    return is_listed(names, first);
}

/* Prints a reason, such as "- brs-table, brs-table+bre: the table holds vertical
 * openings only (3 of 17 points)". */
static void print_note(const struct pp_report *report, const char *why, int width,
                       FILE *out)
{
    char text[1024] = "", names[512] = "";
    int points = report->receiver_count, most = 0;
    bool of_points = false;
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        if (count_rows(report, column, why, points + 1) == 0)
            continue;
        int missing = count_rows(report, column, why, points);
        most = missing > most ? missing : most;
        of_points |= column->points != NULL;
        if (!is_listed(names, column->name))
            pp_text_append(names, sizeof names, "%s%s", names[0] ? ", " : "",
                           column->name);
    }
    if (!names_itself(names, why))
        pp_text_append(text, sizeof text, "%s: ", names);
    pp_text_append(text, sizeof text, "%s", why);
    if (of_points && most == 0)
        pp_text_append(text, sizeof text, " (the average)");
    else if (of_points && most < points)
        pp_text_append(text, sizeof text, " (%d of %d points)", most, points);
    fputs("  - ", out);
    pp_print_wrapped(text, 4, 4, width, out);
}

/* Prints "- average-df: the allowance for decorations (0.9) is not applied ...". The
 * note lists the methods that calculate the daylight factor in one step; it is omitted
 * if there are none. */
static void note_decorations(const struct pp_report *report, int width, FILE *out)
{
    char text[512] = "";
    for (int i = 0; i < report->column_count; i++) {
        const char *name = report->columns[i].name;
        const struct pp_method *method = pp_method_find(name);
        if (method && method->gives == PP_GIVES_WHOLE)
            pp_text_append(text, sizeof text, "%s%s", text[0] ? ", " : "", name);
    }
    if (!text[0])
        return;
    pp_text_append(text, sizeof text,
                   ": the factor for deterioration of decorations (%.3g) is not "
                   "applied, because it applies only to the internally reflected "
                   "component",
                   report->world->decorations);
    fputs("  - ", out);
    pp_print_wrapped(text, 4, 4, width, out);
}

/* True if the room has an allowance for decorations (not 1) and a method ignores it,
 * because the method calculates the daylight factor in one step. */
static bool leaves_decorations(const struct pp_report *report)
{
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_method *method = pp_method_find(report->columns[i].name);
        if (method && method->gives == PP_GIVES_WHOLE)
            return report->world->decorations != 1.0;
    }
    return false;
}

/* True if any hand method has a daylight factor in any row. */
static bool says_something(const struct pp_report *report)
{
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        if (column->component != PP_DF || pp_engine_of_column(column->name))
            continue;
        for (int row = 0; row <= report->receiver_count; row++) {
            const struct pp_reading *reading =
                pp_print_notes_reading(report, column, row);
            if (reading && isfinite(reading->value))
                return true;
        }
    }
    return false;
}

/* Suggests a pair of methods that is valid for any sky and any opening, if no selected
 * hand method gives a daylight factor. */
static void print_hint(const struct pp_report *report, int width, FILE *out)
{
    bool any_df = false;
    for (int i = 0; i < report->column_count; i++)
        any_df |= report->columns[i].component == PP_DF
                  && !pp_engine_of_column(report->columns[i].name);
    if (!any_df || says_something(report)
        || pp_report_find(report, PP_DF, "exact+split-flux"))
        return;
    fputs("  - ", out);
    pp_print_wrapped("None of these hand methods applies to this room. Use --methods "
                     "exact+split-flux for other skies and for sloping or horizontal "
                     "openings, or --simulate for any room.",
                     4, 4, width, out);
}

bool pp_print_notes(const struct pp_report *report, int width, FILE *out)
{
    struct reasons reasons = {0};
    if (!collect_reasons(&reasons, report)) {
        free(reasons.list);
        return false;
    }
    bool nothing_outside = pp_print_notes_is_zero(report, PP_ERC);
    bool undecorated = leaves_decorations(report);
    if (report->stand_in || report->missed_error || reasons.count > 0 || nothing_outside
        || undecorated)
        fputc('\n', out);
    const char *const whole[] = {report->stand_in, report->missed_error};
    for (int i = 0; i < 2; i++) {
        char sentence[320];
        if (!whole[i])
            continue;
        snprintf(sentence, sizeof sentence, "%s.", whole[i]);
        fputs("  - ", out);
        pp_print_wrapped(sentence, 4, 4, width, out);
    }
    if (nothing_outside)
        fputs("  - The externally reflected component is 0 everywhere.\n", out);
    for (int i = 0; i < reasons.count; i++)
        print_note(report, reasons.list[i], width, out);
    if (undecorated)
        note_decorations(report, width, out);
    if (reasons.count > 0)
        print_hint(report, width, out);
    free(reasons.list);
    return true;
}
