/* schedule_document.h - the schedule of windows as a document, for HTML and paper. */
#ifndef PP_REPORTS_PAGE_SCHEDULE_DOCUMENT_H
#define PP_REPORTS_PAGE_SCHEDULE_DOCUMENT_H

#include "model/results/document.h"
#include "model/room/project.h"
#include "studies/criteria/windows/window_schedule.h"

/* Makes a document with one line for each window, in the order of the schedule, under
 * headings for house and floor. Quantities without any value are omitted. A table has
 * at most `most_figures` columns of values (4 or more); the other quantities are in
 * further tables. title: title of the building or the room. PP_SYSTEM: out of memory.
 * The caller clears the document even after a failure. */
enum pp_status pp_schedule_document(struct pp_document *document,
                                    const struct pp_window_schedule *schedule,
                                    const char *title, const struct pp_project *project,
                                    int most_figures, struct pp_error *err);

#endif
