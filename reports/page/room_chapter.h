/* room_chapter.h - the chapter on a room in a report. Also adds cells and pictures to
 * other chapters. For use inside reports/page/ only. */
#ifndef PP_REPORTS_PAGE_ROOM_CHAPTER_H
#define PP_REPORTS_PAGE_ROOM_CHAPTER_H

#include "reports/page/site_report.h"

/* Adds the chapter on a room. room: index in the assessments. */
void pp_room_chapter(struct pp_document *document, const struct pp_site_report *report,
                     int room);

/* Adds the pictures of a room; room PP_SITE_WHOLE: the pictures of the site. */
void pp_room_chapter_pictures(struct pp_document *document,
                              const struct pp_site_report *report, int room);

/* The first function adds a cell with a number, or a dash if it is not finite. The
 * second adds a cell with the verdict of a finding: "no target" or a dash if there is
 * no verdict. */
void pp_room_chapter_number(struct pp_document *document, double value, int decimals);
void pp_room_chapter_verdict(struct pp_document *document,
                             const struct pp_finding *finding);

#endif
