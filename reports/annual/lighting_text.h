/* lighting_text.h - a table of the electric light with each control, as text. */
#ifndef PP_REPORTS_ANNUAL_LIGHTING_TEXT_H
#define PP_REPORTS_ANNUAL_LIGHTING_TEXT_H

#include <stdbool.h>
#include <stdio.h>

#include "model/results/sheets/annual_sheet.h"
#include "reports/parts/table.h"

/* Prints the table in lines of at most `width` columns. Prints nothing if there are no
 * controls. Returns false if memory is exhausted. */
bool pp_lighting_text_table(const struct pp_annual_sheet *sheet, int width, FILE *out);

/* Adds columns to a table of points. Each row is the light saved if that point is the
 * control point; the last row is the mean. Returns false if memory is exhausted. */
bool pp_lighting_text_points(struct pp_table *table,
                             const struct pp_annual_sheet *sheet);

#endif
