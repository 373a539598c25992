/* availability_text.c - prints the light outside, the periods, and one table for each
 * method. */
#include "reports/availability_text.h"

#include <math.h>
#include <string.h>

#include "model/results/reading.h"
#include "reports/parts/format.h"
#include "reports/parts/print.h"
#include "reports/parts/print_places.h"
#include "reports/parts/table.h"

/* ---- the light outside ---- */

static void print_availability_fact(const char *label, const char *text, int width,
                                    FILE *out)
{
    enum { LABEL = 15 };
    fprintf(out, "  %-*s", LABEL, label);
    pp_print_wrapped(text, LABEL + 2, LABEL + 2, width, out);
}

/* Writes a fraction of the working hours in per cent: "87", "0.4", "0". */
static void put_share(char cell[PP_CELL_BYTES], double share)
{
    double per_cent = 100.0 * share;
    if (!isfinite(share))
        snprintf(cell, PP_CELL_BYTES, "-");
    else
        snprintf(cell, PP_CELL_BYTES, "%.*f", per_cent > 0.0 && per_cent < 9.95 ? 1 : 0,
                 per_cent);
}

/* Writes an illuminance to three significant figures: "14300". Below 100 lx, writes it
 * to 1 lx. */
static void put_lux(char cell[PP_CELL_BYTES], double lx)
{
    double unit = lx > 0.0 ? pow(10.0, fmax(0.0, floor(log10(lx)) - 2.0)) : 1.0;
    if (!isfinite(lx))
        snprintf(cell, PP_CELL_BYTES, "-");
    else
        snprintf(cell, PP_CELL_BYTES, "%.0f", round(lx / unit) * unit);
}

/* Prints a row for each period: its hours, and the skylight during those hours. */
static bool print_periods(const struct pp_availability_sheet *sheet, int width,
                          FILE *out)
{
    static const char given[] = "lx outside in";
    struct pp_table table;
    pp_table_init(&table, sheet->period_count);
    static const char *const headings[] = {"working time", "hours", "with light %"};
    bool good = true;
    for (int i = 0; i < 5 && good; i++) {
        static const char *const shares[] = {"50 % of hours", "85 % of hours"};
        struct pp_table_column *column =
            i < 3 ? pp_table_add(&table, NULL, NULL, headings[i])
                  : pp_table_add(&table, given, "lx in", shares[i - 3]);
        good = column != NULL;
        for (int k = 0; good && k < sheet->period_count; k++) {
            const struct pp_availability_period *period = &sheet->periods[k];
            char *cell = column->cells[k];
            switch (i) {
            case 0:
                snprintf(cell, PP_CELL_BYTES, "%s", period->words);
                break;
            case 1:
                snprintf(cell, PP_CELL_BYTES, "%.0f", period->hours);
                break;
            case 2:
                put_share(cell, period->light);
                break;
            case 3:
                put_lux(cell, period->half_lx);
                break;
            default:
                put_lux(cell, period->most_lx);
            }
        }
    }
    table.key_count = 3;
    if (good)
        pp_table_print(&table, width, out);
    pp_table_clear(&table);
    return good;
}

static void print_light(const struct pp_availability_sheet *sheet, int width, FILE *out)
{
    char median[160];
    print_availability_fact("external light", sheet->light, width, out);
    print_availability_fact("days and clock", sheet->calendar, width, out);
    if (isfinite(sheet->median_lx))
        snprintf(median, sizeof median,
                 "%.0f lx, the median diffuse illuminance of the brightest 4380 hours "
                 "of the year",
                 sheet->median_lx);
    else
        snprintf(median, sizeof median,
                 "none, because the weather file covers less than a year");
    print_availability_fact("median", median, width, out);
    for (int i = 0; i < sheet->period_count; i++)
        if (sheet->periods[i].missing_h > 0.0) {
            snprintf(median, sizeof median,
                     "%.0f hours in the period %s have no data and are ignored",
                     sheet->periods[i].missing_h, sheet->periods[i].words);
            print_availability_fact("gaps", median, width, out);
        }
}

/* ---- the room ---- */

/* Row of a place in the table: points first, then the median, and the average in the
 * last row. */
static int table_row(const struct pp_availability_sheet *sheet, int place)
{
    int points = sheet->report->receiver_count;
    return place == PP_PLACE_AVERAGE  ? points + 1
           : place == PP_PLACE_MEDIAN ? points
                                      : place;
}

static bool has_median(const struct pp_availability_sheet *sheet)
{
    for (int i = 0; i < sheet->row_count; i++)
        if (sheet->rows[i].place == PP_PLACE_MEDIAN)
            return true;
    return false;
}

static void put_df(char cell[PP_CELL_BYTES], const struct pp_reading *df, bool utf8)
{
    if (!isfinite(df->value))
        snprintf(cell, PP_CELL_BYTES, "-");
    else if (isfinite(df->std_error))
        snprintf(cell, PP_CELL_BYTES, "%.2f %s%.2f", 100.0 * df->value,
                 utf8 ? "\xc2\xb1" : "+-", pp_reading_printed_error(df));
    else
        snprintf(cell, PP_CELL_BYTES, "%.2f", 100.0 * df->value);
}

