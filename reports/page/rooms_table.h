/* rooms_table.h - the rooms of a short report in one table: place, size, finishes,
 * windows. */
#ifndef PP_REPORTS_PAGE_ROOMS_TABLE_H
#define PP_REPORTS_PAGE_ROOMS_TABLE_H

#include "model/results/document.h"
#include "reports/assess/assess_text.h"

void pp_rooms_table(struct pp_document *document, const struct pp_assessments *all);

#endif
