/* print_band.c - two ends with a dash between, and a list of two. */
#include "reports/parts/print_band.h"

#include <stdio.h>
#include <stdlib.h>

#include "reports/parts/print.h"

/* Bands are known to two or three digits: decimals that show both ends so. */
static int decimals_of(double high)
{
    return high < 1e-4 ? 4 : high < 0.09995 ? 2 : 1;
}

void pp_print_band(char *text, size_t size, struct pp_band_ends band, bool utf8)
{
    text[0] = '\0';
    if (!pp_band_is_known(band))
        return;
    int decimals = decimals_of(band.high);
    snprintf(text, size, "%.*f%s%.*f", decimals, 100.0 * band.low,
             utf8 ? "\xe2\x80\x93" : "-", decimals, 100.0 * band.high);
}

struct pp_band_ends pp_print_band_at(const struct pp_column *column, int index,
                                     int count)
{
    return index == count  ? column->average_band
           : column->bands ? column->bands[index]
                           : pp_band_none();
}

/* More than they are known to. */
static double four_digits(double value)
{
    char text[32];
    snprintf(text, sizeof text, "%.4g", value);
    return atof(text);
}

bool pp_print_band_json(struct json_object *object, struct pp_band_ends band)
{
    if (!pp_band_is_known(band))
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

void pp_print_band_note(const struct pp_report *report, int width, FILE *out)
{
    const char *text = report->no_bands;
    if (!text && has_band(report))
        text = "95 % band: where the true daylight factor was in 95 of 100 rooms like "
               "this one, of those that the program has traced (the atlas)";
    if (!text)
        return;
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
}
