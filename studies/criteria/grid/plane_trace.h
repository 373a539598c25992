/* plane_trace.h - simulates the daylight factors of a grid until the figures of the plane
 * are known to the target error: its median, the level that 95 % of it reach, and, if
 * that is judged, its average. A point by itself has a larger error, which saves most of the time.
 */
#ifndef PP_STUDIES_CRITERIA_GRID_PLANE_TRACE_H
#define PP_STUDIES_CRITERIA_GRID_PLANE_TRACE_H

#include "model/results/report.h"
#include "studies/study_options.h"

/* Adds the columns "traced" to the report, whose receivers are the grid's points. With
 * options of samples or time in place of an error it simulates once, by these. *by_clock
 * as of pp_study_report_traced. */
enum pp_status pp_plane_trace(struct pp_report *report,
                              const struct pp_study_options *options, bool of_average,
                              bool *by_clock, struct pp_error *err);

#endif
