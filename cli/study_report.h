/* study_report.h - one room's report: what the methods say, and what the simulation says.
 *
 * The only place that holds both; neither knows of the other.
 */
#ifndef PP_CLI_STUDY_REPORT_H
#define PP_CLI_STUDY_REPORT_H

#include "cli/rooms.h"
#include "model/results/report.h"

/* A report on the room with the columns of the methods asked for; nothing is traced.
 * The report is good as long as the room; pp_report_clear frees it. */
enum pp_status pp_study_report_methods(struct pp_report *report,
                                       const struct pp_loaded_room *room,
                                       const struct pp_room_options *options,
                                       struct pp_error *err);

/* Adds the columns "traced" of all components; a progress bar shows meanwhile. An
 * interrupt leaves what there is so far, and finished is false. *by_clock: the time was
 * over before the simulation was done. */
enum pp_status pp_study_report_traced(struct pp_report *report,
                                      const struct pp_room_options *options,
                                      bool *by_clock, struct pp_error *err);

#endif
