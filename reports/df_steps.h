/* df_steps.h - calculations set out as on paper, as text. */
#ifndef PP_REPORTS_DF_STEPS_H
#define PP_REPORTS_DF_STEPS_H

#include <stdbool.h>
#include <stdio.h>

#include "model/results/report.h"

/* Prints the steps of the figures of the report's first point, method by method, one step
 * a line; nothing if no steps were requested. */
void pp_df_steps(const struct pp_report *report, int width, bool utf8, FILE *out);

#endif
