/* annual_csv.c - see annual_csv.h. */
#include "reports/annual/annual_csv.h"

#include <math.h>

#include "reports/annual/hand_year_report.h"
#include "reports/annual/lighting_report.h"
#include "reports/parts/format.h"

static void put_value(const struct pp_annual_figures *of, int index, double unit,
                      FILE *out)
{
    struct pp_annual_figures figures = *of;
    const struct pp_annual_value *value = pp_annual_sheet_figure(&figures, index);
    pp_format_csv_number(unit * value->value, out);
    pp_format_csv_number(isfinite(value->value) ? unit * value->std_error : NAN, out);
}

static void put_figures(const struct pp_annual_sheet *sheet,
                        const struct pp_annual_figures *figures, FILE *out)
{
    for (int i = 0; i < sheet->illuminance_count; i++) {
        put_value(figures, pp_annual_result_autonomy(i, false), 100.0, out);
        put_value(figures, pp_annual_result_autonomy(i, true), 100.0, out);
    }
    for (const struct pp_annual_figure_name *n = pp_annual_result_names; n->name; n++)
        put_value(figures, n->index, n->unit, out);
}

static void put_annual_heading(const struct pp_annual_result *result, FILE *out)
{
    const struct pp_annual_sheet *sheet = &result->sheet;
    fputs("file,room,place,x,y,z", out);
    for (int i = 0; i < sheet->illuminance_count; i++) {
        double lx = sheet->illuminances_lx[i];
        fprintf(out, ",da%g,da%g_se,cda%g,cda%g_se", lx, lx, lx, lx);
    }
    for (const struct pp_annual_figure_name *n = pp_annual_result_names; n->name; n++)
        fprintf(out, ",%s,%s_se", n->name, n->name);
    pp_lighting_report_csv_names(sheet, out);
    fputs(",finished", out);
    pp_hand_year_report_csv_heading(&result->hand, sheet, out);
    fputs("\r\n", out);
}

static void put_annual_line(const struct pp_annual_result *result, int point, FILE *out)
{
    const struct pp_annual_sheet *sheet = &result->sheet;
    pp_format_csv_field(result->file, out);
    fputc(',', out);
    pp_format_csv_field(sheet->world->name, out);
    if (point >= 0) {
        struct pp_vec3 at = sheet->receivers[point].position;
        fputs(",point", out);
        pp_format_csv_number(at.x, out);
        pp_format_csv_number(at.y, out);
        pp_format_csv_number(at.z, out);
    } else {
        fputs(",average,,,", out);
    }
    put_figures(sheet, point >= 0 ? &sheet->points[point] : &sheet->mean, out);
    pp_lighting_report_csv_point(sheet, point, out);
    fprintf(out, ",%s", sheet->finished ? "yes" : "no");
    pp_hand_year_report_csv(&result->hand, sheet, point, out);
    fputs("\r\n", out);
}

/* Writes the line of an electric-lighting control; the daylight fields are empty. */
static void put_lighting_line(const struct pp_annual_result *result, int k, FILE *out)
{
    const struct pp_annual_sheet *sheet = &result->sheet;
    int figures = 2 * sheet->illuminance_count;
    for (const struct pp_annual_figure_name *n = pp_annual_result_names; n->name; n++)
        figures++;
    pp_format_csv_field(result->file, out);
    fputc(',', out);
    pp_format_csv_field(sheet->world->name, out);
    fprintf(out, ",lighting%d,,,", k + 1);
    for (int i = 0; i < figures; i++)
        fputs(",,", out);
    pp_lighting_report_csv_control(sheet, k, out);
    fputs(",yes", out);
    for (int i = pp_hand_year_report_csv_columns(&result->hand, sheet); i > 0; i--)
        fputc(',', out);
    fputs("\r\n", out);
}

enum pp_status pp_annual_csv(const struct pp_annual_results *results, FILE *out,
                             struct pp_error *err)
{
    (void)err;
    if (results->count > 0)
        put_annual_heading(&results->list[0], out);
    for (int i = 0; i < results->count; i++) {
        const struct pp_annual_sheet *sheet = &results->list[i].sheet;
        for (int x = 0; x < sheet->receiver_count && sheet->finished; x++)
            put_annual_line(&results->list[i], x, out);
        if (sheet->finished)
            put_annual_line(&results->list[i], -1, out);
        for (int k = 0; k < sheet->lighting_count && sheet->finished; k++)
            put_lighting_line(&results->list[i], k, out);
    }
    return PP_OK;
}
