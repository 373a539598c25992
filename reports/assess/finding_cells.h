/* finding_cells.h - a finding's figure and bound as cells of a table, with enough
 * decimals for the printed values to compare as the exact ones do. */
#ifndef PP_REPORTS_ASSESS_FINDING_CELLS_H
#define PP_REPORTS_ASSESS_FINDING_CELLS_H

#include <stdbool.h>

#include "studies/criteria/finding.h"

enum { PP_FINDING_CELL = 40 }; /* bytes */

/* Writes "3.16 +-0.02 %" or "3.16 (2.80-3.50) %", the error rounded up to the digits
 * shown; empty without a figure. */
void pp_finding_cells_figure(char cell[PP_FINDING_CELL],
                             const struct pp_finding *finding, bool utf8);

/* Writes ">= 0.3"; empty if there is no bound or no figure. */
void pp_finding_cells_wanted(char cell[PP_FINDING_CELL],
                             const struct pp_finding *finding, bool utf8);

#endif
