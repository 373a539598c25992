/* annual_hourly.h - the illuminances of every hour and point, as in the sheet:
 * with open blinds, unless they are always closed or have a schedule.
 *
 *     .csv   one line per record: date, hour, sun, light outside, occupied part, points
 *     .ill   DAYSIM: month day hour (at its middle) and the points, separated by spaces
 *     .npy   NumPy: float32, [point][hour]
 *     json   part of the JSON output, instead of a file
 */
#ifndef PP_REPORTS_ANNUAL_ANNUAL_HOURLY_H
#define PP_REPORTS_ANNUAL_ANNUAL_HOURLY_H

#include <json.h>
#include <stdio.h>

#include "model/base/error.h"
#include "model/results/sheets/annual_sheet.h"

enum pp_annual_hourly_format {
    PP_ANNUAL_HOURLY_NONE, /* any other file name extension */
    PP_ANNUAL_HOURLY_CSV,
    PP_ANNUAL_HOURLY_ILL,
    PP_ANNUAL_HOURLY_NPY,
    PP_ANNUAL_HOURLY_JSON,
};

/* Greatest number of points for which the JSON output has the hours of each point. */
enum { PP_ANNUAL_HOURLY_JSON_POINTS = 40 };

/* Format for the extension of the file name, or for "json". */
enum pp_annual_hourly_format pp_annual_hourly_of_name(const char *name);

/* Writes the daylight coefficients (lx per cd/m2) as a Radiance matrix. There is one
 * row per point. The first column is for the ground; the others are for the sky patches
 * in the order of reinhart.cal. */
void pp_annual_hourly_put_matrix(const struct pp_annual_sheet *sheet, FILE *out);

/* Adds "hourly" to the object of a room: date, middle and occupied part of each record,
 * and the illuminances (lx, null: not known) of the mean and of each point. Returns
 * false if out of memory. */
bool pp_annual_hourly_add_json(struct json_object *object,
                               const struct pp_annual_sheet *sheet);

void pp_annual_hourly_put(const struct pp_annual_sheet *sheet,
                          enum pp_annual_hourly_format format, FILE *out);

#endif
