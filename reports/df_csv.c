/* df_csv.c - writes one reading per line of CSV. */
#include "reports/df_csv.h"

#include <math.h>

#include "reports/parts/format.h"
#include "reports/parts/print_band.h"

/* Writes one reading and its band (NULL: not requested). The reading belongs to a
 * receiver; receiver NULL: it is the average named `place`. If external_lux is above 0,
 * a further field has the illuminance: the daylight factor times external_lux. */
static void put_line(const struct pp_result *result, const struct pp_column *column,
                     const struct pp_receiver *receiver, const char *place,
                     const struct pp_reading *reading, const struct pp_band_ends *band,
                     double external_lux, FILE *out)
{
    pp_format_csv_field(result->file, out);
    fputc(',', out);
    pp_format_csv_field(result->report.world->name, out);
    if (receiver) {
        fputs(",point", out);
        pp_format_csv_number(receiver->position.x, out);
        pp_format_csv_number(receiver->position.y, out);
        pp_format_csv_number(receiver->position.z, out);
        pp_format_csv_number(receiver->normal.x, out);
        pp_format_csv_number(receiver->normal.y, out);
        pp_format_csv_number(receiver->normal.z, out);
    } else {
        fprintf(out, ",%s,,,,,,", place);
    }
    fprintf(out, ",%s,%s", pp_component_names[column->component], column->name);
    pp_format_csv_number(100.0 * reading->value, out);
    pp_format_csv_number(100.0 * reading->std_error, out);
    fprintf(out, ",%s,", result->report.finished ? "yes" : "no");
    pp_format_csv_field(isfinite(reading->value) ? NULL : reading->why, out);
    if (external_lux > 0.0)
        pp_format_csv_number(
            column->component == PP_DF ? external_lux * reading->value : NAN, out);
    if (band) {
        pp_format_csv_number(100.0 * band->low, out);
        pp_format_csv_number(100.0 * band->high, out);
    }
    fputs("\r\n", out);
}

/* Writes all columns at receiver `index`. index -1: writes the averages, or, if
 * `margin` is set, the averages inside the margin. */
static void put_lines(const struct pp_results *results, const struct pp_result *result,
                      int index, bool margin, FILE *out)
{
    const struct pp_report *report = &result->report;
    double lux = results->options->external_lux;
    for (int c = 0; c < report->column_count; c++) {
        const struct pp_column *column = &report->columns[c];
        if (index >= 0 ? !column->points : margin && !column->has_margin_average)
            continue;
        int place = index >= 0 ? index : report->receiver_count;
        struct pp_band_ends band =
            margin ? pp_band_none()
                   : pp_print_band_at(column, place, report->receiver_count);
        put_line(result, column, index >= 0 ? &report->receivers[index] : NULL,
                 margin ? "average-margin" : "average",
                 index >= 0 ? &column->points[index]
                 : margin   ? &column->margin_average
                            : &column->average,
                 results->bands ? &band : NULL, lux, out);
    }
}

enum pp_status pp_df_csv(const struct pp_results *results, FILE *out,
                         struct pp_error *err)
{
    (void)err;
    fputs("file,room,place,x,y,z,nx,ny,nz,component,method,value_percent,"
          "std_error_percent,finished,why",
          out);
    fputs(results->options->external_lux > 0.0 ? ",lux" : "", out);
    fputs(results->bands ? ",band_low_percent,band_high_percent\r\n" : "\r\n", out);
    for (int i = 0; i < results->count; i++) {
        const struct pp_result *result = &results->list[i];
        for (int r = 0; r < result->report.receiver_count; r++)
            put_lines(results, result, r, false, out);
        put_lines(results, result, -1, false, out);
        put_lines(results, result, -1, true, out);
    }
    return PP_OK;
}
