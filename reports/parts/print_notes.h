/* print_notes.h - notes below the table of a report, mainly the reasons for missing
 * values. */
#ifndef PP_REPORTS_PARTS_PRINT_NOTES_H
#define PP_REPORTS_PARTS_PRINT_NOTES_H

#include <stdbool.h>
#include <stdio.h>

#include "model/results/report.h"

/* Reading in row `row` of a table: at a point or, in the last row, for the average.
 * NULL if the column has no values at points. */
const struct pp_reading *pp_print_notes_reading(const struct pp_report *report,
                                                const struct pp_column *column,
                                                int row);

/* True if all values of a component are 0, like externally reflected light if there are
 * no surroundings. A note then replaces the columns of the component. */
bool pp_print_notes_is_zero(const struct pp_report *report,
                            enum pp_component component);

/* Prints one note for each reason, with the columns that lack values for this reason.
 * Also prints notes on the report as a whole, on a component that is 0 everywhere, and
 * on an allowance for decorations that is not applied. Returns false if memory is
 * exhausted. */
bool pp_print_notes(const struct pp_report *report, int width, FILE *out);

#endif
