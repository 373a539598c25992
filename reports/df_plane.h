/* df_plane.h - daylight factors laid out as in the plan, and their statistics over the
 * plane, for the text of df. */
#ifndef PP_REPORTS_DF_PLANE_H
#define PP_REPORTS_DF_PLANE_H

#include <stdbool.h>
#include <stdio.h>

#include "model/results/lattice.h"
#include "model/results/report.h"

/* The daylight factors of each column that has some at the points of the lattice, north
 * (high y) above: a row for each y, a column for each x; in panels where the line is too
 * short; and behind them, where they are known, their bands. */
void pp_df_plane_tables(const struct pp_report *report,
                        const struct pp_lattice *lattice, int width, FILE *out);

/* A line for each column that has figures of the plane: minimum, median, average,
 * uniformity, and the share over each level. Nothing where none has. */
void pp_df_plane_summary(const struct pp_report *report, int width, bool utf8,
                         FILE *out);

#endif
