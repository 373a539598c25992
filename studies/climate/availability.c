/* availability.c - fills the sheet of an availability study. The rows come first: one
 * for each place, method and illuminance. Then follow, for each period, the curve and
 * the fraction of hours of each row. */
#include "studies/climate/availability.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

double pp_availability_needed_lx(double lx, double daylight_factor)
{
    return daylight_factor > 0.0 ? lx / daylight_factor : INFINITY;
}

/* Writes an hour of the day as "8" or "17:30". Returns the length of the text. */
static int write_clock(char *text, size_t room, double hour)
{
    int minutes = (int)lround(60.0 * hour);
    return minutes % 60 ? snprintf(text, room, "%d:%02d", minutes / 60, minutes % 60)
                        : snprintf(text, room, "%d", minutes / 60);
}

static enum pp_status fill_period(struct pp_availability_period *period,
                                  struct pp_diffuse_curve *curve, struct pp_error *err)
{
    period->hours = curve->total_h;
    period->missing_h = curve->missing_h;
    period->light = pp_diffuse_curve_share(curve, 0.0);
    period->half_lx = pp_diffuse_curve_lx(curve, 0.5);
    period->most_lx = pp_diffuse_curve_lx(curve, 0.85);
    period->count = curve->count;
    period->lx = malloc((size_t)curve->count * sizeof *period->lx);
    period->share = malloc((size_t)curve->count * sizeof *period->share);
    if (!period->lx || !period->share)
        return pp_fail_memory(err);
    for (int i = 0; i < curve->count; i++) {
        period->lx[i] = curve->lx[i];
        period->share[i] = curve->reached_h[i] / curve->total_h;
    }
    return PP_OK;
}

/* Sets the fraction of a period's hours in which a row's illuminance is reached, and
 * its standard error. The standard error is half the difference between the fractions
 * for daylight factors one standard error higher and lower. */
static void fill_share(struct pp_availability_row *row, int period,
                       const struct pp_diffuse_curve *curve)
{
    double df = row->df.value, error = row->df.std_error;
    row->share[period] = row->std_error[period] = NAN;
    if (!isfinite(df))
        return;
    row->share[period] = pp_diffuse_curve_share(curve, row->needs_lx);
    if (!isfinite(error))
        return;
    double up = pp_availability_needed_lx(row->lx, df + error);
    double down = pp_availability_needed_lx(row->lx, fmax(df - error, 0.0));
    row->std_error[period] =
        0.5 * (pp_diffuse_curve_share(curve, up) - pp_diffuse_curve_share(curve, down));
}

static int compare_readings(const void *a, const void *b)
{
    double p = ((const struct pp_reading *)a)->value;
    double q = ((const struct pp_reading *)b)->value;
    return (p > q) - (p < q);
}

/* Stores the median of a column's points in *median. Returns false if fewer than three
 * points have a value. sorted: space for all points. For an even number of points the
 * median is the mean of the middle two values; its standard error is the larger of
 * their standard errors. */
static bool median_of(const struct pp_report *report, const struct pp_column *column,
                      struct pp_reading *median, struct pp_reading *sorted)
{
    int count = 0;
    for (int i = 0; column->points && i < report->receiver_count; i++)
        if (isfinite(column->points[i].value))
            sorted[count++] = column->points[i];
    if (count < 3)
        return false;
    qsort(sorted, (size_t)count, sizeof *sorted, compare_readings);
    const struct pp_reading *low = &sorted[(count - 1) / 2], *high = &sorted[count / 2];
    *median = pp_reading_of(0.5 * (low->value + high->value));
    if (isfinite(low->std_error) && isfinite(high->std_error))
        median->std_error = fmax(low->std_error, high->std_error);
    return true;
}

static void add_rows(struct pp_availability_sheet *sheet, int place,
                     const struct pp_column *column, struct pp_reading df)
{
    for (int i = 0; i < sheet->illuminance_count; i++) {
        struct pp_availability_row *row = &sheet->rows[sheet->row_count++];
        double lx = sheet->illuminances_lx[i];
        *row = (struct pp_availability_row){.place = place,
                                            .method = column->name,
                                            .df = df,
                                            .lx = lx,
                                            .needs_lx = NAN};
        if (isfinite(df.value))
            row->needs_lx = pp_availability_needed_lx(lx, df.value);
    }
}

/* Sets all rows except the fractions of hours: points in their order, then the median,
 * then the average. */
static enum pp_status fill_rows(struct pp_availability_sheet *sheet,
                                struct pp_error *err)
{
    const struct pp_report *report = sheet->report;
    size_t places = (size_t)report->receiver_count + 2;
    size_t rows =
        places * (size_t)(report->column_count + 1) * (size_t)sheet->illuminance_count;
    struct pp_reading *sorted = malloc(places * sizeof *sorted);
    sheet->rows = malloc((rows + 1) * sizeof *sheet->rows);
    for (int place = 0; sorted && sheet->rows && place < (int)places; place++)
        for (int i = 0; i < report->column_count; i++) {
            const struct pp_column *column = &report->columns[i];
            struct pp_reading median;
            if (column->component != PP_DF)
                continue;
            if (place == report->receiver_count + 1)
                add_rows(sheet, PP_PLACE_AVERAGE, column, column->average);
            else if (place < report->receiver_count && column->points)
                add_rows(sheet, place, column, column->points[place]);
            else if (place == report->receiver_count
                     && median_of(report, column, &median, sorted))
                add_rows(sheet, PP_PLACE_MEDIAN, column, median);
        }
    free(sorted);
    return sorted && sheet->rows ? PP_OK : pp_fail_memory(err);
}

enum pp_status pp_availability_fill(struct pp_availability_sheet *sheet,
                                    const struct pp_availability_question *question,
                                    const struct pp_report *report,
                                    struct pp_error *err)
{
    *sheet = (struct pp_availability_sheet){
        .report = report,
        .origin = question->light->origin,
        .light = question->light_words,
        .calendar = question->calendar_words,
        .illuminance_count = question->illuminance_count,
    };
    for (int i = 0; i < question->illuminance_count; i++)
        sheet->illuminances_lx[i] = question->illuminances_lx[i];
    enum pp_status status =
        pp_diffuse_light_median(&sheet->median_lx, question->light, err);
    if (status == PP_OK && report)
        status = fill_rows(sheet, err);
    for (int i = 0; status == PP_OK && i < question->period_count; i++) {
        const struct pp_working_hours *hours = &question->periods[i];
        struct pp_availability_period *period = &sheet->periods[sheet->period_count++];
        int length = write_clock(period->words, sizeof period->words, hours->from_h);
        period->words[length++] = '-';
        write_clock(period->words + length, sizeof period->words - (size_t)length,
                    hours->to_h);

        struct pp_diffuse_curve curve;
        status = pp_diffuse_curve_init(&curve, question->light, hours,
                                       &question->summer, err);
        if (status == PP_OK)
            status = fill_period(period, &curve, err);
        for (int k = 0; status == PP_OK && k < sheet->row_count; k++)
            fill_share(&sheet->rows[k], i, &curve);
        pp_diffuse_curve_clear(&curve);
    }
    return status;
}
