/* section_chart.h - daylight factor against distance from the window, over the room's
 * section to the same scale.
 *
 * One curve for each column of daylight factors that has values at the points, error
 * bars of one standard error where they were sampled, a level line for a column that
 * speaks for the room only. Points are joined by a monotone cubic, which never leaves
 * the range of its neighbours; a point without a value breaks the curve and is
 * accounted for below the chart.
 *
 * The receivers must lie on one straight horizontal line, in any direction and in any
 * order. The section is cut along it, upright, with the window on the left where one
 * end of the line has a wall with a window; distances are from that wall's inside face.
 * Openings that are not cut are drawn in outline, as seen behind the cut. Obstructions
 * outside show as the line of sight from the window's middle to their head.
 */
#ifndef PP_CHARTS_ROOM_SECTION_CHART_H
#define PP_CHARTS_ROOM_SECTION_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/report.h"

enum pp_section_scale {
    PP_SCALE_AS_FITS, /* logarithmic where values span more than 30 : 1 */
    PP_SCALE_LINEAR,  /* from 0 */
    PP_SCALE_LOG,
};

struct pp_section_chart {
    const struct pp_report *report; /* with world; not owned */
    enum pp_section_scale scale;    /* of the daylight factors */
    const char *const *notes;       /* further sentences for the foot; not owned */
    int note_count;
};

/* PP_BAD_INPUT where the receivers don't lie on a line. A report without any value is
 * drawn as far as it goes, and the chart says so. */
enum pp_status pp_section_chart_draw(struct pp_canvas *canvas,
                                     const struct pp_section_chart *chart,
                                     struct pp_error *err);

#endif
