/* hand_year_report.h - the hand methods' part of annual results, as text, JSON and CSV.
 * Nothing is written for a sheet without methods. */
#ifndef PP_REPORTS_ANNUAL_HAND_YEAR_REPORT_H
#define PP_REPORTS_ANNUAL_HAND_YEAR_REPORT_H

#include <json.h>
#include <stdbool.h>
#include <stdio.h>

#include "model/results/sheets/hand_year_sheet.h"

/* Prints the methods with their assumptions, a table of their figures beside the
 * simulated ones, and the explanations. False: out of memory. */
bool pp_hand_year_report_text(const struct pp_hand_year_sheet *hand,
                              const struct pp_annual_sheet *sheet, int width, bool utf8,
                              FILE *out);

/* Adds "methods" to the object of a room: descriptions, explanations; to the object of a
 * point (its index; -1: the mean): figures. False: out of memory. */
bool pp_hand_year_report_json(struct json_object *object,
                              const struct pp_hand_year_sheet *hand,
                              const struct pp_annual_sheet *sheet);
bool pp_hand_year_report_json_point(struct json_object *object,
                                    const struct pp_hand_year_sheet *hand,
                                    const struct pp_annual_sheet *sheet, int point);

/* Number of further columns in CSV. */
int pp_hand_year_report_csv_columns(const struct pp_hand_year_sheet *hand,
                                    const struct pp_annual_sheet *sheet);

/* Writes the names of these columns, and the fields of a point (-1: the mean), each
 * after a comma. */
void pp_hand_year_report_csv_heading(const struct pp_hand_year_sheet *hand,
                                     const struct pp_annual_sheet *sheet, FILE *out);
void pp_hand_year_report_csv(const struct pp_hand_year_sheet *hand,
                             const struct pp_annual_sheet *sheet, int point, FILE *out);

#endif
