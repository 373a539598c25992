/* lighting_text.h - a table of the electric light under each control, as text. */
#ifndef PP_REPORTS_ANNUAL_LIGHTING_TEXT_H
#define PP_REPORTS_ANNUAL_LIGHTING_TEXT_H

#include <stdbool.h>
#include <stdio.h>

#include "model/results/sheets/annual_sheet.h"
#include "reports/parts/table.h"

/* Prints the table in lines of at most `width` columns, or nothing if there is no
 * control. False: out of memory. */
bool pp_lighting_text_table(const struct pp_annual_sheet *sheet, int width, FILE *out);

/* Adds to a table of points the columns of the light saved with each of them as control
 * point, and in the last row the mean. False: out of memory. */
bool pp_lighting_text_points(struct pp_table *table,
                             const struct pp_annual_sheet *sheet);

#endif
