/* availability_text.h - how often daylight does, as text, JSON and CSV. */
#ifndef PP_CLI_AVAILABILITY_AVAILABILITY_TEXT_H
#define PP_CLI_AVAILABILITY_AVAILABILITY_TEXT_H

#include <stdbool.h>
#include <stdio.h>

#include "studies/study_options.h"
#include "model/results/availability_sheet.h"

/* One room's sheet. */
struct pp_availability_result {
    struct pp_report report;
    struct pp_availability_sheet sheet;
    const char *file; /* as typed; not owned */
    bool by_clock;    /* the simulation was stopped by --time */
};

struct pp_availability_results {
    struct pp_availability_result *list;
    int count;
    bool several; /* as a list, even if there is only one */
    bool more_than_one_file;
    const struct pp_study_options *options; /* not owned */
};

enum pp_status pp_availability_text(const struct pp_availability_results *results,
                                    int width, bool utf8, FILE *out,
                                    struct pp_error *err);

/* One object a room, of format pepperpot-availability-1; an array of them if there are
 * several. */
enum pp_status pp_availability_json(const struct pp_availability_results *results,
                                    FILE *out, struct pp_error *err);

/* One line a place, method, illuminance and period, as [RFC4180] has it. */
enum pp_status pp_availability_text_csv(const struct pp_availability_results *results,
                                        FILE *out, struct pp_error *err);

#endif
