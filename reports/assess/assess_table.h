/* assess_table.h - the assessment of a site's rooms as text tables: windows and their
 * sky, rooms and the area with a view of the sky, and all other findings below. */
#ifndef PP_REPORTS_ASSESS_ASSESS_TABLE_H
#define PP_REPORTS_ASSESS_ASSESS_TABLE_H

#include "reports/assess/assess_text.h"

/* Writes text `width` columns wide (60 or more). */
enum pp_status pp_assess_table(const struct pp_assessments *all, int width, FILE *out,
                               struct pp_error *err);

#endif
