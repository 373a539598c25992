/* print_places.h - prints the positions of a report's points in its table. */
#ifndef PP_REPORTS_PARTS_PRINT_PLACES_H
#define PP_REPORTS_PARTS_PRINT_PLACES_H

#include <stdbool.h>
#include <stdio.h>

#include "reports/parts/table.h"
#include "model/results/report.h"

/* Adds the key columns: the coordinates that differ between points and, for points on a
 * line, the distance from the wall with all windows. Prints the constant coordinates in
 * a sentence above the table. Returns false if memory is exhausted. */
bool pp_print_places(struct pp_table *table, const struct pp_report *report, int width,
                     FILE *out);

#endif
