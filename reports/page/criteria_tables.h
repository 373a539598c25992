/* criteria_tables.h - the results of many rooms by criterion, for a short report: one
 * table for each criterion, with a row for each room. */
#ifndef PP_REPORTS_PAGE_CRITERIA_TABLES_H
#define PP_REPORTS_PAGE_CRITERIA_TABLES_H

#include "model/results/document.h"
#include "reports/assess/assess_text.h"

/* Adds a section for each criterion that is not in the tables of windows, rooms,
 * sunlight, gardens and rights of light (pp_site_table_of). Texts that are the same for
 * all rooms appear once. Notes that differ between rooms are left out of tables with
 * several figures per row, and the section says so. */
enum pp_status pp_criteria_tables(struct pp_document *document,
                                  const struct pp_assessments *all,
                                  struct pp_error *err);

#endif
