/* df_steps.h - calculations in the layout of a hand calculation, as text. */
#ifndef PP_REPORTS_DF_STEPS_H
#define PP_REPORTS_DF_STEPS_H

#include <stdbool.h>
#include <stdio.h>

#include "model/results/report.h"

/* Prints the steps of the figures at the report's first point, method by method;
 * nothing if no steps were requested. */
void pp_df_steps(const struct pp_report *report, int width, bool utf8, FILE *out);

/* Prints a list of steps; those of an opening follow its name. */
void pp_df_steps_list(const struct pp_steps *steps, const struct pp_world *world,
                      int width, bool utf8, FILE *out);

#endif
