/* hand_year_report.h - results of the hand methods in annual reports, as text, JSON and
 * CSV. The functions write nothing for a sheet without hand methods. */
#ifndef PP_REPORTS_ANNUAL_HAND_YEAR_REPORT_H
#define PP_REPORTS_ANNUAL_HAND_YEAR_REPORT_H

#include <json.h>
#include <stdbool.h>
#include <stdio.h>

#include "model/results/sheets/hand_year_sheet.h"

/* Prints the methods with their assumptions, a table of their figures beside the
 * simulated figures, and the explanations. Returns false if memory is exhausted. */
bool pp_hand_year_report_text(const struct pp_hand_year_sheet *hand,
                              const struct pp_annual_sheet *sheet, int width, bool utf8,
                              FILE *out);

/* Adds "methods" to a JSON object. The first function adds descriptions and
 * explanations to the object of a room. The second adds figures to the object of a
 * point (index; -1: the mean). Both return false if memory is exhausted. */
bool pp_hand_year_report_json(struct json_object *object,
                              const struct pp_hand_year_sheet *hand,
                              const struct pp_annual_sheet *sheet);
bool pp_hand_year_report_json_point(struct json_object *object,
                                    const struct pp_hand_year_sheet *hand,
                                    const struct pp_annual_sheet *sheet, int point);

/* Number of additional CSV columns. */
int pp_hand_year_report_csv_columns(const struct pp_hand_year_sheet *hand,
                                    const struct pp_annual_sheet *sheet);

/* Write the names of these columns, and the fields of a point (-1: the mean). Each is
 * preceded by a comma. */
void pp_hand_year_report_csv_heading(const struct pp_hand_year_sheet *hand,
                                     const struct pp_annual_sheet *sheet, FILE *out);
void pp_hand_year_report_csv(const struct pp_hand_year_sheet *hand,
                             const struct pp_annual_sheet *sheet, int point, FILE *out);

#endif
