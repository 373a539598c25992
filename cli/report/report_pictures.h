/* report_pictures.h - the drawings of a report: which there are, and each on a canvas of its
 * own. */
#ifndef PP_CLI_REPORT_REPORT_PICTURES_H
#define PP_CLI_REPORT_REPORT_PICTURES_H

#include <stdbool.h>

#include "charts/sheet/canvas.h"
#include "cli/assess/assess_run.h"
#include "reports/page/site_report.h"

struct pp_report_pictures {
    struct pp_site_picture *list;
    struct pp_canvas **canvases; /* as many */
    int count;
};

/* Draws them: as SVG files, or to be placed on sheets. Of a site (several rooms, things with
 * a state, or blocks) its plan and elevations; of every room its plan and section, of one
 * that was there before also what of it is lit now and before, and where a profile that
 * judges sunlight asks for it the sun's paths at the window that has least. What cannot be
 * drawn, such as the plan of a room that no hand method covers, is left out. To be cleared
 * in any case. */
enum pp_status pp_report_pictures_draw(struct pp_report_pictures *pictures,
                                       const struct pp_assess_run *run, bool full,
                                       bool to_place, struct pp_error *err);
void pp_report_pictures_clear(struct pp_report_pictures *pictures);

#endif
