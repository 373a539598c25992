/* site_report.h - the content of the report on the rooms of a site, as a document. */
#ifndef PP_REPORTS_PAGE_SITE_REPORT_H
#define PP_REPORTS_PAGE_SITE_REPORT_H

#include "model/results/document.h"
#include "model/room/project.h"
#include "reports/assess/assess_text.h"

/* A drawing; its number is its index in the list. */
struct pp_site_picture {
    int room;          /* index of the room in struct pp_assessments; PP_SITE_WHOLE: the
               * picture shows the whole site */
    const char *title; /* "Plan: daylight factors"; not owned */
};

enum { PP_SITE_WHOLE = -1 };

struct pp_site_report {
    const struct pp_assessments *all;       /* judged */
    const struct pp_project *project;       /* facts of the title block */
    bool full;                              /* all sections for every room; false: a
                                             * short form */
    const char *title;                      /* title of the building or the room */
    const char *made_by;                    /* the command line */
    const char *version;                    /* version of the program */
    const struct pp_site_picture *pictures; /* in the order of the rooms */
    int picture_count;

    /* Source of a key (or "KEY, page 3"), and the key as printed in the list of
     * sources; NULL: no source. */
    const char *(*work_of)(const char *place, const char **key);
};

/* Makes a document with the verdicts, drawings of the site, and drawings of windows and
 * rooms before and after a development. A chapter for each room follows: inputs and
 * assumptions, drawings, daylight factors by hand with their bands and simulated with
 * their standard errors, verdicts, and possible improvements. The last chapter lists
 * the command, the methods and the sources. The caller clears document even after a
 * failure. */
enum pp_status pp_site_report(struct pp_document *document,
                              const struct pp_site_report *report,
                              struct pp_error *err);

#endif
