/* availability_result.h - availability of daylight in rooms, and data of the run, which
 * the availability reports print. */
#ifndef PP_REPORTS_AVAILABILITY_RESULT_H
#define PP_REPORTS_AVAILABILITY_RESULT_H

#include <stdbool.h>

#include "model/results/sheets/availability_sheet.h"
#include "model/results/report.h"
#include "studies/study_options.h"

/* Results for one room. */
struct pp_availability_result {
    struct pp_report report;
    struct pp_availability_sheet sheet;
    const char *file; /* as typed; not owned */
    bool by_clock;    /* --time ended the simulation */
};

struct pp_availability_results {
    struct pp_availability_result *list;
    int count;
    bool several; /* print a list, even for a single room */
    bool more_than_one_file;
    const struct pp_study_options *options; /* not owned */
};

#endif
