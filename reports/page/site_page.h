/* site_page.h - the report on the rooms of a site, as one page of HTML. */
#ifndef PP_REPORTS_PAGE_SITE_PAGE_H
#define PP_REPORTS_PAGE_SITE_PAGE_H

#include "reports/assess/assess_text.h"

/* A drawing, as SVG. */
struct pp_site_picture {
    int room;          /* whose, among the assessments */
    const char *title; /* "Plan: daylight factors" */
    char *svg;         /* owned by whoever made it */
    size_t length;
};

struct pp_site_page {
    const struct pp_assessments *all;       /* judged */
    const char *title;                      /* of the building or the room */
    const char *made_by;                    /* the command line */
    const char *version;                    /* of the program */
    const struct pp_site_picture *pictures; /* in the order of the rooms */
    int picture_count;
};

/* Inputs and what is assumed, drawings, daylight factors by hand with their bands and
 * traced with their standard errors, verdicts, what would help, and how it was made. */
enum pp_status pp_site_page(const struct pp_site_page *page, FILE *out,
                            struct pp_error *err);

#endif
