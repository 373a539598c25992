/* site_report.h - what the report on the rooms of a site says, as a document. */
#ifndef PP_REPORTS_PAGE_SITE_REPORT_H
#define PP_REPORTS_PAGE_SITE_REPORT_H

#include "model/results/document.h"
#include "reports/assess/assess_text.h"

/* A drawing, whose number is its place in the list. */
struct pp_site_picture {
    int room; /* whose, among the assessments; PP_SITE_WHOLE: of a site as a whole */
    const char *title; /* "Plan: daylight factors"; not owned */
};

enum { PP_SITE_WHOLE = -1 };

struct pp_site_report {
    const struct pp_assessments *all;       /* judged */
    const char *title;                      /* of the building or the room */
    const char *made_by;                    /* the command line */
    const char *version;                    /* of the program */
    const struct pp_site_picture *pictures; /* in the order of the rooms */
    int picture_count;

    /* The work that a key (or "KEY, page 3") stands for, and the key as listed; NULL:
     * none. */
    const char *(*work_of)(const char *place, const char **key);
};

/* Verdicts, drawings of the site and windows and rooms before and after; a chapter of each
 * room: inputs and what is assumed, drawings, daylight factors by hand with their bands and
 * traced with their standard errors, verdicts, what would help; and how it was made.
 * document is to be cleared in any case. */
enum pp_status pp_site_report(struct pp_document *document,
                              const struct pp_site_report *report,
                              struct pp_error *err);

#endif
