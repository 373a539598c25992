/* study_report.h - one room's report: results of the methods and of the simulation.
 *
 * Methods and simulation do not depend on each other; this file combines them. */
#ifndef PP_STUDIES_STUDY_REPORT_H
#define PP_STUDIES_STUDY_REPORT_H

#include "model/results/report.h"
#include "studies/simulation.h"
#include "studies/study_options.h"
#include "studies/study_room.h"

/* Makes a report on the room with the columns of the selected methods. Nothing is
 * simulated. Room and options must exist as long as the report, which is freed by
 * pp_report_clear. */
enum pp_status pp_study_report_methods(struct pp_report *report,
                                       const struct pp_study_room *room,
                                       const struct pp_study_options *options,
                                       struct pp_error *err);

/* Like pp_study_report_methods, but appends the points of a grid over the working
 * plane, unless the room's own points are a grid (plane_figures.h). A report with
 * explanations has no additional points. */
enum pp_status pp_study_report_with_plane(struct pp_report *report,
                                          const struct pp_study_room *room,
                                          const struct pp_study_options *options,
                                          struct pp_error *err);

/* Computes the figures of the working plane, then removes the appended points. */
enum pp_status pp_study_report_settle(struct pp_report *report,
                                      const struct pp_study_room *room,
                                      struct pp_error *err);

/* Add the columns "traced" of all components, simulated by the path engine. If a watch
 * stops the simulation, the results so far are kept, and report->finished is false.
 * *by_clock: the time limit ended the simulation. The second function simulates only
 * direct light, with an error relative to the sum of sky and externally reflected
 * component. */
enum pp_status pp_study_report_traced(struct pp_report *report,
                                      const struct pp_study_options *options,
                                      bool *by_clock, struct pp_error *err);
enum pp_status pp_study_report_traced_direct(struct pp_report *report,
                                             const struct pp_study_options *options,
                                             bool *by_clock, struct pp_error *err);

/* Simulates by any engine, with error, samples, time limit, seed and threads of the
 * study options. kept (may be NULL): data with which a later run can begin, freed by
 * the caller. There are no data after a stop. */
struct pp_kept_bytes {
    char *bytes;
    size_t length;
};
enum pp_status pp_study_report_simulate(struct pp_report *report,
                                        const struct pp_engine *engine,
                                        struct pp_engine_options engine_options,
                                        const struct pp_study_options *options,
                                        bool *by_clock, struct pp_kept_bytes *kept,
                                        struct pp_error *err);

#endif
