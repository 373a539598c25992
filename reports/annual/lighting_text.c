/* lighting_text.c - see lighting_text.h. */
#include "reports/annual/lighting_text.h"

#include <math.h>

#include "reports/annual/lighting_report.h"

/* A column of the table. number: function that returns the value for control k; NAN is
 * printed as a dash. */
struct lighting_column {
    const char *group, *group_short, *heading, *format;
    double (*number)(const struct pp_annual_sheet *sheet, int k);
};

static double control_number(const struct pp_annual_sheet *sheet, int k)
{
    (void)sheet;
    return k + 1;
}

static double saved_percent(const struct pp_annual_sheet *sheet, int k)
{
    return 100.0 * sheet->lighting[k].figures.saved.value;
}

static double saved_error(const struct pp_annual_sheet *sheet, int k)
{
    return 100.0 * sheet->lighting[k].figures.saved.std_error;
}

static double saved_mean(const struct pp_annual_sheet *sheet, int k)
{
    bool of_one = sheet->lighting[k].control.point > 0;
    return of_one ? NAN : 100.0 * sheet->lighting[k].mean.value;
}

static double standard_percent(const struct pp_annual_sheet *sheet, int k)
{
    return 100.0 * sheet->lighting[k].standard.saved;
}

static double lamps_on_h(const struct pp_annual_sheet *sheet, int k)
{
    return sheet->lighting[k].figures.on_h.value;
}

static double full_power_h(const struct pp_annual_sheet *sheet, int k)
{
    return sheet->lighting[k].figures.used_h.value;
}

static double used_kwh(const struct pp_annual_sheet *sheet, int k)
{
    return pp_lighting_report_kwh(sheet, k)
           * (1.0 - sheet->lighting[k].figures.saved.value);
}

static double saved_kwh(const struct pp_annual_sheet *sheet, int k)
{
    return pp_lighting_report_kwh(sheet, k) * sheet->lighting[k].figures.saved.value;
}

static double hourly_percent(const struct pp_annual_sheet *sheet, int k)
{
    return 100.0 * sheet->lighting[k].figures.saved_by_means.value;
}

static double hourly_difference(const struct pp_annual_sheet *sheet, int k)
{
    return 100.0 * sheet->lighting[k].figures.misjudged.value;
}

static double hourly_error(const struct pp_annual_sheet *sheet, int k)
{
    return 100.0 * sheet->lighting[k].figures.misjudged.std_error;
}

static const char electric[] = "electric light saved", used[] = "used",
                  energy[] = "energy, kWh", means[] = "saved by hourly means";

static const struct lighting_column columns[] = {
    {NULL, NULL, "control", "%.0f", control_number},
    {electric, "saved", "%", "%.1f", saved_percent},
    {electric, "saved", "standard error", "%.1f", saved_error},
    {electric, "saved", "% mean of points", "%.1f", saved_mean},
    {electric, "saved", "% EN 15193", "%.1f", standard_percent},
    {used, "used", "hours lamps on", "%.0f", lamps_on_h},
    {used, "used", "hours of full power", "%.0f", full_power_h},
    {energy, "kWh", "used", "%.1f", used_kwh},
    {energy, "kWh", "saved", "%.1f", saved_kwh},
    {means, "hourly means", "%", "%.1f", hourly_percent},
    {means, "hourly means", "differ- ence", "%+.2f", hourly_difference},
    {means, "hourly means", "standard error", "%.2f", hourly_error},
};

/* True if the sheet has data for the column. */
static bool has_lighting_column(const struct pp_annual_sheet *sheet,
                                const struct lighting_column *column)
{
    if (column->group == means)
        return pp_lighting_report_short_records(sheet);
    if (column->number == saved_mean)
        return sheet->receiver_count > 1;
    for (int k = 0; k < sheet->lighting_count; k++)
        if (isfinite(column->number(sheet, k)))
            return true;
    return false;
}

static bool add_lighting_column(struct pp_table *table,
                                const struct pp_annual_sheet *sheet,
                                const struct lighting_column *from)
{
    struct pp_table_column *to =
        pp_table_add(table, from->group, from->group_short, from->heading);
    for (int k = 0; to && k < sheet->lighting_count; k++) {
        double number = from->number(sheet, k);
        if (isfinite(number))
            snprintf(to->cells[k], PP_CELL_BYTES, from->format, number);
        else
            snprintf(to->cells[k], PP_CELL_BYTES, "-");
    }
    return to != NULL;
}

bool pp_lighting_text_table(const struct pp_annual_sheet *sheet, int width, FILE *out)
{
    struct pp_table table;
    bool good = true;
    if (sheet->lighting_count == 0)
        return true;
    pp_table_init(&table, sheet->lighting_count);
    table.key_count = 1;
    for (size_t i = 0; i < sizeof columns / sizeof *columns && good; i++)
        if (has_lighting_column(sheet, &columns[i]))
            good = add_lighting_column(&table, sheet, &columns[i]);
    if (good)
        pp_table_print(&table, width, out);
    pp_table_clear(&table);
    return good;
}

bool pp_lighting_text_points(struct pp_table *table,
                             const struct pp_annual_sheet *sheet)
{
    for (int k = 0; k < sheet->lighting_count; k++) {
        const struct pp_lighting_sheet *of = &sheet->lighting[k];
        char heading[32];
        snprintf(heading, sizeof heading, "control %d", k + 1);
        struct pp_table_column *column =
            pp_table_add(table, "light saved %", "saved", heading);
        if (!column)
            return false;
        for (int x = 0; x <= sheet->receiver_count; x++) {
            const struct pp_annual_value *saved =
                x < sheet->receiver_count ? &of->points[x] : &of->mean;
            snprintf(column->cells[x], PP_CELL_BYTES, "%.1f", 100.0 * saved->value);
        }
    }
    return true;
}
