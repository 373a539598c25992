/* lighting_report.h - electric light saved by daylight: settings, JSON, CSV, and the
 * schedule of a year. Fractions are printed in per cent. */
#ifndef PP_REPORTS_ANNUAL_LIGHTING_REPORT_H
#define PP_REPORTS_ANNUAL_LIGHTING_REPORT_H

#include <json.h>
#include <stdbool.h>
#include <stdio.h>

#include "model/results/sheets/annual_sheet.h"

/* Energy (kWh) used by the lamps at full power in all occupied hours; NAN if the power
 * is not given. */
double pp_lighting_report_kwh(const struct pp_annual_sheet *sheet, int k);

/* True if the records are shorter than an hour. Hourly means then differ from the
 * values of the records. */
bool pp_lighting_report_short_records(const struct pp_annual_sheet *sheet);

/* Describes the settings and power of control k. Returns `text`. */
const char *pp_lighting_report_words(char *text, size_t room,
                                     const struct pp_annual_sheet *sheet, int k);

/* Describes the zone, class and factors of EN 15193 for all controls, or gives the
 * reason why there are none. Returns `text`. */
const char *pp_lighting_report_standard(char *text, size_t room,
                                        const struct pp_annual_sheet *sheet);

/* Adds "lighting", an array with one object for each control. Returns false if memory
 * is exhausted. */
bool pp_lighting_report_json(struct json_object *object,
                             const struct pp_annual_sheet *sheet);

/* Adds the share of electric light saved by each control (per cent) to the object of a
 * point; point -1: the average. */
bool pp_lighting_report_json_point(struct json_object *object,
                                   const struct pp_annual_sheet *sheet, int point);

/* Write the columns of all controls, each preceded by a comma. The first function
 * writes the names. The second writes the values of a point (-1: the average). The
 * third writes the values of control k at its own control point. */
void pp_lighting_report_csv_names(const struct pp_annual_sheet *sheet, FILE *out);
void pp_lighting_report_csv_point(const struct pp_annual_sheet *sheet, int point,
                                  FILE *out);
void pp_lighting_report_csv_control(const struct pp_annual_sheet *sheet, int k,
                                    FILE *out);

/* Writes the fraction of the installed power in every hour of the year: a line of
 * headings, then one line per hour, with a column for each control. */
void pp_lighting_report_schedule(const struct pp_annual_sheet *sheet, FILE *out);

#endif
