/* site_report.h - the report on the rooms of a site, as a document. */
#ifndef PP_REPORTS_PAGE_SITE_REPORT_H
#define PP_REPORTS_PAGE_SITE_REPORT_H

#include "model/results/document.h"
#include "model/room/project.h"
#include "reports/assess/assess_text.h"

/* A picture. Its number is its index in the list. */
struct pp_site_picture {
    int room;          /* index of the room in struct pp_assessments; PP_SITE_WHOLE: the
                        * picture shows the whole site */
    const char *title; /* such as "Plan: daylight factors"; not owned */
};

enum { PP_SITE_WHOLE = -1 };

struct pp_site_report {
    const struct pp_assessments *all;       /* finished assessments */
    const struct pp_project *project;       /* facts of the title block */
    bool full;                              /* all sections for every room; false: short
                                             * report */
    const char *title;                      /* title of the building or the room */
    const char *made_by;                    /* command line that made the report */
    const char *version;                    /* version of the program */
    const struct pp_site_picture *pictures; /* in the order of the rooms */
    int picture_count;

    /* Finds a publication by key (or "KEY, page 3"). *key is set to the key that the
     * list of sources prints. NULL: no such publication. */
    const char *(*work_of)(const char *place, const char **key);
};

/* Makes the document. The document begins with the verdicts, drawings of the site, and
 * tables of windows and rooms before and after a development. In a full report a
 * chapter for each room follows: input and assumptions, drawings, daylight factors by
 * hand with their bands and simulated with standard errors, verdicts, and possible
 * improvements. In a short report a table of the rooms and a table for each criterion
 * follow. Then there is a chapter on limits and assumptions. The last chapter lists the
 * command, the methods and the sources. The caller clears *document even after a
 * failure. */
enum pp_status pp_site_report(struct pp_document *document,
                              const struct pp_site_report *report,
                              struct pp_error *err);

#endif
