/* df_plane.h - daylight factors arranged like the plan, and statistics over the plane,
 * for the text of df. */
#ifndef PP_REPORTS_DF_PLANE_H
#define PP_REPORTS_DF_PLANE_H

#include <stdbool.h>
#include <stdio.h>

#include "model/results/lattice.h"
#include "model/results/report.h"

/* Prints the daylight factors of each column at the points of the lattice, with the
 * highest y on top: a row for each y, a column for each x. If a line is too short,
 * columns continue in further panels. Bands follow if they are known. */
void pp_df_plane_tables(const struct pp_report *report,
                        const struct pp_lattice *lattice, int width, FILE *out);

/* Prints a line for each column with figures of the plane: minimum, median, average,
 * uniformity, and the fraction of the plane that reaches each level. Prints nothing if
 * there are no such figures. */
void pp_df_plane_summary(const struct pp_report *report, int width, bool utf8,
                         FILE *out);

#endif
