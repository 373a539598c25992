/* df_csv.c - puts one reading on each line of a CSV. */
#include "reports/df_csv.h"

#include <math.h>

#include "reports/parts/format.h"
#include "reports/parts/print_band.h"

/* One reading and its band, of a receiver or (NULL) of the mean that `place` names. With
 * external_lux over 0 a field more: the illuminance of the daylight factor under
 * external_lux. */
static void put_line(const struct pp_result *result, const struct pp_column *column,
                     const struct pp_receiver *receiver, const char *place,
                     const struct pp_reading *reading, struct pp_band band,
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
    pp_format_csv_number(100.0 * band.low, out);
    pp_format_csv_number(100.0 * band.high, out);
    fputs("\r\n", out);
}

enum pp_status pp_df_csv(const struct pp_results *results, FILE *out,
                         struct pp_error *err)
{
    (void)err;
    fputs("file,room,place,x,y,z,nx,ny,nz,component,method,value_percent,"
          "std_error_percent,finished,why",
          out);
    double lux = results->options->external_lux;
    fputs(lux > 0.0 ? ",lux" : "", out);
    fputs(",band_low_percent,band_high_percent\r\n", out);
    for (int i = 0; i < results->count; i++) {
        const struct pp_result *result = &results->list[i];
        const struct pp_report *report = &result->report;
        for (int r = 0; r < report->receiver_count; r++)
            for (int c = 0; c < report->column_count; c++)
                if (report->columns[c].points)
                    put_line(result, &report->columns[c], &report->receivers[r], NULL,
                             &report->columns[c].points[r],
                             pp_print_band_at(&report->columns[c], r,
                                              report->receiver_count),
                             lux, out);
        for (int c = 0; c < report->column_count; c++)
            put_line(result, &report->columns[c], NULL, "average",
                     &report->columns[c].average, report->columns[c].average_band, lux,
                     out);
        for (int c = 0; c < report->column_count; c++)
            if (report->columns[c].has_margin_average)
                put_line(result, &report->columns[c], NULL, "average-margin",
                         &report->columns[c].margin_average, pp_band_none(), lux, out);
    }
    return PP_OK;
}
