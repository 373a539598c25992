/* finding_cells.h - the figure and bound of a finding as table cells. Both have enough
 * decimals for the printed values to compare like the exact values. */
#ifndef PP_REPORTS_ASSESS_FINDING_CELLS_H
#define PP_REPORTS_ASSESS_FINDING_CELLS_H

#include <stdbool.h>

#include "studies/criteria/finding.h"

enum { PP_FINDING_CELL = 40 }; /* bytes */

/* Writes "3.16 +-0.02 %" or "3.16 (2.80-3.50) %". The error is rounded up to the digits
 * shown. Empty if there is no figure. */
void pp_finding_cells_figure(char cell[PP_FINDING_CELL],
                             const struct pp_finding *finding, bool utf8);

/* Writes the bound, such as ">= 0.3"; empty if there is no bound or no figure. */
void pp_finding_cells_wanted(char cell[PP_FINDING_CELL],
                             const struct pp_finding *finding, bool utf8);

#endif
