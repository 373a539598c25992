/* report.c - see report.h. */
#include "model/results/report.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

const double pp_plane_levels[PP_PLANE_LEVELS] = {0.01, 0.02, 0.05};

struct pp_column *pp_report_add(struct pp_report *report, enum pp_component component,
                                const char *name, bool for_points)
{
    struct pp_reading *points = NULL;
    if (for_points) {
        points = malloc(((size_t)report->receiver_count + 1) * sizeof *points);
        if (!points)
            return NULL;
        for (int i = 0; i < report->receiver_count; i++)
            points[i] = pp_reading_none("not calculated");
    }
    if (pp_array_append(&report->columns, report->column_count, sizeof *report->columns,
                        NULL)
        != PP_OK) {
        free(points);
        return NULL;
    }

    struct pp_column *columns = report->columns;
    int at = report->column_count;
    while (at > 0 && columns[at - 1].component > component)
        at--;
    struct pp_column *column = columns + at;
    memmove(column + 1, column, (size_t)(report->column_count - at) * sizeof *column);
    report->column_count++;
    *column = (struct pp_column){.component = component,
                                 .average = pp_reading_none("not calculated"),
                                 .average_band = pp_band_none(),
                                 .points = points};
    snprintf(column->name, sizeof column->name, "%s", name);
    return column;
}

const struct pp_column *pp_report_find(const struct pp_report *report,
                                       enum pp_component component, const char *name)
{
    for (int i = 0; i < report->column_count; i++)
        if (report->columns[i].component == component
            && strcmp(report->columns[i].name, name) == 0)
            return report->columns + i;
    return NULL;
}

const char *pp_report_say(struct pp_report *report, const char *format, ...)
{
    char *sentence;
    va_list args;
    va_start(args, format);
    int length = vasprintf(&sentence, format, args);
    va_end(args);
    if (length < 0)
        return NULL;
    for (int i = 0; i < report->sentence_count; i++)
        if (strcmp(report->sentences[i], sentence) == 0) {
            free(sentence);
            return report->sentences[i];
        }
    if (pp_array_append(&report->sentences, report->sentence_count, sizeof sentence,
                        NULL)
        != PP_OK) {
        free(sentence);
        return NULL;
    }
    report->sentences[report->sentence_count++] = sentence;
    return sentence;
}

struct pp_steps *pp_report_steps(struct pp_report *report)
{
    if (pp_array_append(&report->steps, report->steps_count, sizeof *report->steps,
                        NULL)
        != PP_OK)
        return NULL;
    struct pp_steps *steps = calloc(1, sizeof *steps);
    if (steps)
        report->steps[report->steps_count++] = steps;
    return steps;
}

void pp_report_clear(struct pp_report *report)
{
    for (int i = 0; i < report->column_count; i++) {
        free(report->columns[i].points);
        free(report->columns[i].bands);
    }
    free(report->columns);
    for (int i = 0; i < report->sentence_count; i++)
        free(report->sentences[i]);
    free(report->sentences);
    for (int i = 0; i < report->steps_count; i++) {
        pp_steps_clear(report->steps[i]);
        free(report->steps[i]);
    }
    free(report->steps);
    free(report->more_receivers);
    report->more_receivers = NULL;
    report->columns = NULL;
    report->column_count = 0;
    report->sentences = NULL;
    report->sentence_count = 0;
    report->stand_in = NULL;
    report->no_bands = NULL;
    report->missed_error = NULL;
    report->steps = NULL;
    report->steps_count = 0;
}
