/* plot_envelope_report.h - the largest envelope on a plot
 * (studies/sizing/plot_envelope.h), as text with a plan of its heights, as CSV with one
 * line per cell, and as JSON. */
#ifndef PP_REPORTS_PLOT_ENVELOPE_REPORT_H
#define PP_REPORTS_PLOT_ENVELOPE_REPORT_H

#include <stdio.h>

#include "studies/sizing/plot_envelope.h"

/* Writes text in lines of `width` columns (60 or more). The plan has at most 12 heights
 * per line. */
enum pp_status pp_plot_envelope_report(const struct pp_plot_envelope *found,
                                       const struct pp_plot_envelope_task *task,
                                       int width, FILE *out, struct pp_error *err);

/* Writes one line for each cell, with its height. The columns are the attributes of a
 * block in a room file. */
enum pp_status pp_plot_envelope_report_csv(const struct pp_plot_envelope *found,
                                           const struct pp_plot_envelope_task *task,
                                           FILE *out, struct pp_error *err);
enum pp_status pp_plot_envelope_report_json(const struct pp_plot_envelope *found,
                                            const struct pp_plot_envelope_task *task,
                                            FILE *out, struct pp_error *err);

#endif
