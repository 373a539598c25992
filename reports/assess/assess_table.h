/* assess_table.h - the assessment of a site as text tables: windows with their sky
 * component, rooms with the area that has a view of the sky, sunlight at windows,
 * gardens, rights of light, then all other findings. */
#ifndef PP_REPORTS_ASSESS_ASSESS_TABLE_H
#define PP_REPORTS_ASSESS_ASSESS_TABLE_H

#include "reports/assess/assess_text.h"

/* Writes text in lines of `width` columns (60 or more). */
enum pp_status pp_assess_table(const struct pp_assessments *all, int width, FILE *out,
                               struct pp_error *err);

#endif
