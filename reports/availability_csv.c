/* availability_csv.c - writes one line of CSV for each place, method, illuminance and
 * period. */
#include "reports/availability_csv.h"

#include <math.h>

#include "reports/parts/format.h"

static void put_availability_row(const struct pp_availability_result *result,
                                 const struct pp_availability_row *row, int period,
                                 FILE *out)
{
    const struct pp_availability_sheet *sheet = &result->sheet;
    pp_format_csv_field(result->file, out);
    fputc(',', out);
    pp_format_csv_field(result->report.world->name, out);
    if (row->place >= 0) {
        struct pp_vec3 at = result->report.receivers[row->place].position;
        fputs(",point", out);
        pp_format_csv_number(at.x, out);
        pp_format_csv_number(at.y, out);
        pp_format_csv_number(at.z, out);
    } else {
        fputs(row->place == PP_PLACE_AVERAGE ? ",average,,," : ",median,,,", out);
    }
    fprintf(out, ",%s", row->method);
    pp_format_csv_number(100.0 * row->df.value, out);
    pp_format_csv_number(100.0 * row->df.std_error, out);
    pp_format_csv_number(row->lx, out);
    pp_format_csv_number(row->needs_lx, out);
    fprintf(out, ",%s", sheet->periods[period].words);
    pp_format_csv_number(100.0 * row->share[period], out);
    pp_format_csv_number(100.0 * row->std_error[period], out);
    fprintf(out, ",%s,", result->report.finished ? "yes" : "no");
    pp_format_csv_field(isfinite(row->df.value) ? NULL : row->df.why, out);
    fputs("\r\n", out);
}

enum pp_status pp_availability_csv(const struct pp_availability_results *results,
                                   FILE *out, struct pp_error *err)
{
    (void)err;
    fputs("file,room,place,x,y,z,method,df_percent,df_std_error_percent,illuminance_lx,"
          "needs_lx,hours,reached_percent,reached_std_error_percent,finished,why\r\n",
          out);
    for (int i = 0; i < results->count; i++) {
        const struct pp_availability_sheet *sheet = &results->list[i].sheet;
        for (int row = 0; row < sheet->row_count; row++)
            for (int period = 0; period < sheet->period_count; period++)
                put_availability_row(&results->list[i], &sheet->rows[row], period, out);
    }
    return PP_OK;
}
