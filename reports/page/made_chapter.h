/* made_chapter.h - the last chapter of a report: by which program, methods and sources it was
 * made, so that it can be made again. Inside reports/page/ only. */
#ifndef PP_REPORTS_PAGE_MADE_CHAPTER_H
#define PP_REPORTS_PAGE_MADE_CHAPTER_H

#include "reports/page/site_report.h"

/* The works that the document names by keys in square brackets are listed, so it comes
 * last. */
enum pp_status pp_made_chapter(struct pp_document *document,
                               const struct pp_site_report *report,
                               struct pp_error *err);

#endif
