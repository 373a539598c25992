/* section_chart.h - daylight factor against distance from the window, over the room's
 * section to the same scale.
 *
 * There is one curve for each column of daylight factors that has values at the points,
 * with error bars of one standard error if they were sampled, and a level line for a
 * column with one value for the room. Points are joined by a monotone cubic, which
 * never leaves the range of its neighbours; a point without a value interrupts the
 * curve and is mentioned below the chart.
 *
 * The receivers must lie on one straight horizontal line, in any direction and in any
 * order. The vertical section is along that line, with the window on the left if one
 * end of the line has a wall with a window; distances are from that wall's inside face.
 * Openings that are not cut are drawn in outline, as seen behind the cut. Obstructions
 * outside are shown by the line of sight from the window's middle to their head.
 */
#ifndef PP_CHARTS_ROOM_SECTION_CHART_H
#define PP_CHARTS_ROOM_SECTION_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/report.h"

enum pp_section_scale {
    PP_SCALE_AS_FITS, /* logarithmic if values span more than 30 : 1 */
    PP_SCALE_LINEAR,  /* from 0 */
    PP_SCALE_LOG,
};

struct pp_section_chart {
    const struct pp_report *report; /* with world; not owned */
    enum pp_section_scale scale;    /* of the daylight factors */
    const char *const *notes;       /* further sentences for the foot; not owned */
    int note_count;
};

/* PP_BAD_INPUT if the receivers do not lie on a line. A report without any value gives
 * a chart without curves, with a note. */
enum pp_status pp_section_chart_draw(struct pp_canvas *canvas,
                                     const struct pp_section_chart *chart,
                                     struct pp_error *err);

#endif
