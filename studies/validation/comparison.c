/* comparison.c - bias, spread and worst difference of each column of a report, and their
 * sums over rooms.
 */
#include "studies/validation/comparison.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The standard error of a reading; 0 where nothing was sampled. */
static double known_error(const struct pp_reading *reading)
{
    return isfinite(reading->std_error) ? reading->std_error : 0.0;
}

/* The reason of the first reading without a value. */
static const char *reason(const struct pp_report *report,
                          const struct pp_column *column)
{
    for (int i = 0; column->points && i < report->receiver_count; i++)
        if (column->points[i].why)
            return column->points[i].why;
    return column->average.why;
}

static struct pp_comparison compare(const struct pp_report *report,
                                    const struct pp_column *column,
                                    const struct pp_column *traced)
{
    struct pp_comparison result = {.component = column->component,
                                   .name = column->name,
                                   .average = NAN,
                                   .traced_average = traced->average.value,
                                   .traced_average_error =
                                       known_error(&traced->average)};
    double sum = 0.0, squares = 0.0, noise = 0.0, truth = 0.0;
    for (int i = 0; column->points && i < report->receiver_count; i++) {
        double off = column->points[i].value - traced->points[i].value;
        double error = known_error(&traced->points[i]);
        if (!isfinite(off))
            continue;
        result.points++;
        sum += off;
        squares += off * off;
        noise += error * error;
        truth += traced->points[i].value;
        if (result.points == 1 || fabs(off) > fabs(result.worst)) {
            result.worst = off;
            result.worst_error = error;
            result.worst_point = i;
        }
    }
    if (result.points > 0) {
        int n = result.points;
        result.traced = truth / n;
        result.bias = sum / n;
        result.bias_error = sqrt(noise) / n;
        result.spread = sqrt(fmax((squares - noise) / n, 0.0));
    }
    if (!column->of_all_surfaces)
        result.average = column->average.value;
    if (result.points == 0 && !isfinite(result.average))
        result.why = column->of_all_surfaces
                         ? "it averages all surfaces of the room, not its working plane"
                         : reason(report, column);
    return result;
}

enum pp_status pp_comparison_of_report(struct pp_comparison **list, int *count,
                                       const struct pp_report *report,
                                       struct pp_error *err)
{
    *count = 0;
    *list = calloc((size_t)report->column_count + 1, sizeof **list);
    if (!*list)
        return pp_fail_memory(err);
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        const struct pp_column *traced =
            pp_report_find(report, column->component, "traced");
        if (traced && traced != column)
            (*list)[(*count)++] = compare(report, column, traced);
    }
    return PP_OK;
}

/* ---- over several rooms ---- */

static void add_points(struct pp_overall *overall, const struct pp_comparison *one,
                       int room)
{
    if (one->points == 0 || !(one->traced > 0.0))
        return;
    double n = one->points;
    overall->rooms++;
    overall->points += one->points;
    overall->bias += n * one->bias / one->traced;
    overall->spread += n * pow(one->spread / one->traced, 2.0);
    double worst = one->worst / one->traced;
    if (!overall->worst_comparison || fabs(worst) > fabs(overall->worst)) {
        overall->worst = worst;
        overall->worst_room = room;
        overall->worst_comparison = one;
    }
}

static void add_average(struct pp_overall *overall, const struct pp_comparison *one)
{
    double off = one->average / one->traced_average - 1.0;
    if (!isfinite(off))
        return;
    overall->averages++;
    overall->average_bias += off;
    overall->average_spread += off * off;
}

static struct pp_overall *find(struct pp_overall *list, int *count,
                               const struct pp_comparison *one)
{
    for (int i = 0; i < *count; i++)
        if (list[i].component == one->component && strcmp(list[i].name, one->name) == 0)
            return &list[i];
    struct pp_overall *added = &list[(*count)++];
    added->component = one->component;
    added->name = one->name;
    return added;
}

enum pp_status pp_comparison_overall(struct pp_overall **list, int *count,
                                     struct pp_comparison *const *rooms,
                                     const int *counts, int room_count,
                                     struct pp_error *err)
{
    int most = 1;
    for (int i = 0; i < room_count; i++)
        most += counts[i];
    *count = 0;
    *list = calloc((size_t)most, sizeof **list);
    if (!*list)
        return pp_fail_memory(err);
    for (int i = 0; i < room_count; i++)
        for (int k = 0; k < counts[i]; k++) {
            struct pp_overall *overall = find(*list, count, &rooms[i][k]);
            add_points(overall, &rooms[i][k], i);
            add_average(overall, &rooms[i][k]);
        }
    for (int i = 0; i < *count; i++) {
        struct pp_overall *overall = &(*list)[i];
        if (overall->points > 0) {
            overall->bias /= overall->points;
            overall->spread = sqrt(overall->spread / overall->points);
        }
        if (overall->averages > 0) {
            overall->average_bias /= overall->averages;
            overall->average_spread = sqrt(overall->average_spread / overall->averages);
        }
    }
    return PP_OK;
}
