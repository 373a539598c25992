/* rooms_table.h - a table of the rooms in a short report: position, size, finishes and
 * windows. */
#ifndef PP_REPORTS_PAGE_ROOMS_TABLE_H
#define PP_REPORTS_PAGE_ROOMS_TABLE_H

#include "model/results/document.h"
#include "reports/assess/assess_text.h"

void pp_rooms_table(struct pp_document *document, const struct pp_assessments *all);

#endif
