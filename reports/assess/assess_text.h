/* assess_text.h - assessments of rooms, as text. */
#ifndef PP_REPORTS_ASSESS_ASSESS_TEXT_H
#define PP_REPORTS_ASSESS_ASSESS_TEXT_H

#include <stdio.h>

#include "studies/criteria/assessment.h"

struct pp_assessments {
    struct pp_assessment *list;
    int count;
    bool several; /* print a list, even for a single room */
    bool more_than_one_file;
    const struct pp_study_options *options; /* not owned */
};

/* Writes text in lines of `width` columns (60 or more). */
enum pp_status pp_assess_text(const struct pp_assessments *assessments, int width,
                              bool utf8, FILE *out, struct pp_error *err);

#endif
