/* annual_hourly.h - the illuminances of every hour and point, as in the
 * sheet: with open blinds, unless they are always closed or have a schedule.
 *
 *     .csv   one line per hour: month, day, hour, sun, light outside, points
 *     .ill   DAYSIM: month day hour (at its middle) and the points, separated by spaces
 *     .npy   NumPy: float32, [point][hour]
 */
#ifndef PP_REPORTS_ANNUAL_ANNUAL_HOURLY_H
#define PP_REPORTS_ANNUAL_ANNUAL_HOURLY_H

#include <stdio.h>

#include "model/base/error.h"
#include "model/results/sheets/annual_sheet.h"

enum pp_annual_hourly_format {
    PP_ANNUAL_HOURLY_NONE, /* the name has another ending */
    PP_ANNUAL_HOURLY_CSV,
    PP_ANNUAL_HOURLY_ILL,
    PP_ANNUAL_HOURLY_NPY,
};

/* Format that the ending of the file's name selects. */
enum pp_annual_hourly_format pp_annual_hourly_of_name(const char *name);

/* Writes the coefficients as a Radiance matrix: one row per point; a column for the
 * ground, then one per patch in the order of reinhart.cal; lx over cd/m2. */
void pp_annual_hourly_put_matrix(const struct pp_annual_sheet *sheet, FILE *out);

void pp_annual_hourly_put(const struct pp_annual_sheet *sheet,
                          enum pp_annual_hourly_format format, FILE *out);

#endif
