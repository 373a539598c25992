/* advice.c - compares the widths of the bands of all methods, point by point. */
#include "studies/bands/advice.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "studies/bands/report_bands.h"

/* Limits for the width of a band divided by the width of the narrowest band (widths of
 * logarithms). A band up to about_as_narrow is preferred if its method is earlier in
 * the report. A band up to narrow_enough is preferred if its method is the best over
 * all points. */
static const double about_as_narrow = 1.1, narrow_enough = 1.25;

/* Bands of daylight factors at one point, in the order of the report's columns. The
 * lists have space for all columns. */
struct ranking {
    struct pp_band_index index;
    struct pp_band_record *list;
    int *columns; /* indices of the columns in the report */
    int count;
};

static double width_of(const struct pp_band_record *record)
{
    const struct pp_band_quantiles *ratio = &record->entry.regime.ratio;
    return log(ratio->high / fmax(ratio->low, 1e-3));
}

/* Value at a point; index -1: the average. */
static double figure_of(const struct pp_column *column, int index)
{
    return index < 0 ? column->average.value : column->points[index].value;
}

/* Looks up the bands of all methods at a point; index -1: the bands of the averages. */
static void look_up(struct ranking *ranking, const struct pp_report *report,
                    double features[PP_BAND_FEATURES], int index)
{
    enum pp_band_place place = index < 0 ? PP_BAND_AVERAGE : PP_BAND_POINT;
    ranking->count = 0;
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        struct pp_band_regimes regimes;
        if (column->component != PP_DF || (index >= 0 && !column->points)
            || !pp_report_bands_has(report, column))
            continue;
        double figure = figure_of(column, index);
        pp_band_table_find(&regimes, &ranking->index, PP_DF, column->name);
        const struct pp_band_columns columns = pp_band_features_columns(report, column);
        pp_band_features_of_columns(features, &columns, index);
        const struct pp_band_record *record =
            pp_band_table_regime(&regimes, place, features);
        if (!record || !isfinite(figure))
            continue;
        ranking->columns[ranking->count] = i;
        ranking->list[ranking->count++] = *record;
    }
}

static int narrowest(const struct ranking *ranking)
{
    int found = 0;
    for (int i = 1; i < ranking->count; i++)
        if (width_of(&ranking->list[i]) < width_of(&ranking->list[found]))
            found = i;
    return found;
}

/* Index of the best band in the ranking: the band of the column `favourite` if that is
 * narrow enough, else the first band that is about as narrow as the narrowest. */
static int best_of(const struct ranking *ranking, int favourite)
{
    double least = width_of(&ranking->list[narrowest(ranking)]);
    int best = 0;
    for (int i = 0; i < ranking->count; i++)
        if (ranking->columns[i] == favourite
            && width_of(&ranking->list[i]) <= narrow_enough * least)
            return i;
    while (width_of(&ranking->list[best]) > about_as_narrow * least)
        best++;
    return best;
}

/* Finds the column with the narrowest bands on average. Only columns with bands at the
 * greatest number of points are considered. -1: none. */
static enum pp_status find_favourite(int *favourite, const struct pp_report *report,
                                     double features[PP_BAND_FEATURES],
                                     struct ranking *ranking, struct pp_error *err)
{
    double *sums = calloc((size_t)report->column_count + 1, sizeof *sums);
    int *counts = calloc((size_t)report->column_count + 1, sizeof *counts), most = 0;
    bool good = sums && counts;
    for (int i = 0; i < report->receiver_count && good; i++) {
        if (!pp_report_bands_point(features, report, i))
            continue;
        look_up(ranking, report, features, i);
        for (int k = 0; k < ranking->count; k++) {
            int column = ranking->columns[k];
            sums[column] += width_of(&ranking->list[k]);
            most = ++counts[column] > most ? counts[column] : most;
        }
    }
    *favourite = -1;
    for (int i = 0; i < report->column_count && good; i++)
        if (counts[i] == most && most > 0
            && (*favourite < 0 || sums[i] < sums[*favourite]))
            *favourite = i;
    free(sums);
    free(counts);
    return good ? PP_OK : pp_fail_memory(err);
}

/* ---- items ---- */

static bool same_band_record(const struct pp_band_record *a,
                             const struct pp_band_record *b)
{
    return a->place == b->place && strcmp(a->column, b->column) == 0
           && memcmp(&a->entry.regime.ratio, &b->entry.regime.ratio,
                     sizeof a->entry.regime.ratio)
                  == 0;
}

