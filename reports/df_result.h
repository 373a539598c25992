/* df_result.h - reports of rooms, and data of the run, which the reports of df and
 * validate print. */
#ifndef PP_REPORTS_DF_RESULT_H
#define PP_REPORTS_DF_RESULT_H

#include <stdbool.h>

#include "model/results/report.h"
#include "studies/bands/advice.h"
#include "studies/study_options.h"

/* Results for one room. */
struct pp_result {
    struct pp_report report;
    const char *file;                 /* as typed; not owned */
    const struct pp_mistakes *doubts; /* warnings about the input; NULL: none; not
                                       * owned */
    bool has_advice;
    struct pp_advice advice; /* recommended methods, if requested */
    bool by_clock; /* --time ended the simulation, so another run may give slightly
                    * different values */
};

struct pp_results {
    struct pp_result *list;
    int count;
    bool several; /* print a list, even for a single room */
    bool more_than_one_file;
    bool bands; /* in text, print bands of all methods; in CSV, print bands */
    const struct pp_study_options *options; /* not owned */
};

#endif
