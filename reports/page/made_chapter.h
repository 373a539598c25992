/* made_chapter.h - the last chapter of a report, which states program, methods and
 * sources so that the report can be reproduced. For use inside reports/page/ only. */
#ifndef PP_REPORTS_PAGE_MADE_CHAPTER_H
#define PP_REPORTS_PAGE_MADE_CHAPTER_H

#include "reports/page/site_report.h"

/* Adds the chapter. The chapter must be the last one, since it lists the publications
 * that the document cites by keys in square brackets. */
enum pp_status pp_made_chapter(struct pp_document *document,
                               const struct pp_site_report *report,
                               struct pp_error *err);

#endif