/* Adds the narrowest bands of other columns, in ascending order of width. */
static void add_others(struct pp_advice_item *item, const struct ranking *ranking,
                       int best)
{
    for (int i = 0; i < ranking->count; i++) {
        const struct pp_band_record *record = &ranking->list[i];
        if (i == best)
            continue;
        int at = item->other_count;
        while (at > 0 && width_of(&item->others[at - 1]) > width_of(record))
            at--;
        if (at == PP_ADVICE_OTHERS)
            continue;
        item->other_count += item->other_count < PP_ADVICE_OTHERS;
        memmove(&item->others[at + 1], &item->others[at],
                (size_t)(item->other_count - 1 - at) * sizeof *record);
        item->others[at] = *record;
    }
}

static enum pp_status add_item(struct pp_advice *advice, const struct ranking *ranking,
                               int best, bool of_average, struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&advice->items, advice->count, sizeof *advice->items, err);
    if (status != PP_OK)
        return status;
    struct pp_advice_item *item = &advice->items[advice->count++];
    *item =
        (struct pp_advice_item){.best = ranking->list[best], .of_average = of_average};
    add_others(item, ranking, best);
    return PP_OK;
}

/* Appends the figure corrected by the median ratio of its band. */
static enum pp_status add_corrected(struct pp_advice_item *item, int count,
                                    double figure, struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&item->corrected, count, sizeof *item->corrected, err);
    if (status == PP_OK)
        item->corrected[count] = pp_band_regime_truth(
            figure, item->best.entry.regime.ratio.median, PP_BAND_OFFSET);
    return status;
}

/* Adds a point to the item for its best method. If there is no such item, makes a new
 * one. */
static enum pp_status add_point(struct pp_advice *advice, const struct ranking *ranking,
                                int best, int index, double figure,
                                struct pp_error *err)
{
    int i = 0;
    while (i < advice->count
           && !same_band_record(&advice->items[i].best, &ranking->list[best]))
        i++;
    enum pp_status status =
        i < advice->count ? PP_OK : add_item(advice, ranking, best, false, err);
    if (status != PP_OK)
        return status;
    struct pp_advice_item *item = &advice->items[i];
    status = add_corrected(item, item->point_count, figure, err);
    if (status == PP_OK)
        status = pp_array_append(&item->points, item->point_count, sizeof *item->points,
                                 err);
    if (status == PP_OK)
        item->points[item->point_count++] = index;
    return status;
}

static enum pp_status advise(struct pp_advice *advice, const struct pp_report *report,
                             double features[PP_BAND_FEATURES], struct ranking *ranking,
                             struct pp_error *err)
{
    int favourite;
    pp_band_table_index(&ranking->index, pp_band_table_under(&report->light.sky));
    look_up(ranking, report, features, -1);
    enum pp_status status = PP_OK;
    if (ranking->count > 0) {
        int best = best_of(ranking, -1);
        double figure = figure_of(&report->columns[ranking->columns[best]], -1);
        status = add_item(advice, ranking, best, true, err);
        if (status == PP_OK)
            status = add_corrected(&advice->items[0], 0, figure, err);
    }
    if (status == PP_OK)
        status = find_favourite(&favourite, report, features, ranking, err);
    for (int i = 0; i < report->receiver_count && status == PP_OK; i++) {
        if (!pp_report_bands_point(features, report, i))
            continue;
        look_up(ranking, report, features, i);
        if (ranking->count == 0)
            continue;
        int best = best_of(ranking, favourite);
        double figure = figure_of(&report->columns[ranking->columns[best]], i);
        status = add_point(advice, ranking, best, i, figure, err);
    }
    return status;
}

enum pp_status pp_advice_of(struct pp_advice *advice, struct pp_report *report,
                            struct pp_error *err)
{
    double features[PP_BAND_FEATURES];
    const char *why;
    *advice = (struct pp_advice){.count = 0};
    size_t most = (size_t)report->column_count + 1;
    struct ranking ranking = {.list = malloc(most * sizeof *ranking.list),
                              .columns = malloc(most * sizeof *ranking.columns)};
    enum pp_status status = ranking.list && ranking.columns
                                ? pp_report_bands_features(features, &why, report, err)
                                : pp_fail_memory(err);
    if (status == PP_OK && why)
        snprintf(advice->why_not, sizeof advice->why_not, "%s", why);
    else if (status == PP_OK)
        status = advise(advice, report, features, &ranking, err);
    if (status == PP_OK && advice->count == 0 && !why)
        snprintf(advice->why_not, sizeof advice->why_not,
                 "none of the methods in the atlas gives a value here");
    free(ranking.list);
    free(ranking.columns);
    return status;
}

void pp_advice_clear(struct pp_advice *advice)
{
    for (int i = 0; i < advice->count; i++) {
        free(advice->items[i].points);
        free(advice->items[i].corrected);
    }
    free(advice->items);
    *advice = (struct pp_advice){.count = 0};
}