/* Fills a column of one method and illuminance. what: -2 for the daylight factor, -1
 * for the illuminance outside that is required, else the index of the period whose
 * fraction of hours is written. */
static void fill_column(struct pp_table_column *column,
                        const struct pp_availability_sheet *sheet, const char *method,
                        double lx, int what, bool utf8)
{
    for (int i = 0; column && i < sheet->row_count; i++) {
        const struct pp_availability_row *row = &sheet->rows[i];
        if (strcmp(row->method, method) != 0 || row->lx != lx)
            continue;
        char *cell = column->cells[table_row(sheet, row->place)];
        if (what == -2)
            put_df(cell, &row->df, utf8);
        else if (what == -1)
            put_lux(cell, row->needs_lx);
        else
            put_share(cell, row->share[what]);
    }
}

static bool add_columns(struct pp_table *table,
                        const struct pp_availability_sheet *sheet, const char *method,
                        char groups[][64], bool utf8)
{
    static const char factors[] = "daylight factor";
    struct pp_table_column *column = pp_table_add(table, factors, "DF", method);
    fill_column(column, sheet, method, sheet->illuminances_lx[0], -2, utf8);
    bool good = column != NULL;
    for (int i = 0; i < sheet->illuminance_count && good; i++) {
        double lx = sheet->illuminances_lx[i];
        snprintf(groups[i], sizeof groups[i], "for %g lx", lx);
        char *brief = groups[PP_ILLUMINANCES_MOST + i];
        snprintf(brief, sizeof groups[i], "%g lx", lx);
        for (int what = -1; what < sheet->period_count && good; what++) {
            column = pp_table_add(table, groups[i], brief,
                                  what < 0 ? "needs lx" : sheet->periods[what].words);
            fill_column(column, sheet, method, lx, what, utf8);
            good = column != NULL;
        }
    }
    return good;
}

/* Prints the table of one method. */
static bool print_method(const struct pp_availability_sheet *sheet, const char *method,
                         int width, bool utf8, FILE *out)
{
    const struct pp_report *report = sheet->report;
    char groups[2 * PP_ILLUMINANCES_MOST][64];
    struct pp_table table;
    bool median = has_median(sheet);
    pp_table_init(&table, report->receiver_count + 2);
    table.last_label = "average";
    bool good = pp_print_places(&table, report, width, out);
    if (good && median)
        snprintf(table.columns[0].cells[report->receiver_count], PP_CELL_BYTES,
                 "median");
    good = good && add_columns(&table, sheet, method, groups, utf8);
    if (good && !median)
        for (int i = 0; i < table.column_count; i++)
            memcpy(table.columns[i].cells[report->receiver_count],
                   table.columns[i].cells[report->receiver_count + 1], PP_CELL_BYTES);
    if (!median)
        table.row_count--;
    if (good) {
        fputc('\n', out);
        pp_table_print(&table, width, out);
    }
    pp_table_clear(&table);
    return good;
}

/* Prints the reasons why methods lack values. A reason that is the same in consecutive
 * rows is printed once. */
static void print_reasons(const struct pp_availability_sheet *sheet, int width,
                          FILE *out)
{
    char text[1024];
    const char *said = NULL;
    for (int i = 0; i < sheet->row_count; i++) {
        const struct pp_availability_row *row = &sheet->rows[i];
        if (isfinite(row->df.value) || !row->df.why || row->df.why == said)
            continue;
        said = row->df.why;
        fputs("  - ", out);
        snprintf(text, sizeof text, "%s: %s", row->method, said);
        pp_print_wrapped(text, 4, 4, width, out);
    }
}

static enum pp_status print_available_room(const struct pp_availability_result *result,
                                           int width, bool utf8, FILE *out,
                                           struct pp_error *err)
{
    const struct pp_availability_sheet *sheet = &result->sheet;
    pp_print_title(result->report.world, result->file, out);
    fputc('\n', out);
    pp_print_assumed(result->report.world, &result->report.light, width, out);
    print_light(sheet, width, out);
    fputc('\n', out);
    bool good = print_periods(sheet, width, out);
    fputs("\n  ", out);
    pp_print_wrapped("For each target illuminance, the table shows the external "
                     "illuminance required (lx) and the share of working hours in "
                     "which it is reached (per cent).",
                     2, 2, width, out);
    for (int i = 0; i < result->report.column_count && good; i++) {
        const struct pp_column *column = &result->report.columns[i];
        if (column->component != PP_DF)
            continue;
        fputc('\n', out);
        good = print_method(sheet, column->name, width, utf8, out);
    }
    if (!good)
        return pp_fail_memory(err);
    fputc('\n', out);
    print_reasons(sheet, width, out);
    if (!result->report.finished)
        fputs("  traced: NOT FINISHED, interrupted\n", out);
    else if (result->by_clock)
        fputs("  traced: stopped at the --time limit, so another run may differ\n",
              out);
    return PP_OK;
}

enum pp_status pp_availability_text(const struct pp_availability_results *results,
                                    int width, bool utf8, FILE *out,
                                    struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < results->count && status == PP_OK; i++) {
        if (i > 0)
            fputs("\n\n", out);
        status = print_available_room(&results->list[i], width, utf8, out, err);
    }
    return status;
}
