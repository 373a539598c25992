/* print_band.c - prints a band as two numbers with a dash between them, and as a JSON
 * list of two numbers. */
#include "reports/parts/print_band.h"

#include <stdio.h>
#include <stdlib.h>

#include "model/base/text.h"
#include "reports/parts/print.h"

/* Bands whose upper end is below this are not printed. The limit is half a unit of the
 * last decimal of a printed daylight factor. Such values are practically zero, and
 * their bands would mislead: 0.0021 % had a band of 0.00207 to 0.00208 %. */
static const double LEAST_END = 5e-5;

static bool is_shown(struct pp_band_ends band)
{
    return pp_band_is_known(band) && band.high >= LEAST_END;
}

/* Number of decimals for both ends of a band in per cent, such that its upper end has
 * one to three digits; bands are not more accurate. */
static int decimals_of(double high)
{
    return high < 1e-4 ? 4 : high < 0.09995 ? 2 : 1;
}

void pp_print_band(char *text, size_t size, struct pp_band_ends band)
{
    text[0] = '\0';
    if (!is_shown(band))
        return;
    int decimals = decimals_of(band.high);
    snprintf(text, size, "%.*f-%.*f", decimals, 100.0 * band.low, decimals,
             100.0 * band.high);
}

struct pp_band_ends pp_print_band_at(const struct pp_column *column, int index,
                                     int count)
{
    struct pp_band_ends band = index == count  ? column->average_band
                               : column->bands ? column->bands[index]
                                               : pp_band_none();
    return is_shown(band) ? band : pp_band_none();
}

/* Rounds to four significant digits, which exceeds the accuracy of bands. */
static double four_digits(double value)
{
    char text[32];
    snprintf(text, sizeof text, "%.4g", value);
    return atof(text);
}

bool pp_print_band_json(struct json_object *object, struct pp_band_ends band)
{
    if (!is_shown(band))
        return true;
    const double ends[] = {four_digits(100.0 * band.low),
                           four_digits(100.0 * band.high)};
    return pp_json_numbers(object, "band", ends, 2);
}

static bool has_band(const struct pp_report *report)
{
    for (int i = 0; i < report->column_count; i++)
        for (int k = 0; k <= report->receiver_count; k++)
            if (pp_band_is_known(
                    pp_print_band_at(&report->columns[i], k, report->receiver_count)))
                return true;
    return false;
}

static void append_averages(char *text, size_t size, const struct pp_report *report)
{
    const char *before = "; for averages ";
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        char band[48];
        if (column->component != PP_DF || !pp_band_is_known(column->average_band))
            continue;
        pp_print_band(band, sizeof band, column->average_band);
        pp_text_append(text, size, "%s%s %s", before, column->name, band);
        before = ", ";
    }
}

void pp_print_band_note(const struct pp_report *report, int width, FILE *out)
{
    char text[1600] = "";
    if (report->no_bands)
        pp_text_append(text, sizeof text, "%s", report->no_bands);
    else if (has_band(report))
        pp_text_append(text, sizeof text,
                       "95 %% band: in 95 of 100 similar simulated rooms (the atlas) "
                       "the true daylight factor was in this range");
    if (!text[0])
        return;
    append_averages(text, sizeof text, report);
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
}
