/* assess_table_json.h - the table of a site (site_table.h) as JSON. */
#ifndef PP_REPORTS_ASSESS_ASSESS_TABLE_JSON_H
#define PP_REPORTS_ASSESS_ASSESS_TABLE_JSON_H

#include "reports/assess/assess_text.h"

/* Writes { "format": "pepperpot-site-1", "br209": {...}, "windows": [...], "rooms":
 * [...], "others": [...] }, each row on one line. "sunlight", "gardens" and
 * "rights_of_light" follow "rooms" if there are such findings. */
enum pp_status pp_assess_table_json(const struct pp_assessments *all, FILE *out,
                                    struct pp_error *err);

#endif
