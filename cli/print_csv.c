#include "cli/print.h"

#include <math.h>
#include <string.h>

const char *const pp_component_names[PP_COMPONENT_COUNT] = {"sc", "erc", "irc", "df"};

/* A field, in quotes where it holds what would end it. */
static void put_field(const char *text, FILE *out)
{
    if (!text)
        return;
    if (!strpbrk(text, "\",\r\n")) {
        fputs(text, out);
        return;
    }
    fputc('"', out);
    for (; *text; text++) {
        if (*text == '"')
            fputc('"', out);
        fputc(*text, out);
    }
    fputc('"', out);
}

/* Behind a comma; nothing for what is not a number. */
static void put_number(double number, FILE *out)
{
    fputc(',', out);
    if (isfinite(number))
        fprintf(out, "%.10g", number + 0.0);
}

/* One reading; receiver NULL: of the average. With external_lux over 0 a field more:
 * what a daylight factor makes of so many lux outside. */
static void put_line(const struct pp_result *result, const struct pp_column *column,
                     const struct pp_receiver *receiver,
                     const struct pp_reading *reading, double external_lux, FILE *out)
{
    put_field(result->file, out);
    fputc(',', out);
    put_field(result->report.world->name, out);
    if (receiver) {
        fputs(",point", out);
        put_number(receiver->position.x, out);
        put_number(receiver->position.y, out);
        put_number(receiver->position.z, out);
        put_number(receiver->normal.x, out);
        put_number(receiver->normal.y, out);
        put_number(receiver->normal.z, out);
    } else {
        fputs(",average,,,,,,", out);
    }
    fprintf(out, ",%s,%s", pp_component_names[column->component], column->name);
    put_number(100.0 * reading->value, out);
    put_number(100.0 * reading->std_error, out);
    fprintf(out, ",%s,", result->report.finished ? "yes" : "no");
    put_field(isfinite(reading->value) ? NULL : reading->why, out);
    if (external_lux > 0.0)
        put_number(column->component == PP_DF ? external_lux * reading->value : NAN,
                   out);
    fputs("\r\n", out);
}

enum pp_status pp_print_csv(const struct pp_results *results, FILE *out,
                            struct pp_error *err)
{
    (void)err;
    fputs("file,room,place,x,y,z,nx,ny,nz,component,method,value_percent,"
          "std_error_percent,finished,why",
          out);
    double lux = results->options->external_lux;
    fputs(lux > 0.0 ? ",lux\r\n" : "\r\n", out);
    for (int i = 0; i < results->count; i++) {
        const struct pp_result *result = &results->list[i];
        const struct pp_report *report = &result->report;
        for (int r = 0; r < report->receiver_count; r++)
            for (int c = 0; c < report->column_count; c++)
                if (report->columns[c].points)
                    put_line(result, &report->columns[c], &report->receivers[r],
                             &report->columns[c].points[r], lux, out);
        for (int c = 0; c < report->column_count; c++)
            put_line(result, &report->columns[c], NULL, &report->columns[c].average,
                     lux, out);
    }
    return PP_OK;
}
