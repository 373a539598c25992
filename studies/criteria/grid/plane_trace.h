/* plane_trace.h - simulates the daylight factors of a grid until the figures of the
 * plane have the target error: the median, the level that 95 % of the plane reach and,
 * if a criterion needs it, the average. Single points have a larger error, which saves
 * most of the time. */
#ifndef PP_STUDIES_CRITERIA_GRID_PLANE_TRACE_H
#define PP_STUDIES_CRITERIA_GRID_PLANE_TRACE_H

#include "model/results/report.h"
#include "studies/study_options.h"

/* Adds the columns "traced" to the report, whose receivers are the grid's points. With
 * a number of samples or a time instead of a target error, simulates once. *by_clock:
 * as in pp_study_report_traced. */
enum pp_status pp_plane_trace(struct pp_report *report,
                              const struct pp_study_options *options, bool of_average,
                              bool *by_clock, struct pp_error *err);

#endif
