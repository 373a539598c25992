/* report_pictures.h - the drawings of a report: a list of them, and a canvas for each
 * drawing. */
#ifndef PP_CLI_REPORT_REPORT_PICTURES_H
#define PP_CLI_REPORT_REPORT_PICTURES_H

#include <stdbool.h>

#include "charts/sheet/canvas.h"
#include "cli/assess/assess_run.h"
#include "reports/page/site_report.h"

struct pp_report_pictures {
    struct pp_site_picture *list;
    struct pp_canvas **canvases; /* one canvas for each element of `list` */
    int count;
};

/* Draws the pictures as SVG for a page, or, if to_place is set, for sheets. A site
 * (several rooms, a former state, or blocks) has a plan and elevations. If `full` is
 * set, each room has a plan and a section, and the chart of its simulated year if there
 * is one. A room with a former state then also has a plan of the present and former lit
 * area. If the profile includes sunlight, sun paths are drawn for the window with the
 * least sun. Drawings that are not possible are omitted, such as the plan of a room to
 * which no hand method applies. The caller clears the pictures even after a failure. */
enum pp_status pp_report_pictures_draw(struct pp_report_pictures *pictures,
                                       const struct pp_assess_run *run, bool full,
                                       bool to_place, struct pp_error *err);
void pp_report_pictures_clear(struct pp_report_pictures *pictures);

#endif
