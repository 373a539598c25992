/* room_chapter.h - a room's chapter of a report, with cells and pictures used by other
 * chapters too. Inside reports/page/ only. */
#ifndef PP_REPORTS_PAGE_ROOM_CHAPTER_H
#define PP_REPORTS_PAGE_ROOM_CHAPTER_H

#include "reports/page/site_report.h"

/* Adds the chapter of room `room` of the assessments. */
void pp_room_chapter(struct pp_document *document, const struct pp_site_report *report,
                     int room);

/* Adds the pictures of that room; PP_SITE_WHOLE: of the site. */
void pp_room_chapter_pictures(struct pp_document *document,
                              const struct pp_site_report *report, int room);

/* Adds a cell with a number (a dash if it is not finite) or with a verdict ("no target"
 * or a dash for a figure without a criterion). */
void pp_room_chapter_number(struct pp_document *document, double value, int decimals);
void pp_room_chapter_verdict(struct pp_document *document,
                             const struct pp_finding *finding);

#endif
