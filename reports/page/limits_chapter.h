/* limits_chapter.h - the chapter of a report on the assumptions and limits of its
 * results. */
#ifndef PP_REPORTS_PAGE_LIMITS_CHAPTER_H
#define PP_REPORTS_PAGE_LIMITS_CHAPTER_H

#include "reports/page/site_report.h"

/* Adds the paragraphs that apply to the assessed criteria. */
void pp_limits_chapter(struct pp_document *document,
                       const struct pp_site_report *report);

#endif
