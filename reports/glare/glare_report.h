/* glare_report.h - daylight glare probability of rooms, at one moment or over a year,
 * as text and CSV. For JSON see glare_json.h.
 */
#ifndef PP_REPORTS_GLARE_GLARE_REPORT_H
#define PP_REPORTS_GLARE_GLARE_REPORT_H

#include <stdio.h>

#include "model/base/error.h"
#include "model/results/sheets/glare_sheet.h"

struct pp_glare_result {
    struct pp_glare_sheet sheet;
    const char *file; /* as typed; not owned */
};

struct pp_glare_results {
    struct pp_glare_result *list;
    int count;
    bool several;     /* print a list, even for a single room */
    const char *when; /* moment as typed; NULL: none; not owned */
};

enum pp_status pp_glare_report_text(const struct pp_glare_results *results, int width,
                                    FILE *out, struct pp_error *err);
enum pp_status pp_glare_report_csv(const struct pp_glare_results *results, FILE *out,
                                   struct pp_error *err);

#endif
