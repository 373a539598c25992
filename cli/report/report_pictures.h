/* report_pictures.h - the drawings of a report: their list, and each drawing on its own
 * canvas. */
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

/* Draws the pictures as SVG, for a page or (to_place) to be placed on sheets. For a
 * site (several rooms, objects with a state, or blocks): plan and elevations. For every
 * room: plan and section; if there is a former state, also the area lit now and before;
 * with a profile that includes sunlight, the sun's paths at the window with the least
 * sun. Drawings that are not possible, such as the plan of a room that no hand method
 * covers, are left out. The caller clears the pictures even after a failure. */
enum pp_status pp_report_pictures_draw(struct pp_report_pictures *pictures,
                                       const struct pp_assess_run *run, bool full,
                                       bool to_place, struct pp_error *err);
void pp_report_pictures_clear(struct pp_report_pictures *pictures);

#endif
