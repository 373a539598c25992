/* section_chart.h - curves of the daylight factor along a line across the room, above a
 * section of the room drawn to the same horizontal scale.
 *
 * There is one curve for each column of daylight factors that has values at the points,
 * with error bars of one standard error if the values were sampled, and a horizontal
 * line for a column with one value for the room. Points are joined by a monotone cubic,
 * which stays within the range of neighbouring values. A point without a value
 * interrupts the curve and is mentioned below the chart.
 *
 * The receivers must be on one straight horizontal line, in any direction and in any
 * order. The vertical section is along that line; a wall with a window at one end of
 * the line is drawn on the left, and distances are measured from its inside face.
 * Openings that are not cut are drawn in outline, as seen beyond the cut. Obstructions
 * outside are represented by the line of sight from the window's middle to their top
 * edge.
 */
#ifndef PP_CHARTS_SECTION_SECTION_CHART_H
#define PP_CHARTS_SECTION_SECTION_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/report.h"

enum pp_section_scale {
    PP_SCALE_AS_FITS, /* logarithmic if values span more than 30 : 1 */
    PP_SCALE_LINEAR,  /* from 0 */
    PP_SCALE_LOG,
};

struct pp_section_chart {
    const struct pp_report *report; /* with world; not owned */
    enum pp_section_scale scale;    /* scale of the daylight factors */
    const char *const *notes;       /* further sentences for the foot; not owned */
    int note_count;
};

/* PP_BAD_INPUT if the receivers do not lie on a line. A report without any value gives
 * a chart without curves, with a note. */
enum pp_status pp_section_chart_draw(struct pp_canvas *canvas,
                                     const struct pp_section_chart *chart,
                                     struct pp_error *err);

#endif
