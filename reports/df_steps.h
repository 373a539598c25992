/* df_steps.h - prints calculations in the layout of a hand calculation. */
#ifndef PP_REPORTS_DF_STEPS_H
#define PP_REPORTS_DF_STEPS_H

#include <stdbool.h>
#include <stdio.h>

#include "model/results/report.h"

/* Prints the steps of the calculation for the report's first point, method by method;
 * for a method without values at points, those for the average. Prints nothing if no
 * steps were requested. */
void pp_df_steps(const struct pp_report *report, int width, bool utf8, FILE *out);

/* Prints a list of steps. Steps of an opening follow the opening's name. */
void pp_df_steps_list(const struct pp_steps *steps, const struct pp_world *world,
                      int width, bool utf8, FILE *out);

#endif
