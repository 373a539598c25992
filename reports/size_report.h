/* size_report.h - the window that reaches a target, as text and as JSON. */
#ifndef PP_REPORTS_SIZE_REPORT_H
#define PP_REPORTS_SIZE_REPORT_H

#include <stdbool.h>
#include <stdio.h>

#include "studies/sizing/size_room.h"

struct pp_size_results {
    struct pp_size_room_result *list;
    int count;
    bool several; /* print a list, even for a single room */
    bool more_than_one_file;
    const struct pp_size_request *request; /* not owned */
};

enum pp_status pp_size_report(const struct pp_size_results *results, int width,
                              bool utf8, FILE *out, struct pp_error *err);
/* Length (m) of an opening that is altered by this change, such as its width. */
double pp_size_report_length(struct pp_opening_place place, enum pp_size_change change);

enum pp_status pp_size_report_json(const struct pp_size_results *results, FILE *out,
                                   struct pp_error *err);

#endif
