/* df_result.h - reports of rooms, with data of the run: the input of the df and
 * validate reports. */
#ifndef PP_REPORTS_DF_RESULT_H
#define PP_REPORTS_DF_RESULT_H

#include <stdbool.h>

#include "model/results/report.h"
#include "studies/bands/advice.h"
#include "studies/study_options.h"

/* Report of one room. */
struct pp_result {
    struct pp_report report;
    const char *file;                 /* as typed; not owned */
    const struct pp_mistakes *doubts; /* warnings; NULL: none; not owned */
    bool has_advice;
    struct pp_advice advice; /* recommended method, if requested */
    bool by_clock; /* the simulation was stopped by --time, so that another run may give
                    * other digits */
};

struct pp_results {
    struct pp_result *list;
    int count;
    bool several; /* printed as a list, even if there is only one */
    bool more_than_one_file;
    bool bands; /* print bands of all methods in text, and bands in CSV */
    const struct pp_study_options *options; /* not owned */
};

#endif
