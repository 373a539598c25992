/* print_notes.h - notes below the table of a report: why values are missing. */
#ifndef PP_REPORTS_PARTS_PRINT_NOTES_H
#define PP_REPORTS_PARTS_PRINT_NOTES_H

#include <stdbool.h>
#include <stdio.h>

#include "model/results/report.h"

/* The reading of row `row` of a table: a point's, or the average's in the last one.
 * NULL where the column has nothing to say of points. */
const struct pp_reading *pp_print_notes_reading(const struct pp_report *report,
                                                const struct pp_column *column,
                                                int row);

/* Is all of a component 0, as externally reflected light is where nothing stands
 * outside? Then a note does for its columns. */
bool pp_print_notes_is_zero(const struct pp_report *report,
                            enum pp_component component);

/* Prints one note for each reason, with the columns that give it. False: out of
 * memory. */
bool pp_print_notes(const struct pp_report *report, int width, FILE *out);

#endif
