/* figure_unit.h - units in which findings are printed. */
#ifndef PP_REPORTS_PARTS_FIGURE_UNIT_H
#define PP_REPORTS_PARTS_FIGURE_UNIT_H

#include "studies/criteria/finding.h"

/* Factor for printing a figure: daylight factors and other fractions in per cent,
 * angles in degrees. */
double pp_figure_scale(enum pp_figure kind);

/* Unit in which a figure is printed: "%", "degrees", "m2"; "" for a dimensionless
 * number. Static string. */
const char *pp_figure_unit(enum pp_figure kind);

#endif
