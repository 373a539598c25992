/* section_chart.h - curves of the daylight factor along a line across the room, above a
 * section of the room drawn to the same horizontal scale.
 *
 * There is one curve for each column of daylight factors with values at the points.
 * Simulated values have error bars of one standard error. A column with one value for
 * the whole room is a horizontal line. Points are joined by a monotone cubic, which
 * stays within the range of neighbouring values. A point without a value interrupts the
 * curve and is mentioned below the chart.
 *
 * The receivers must be on one straight horizontal line, in any direction and in any
 * order. The vertical section follows that line. If only one end of the line is at a
 * wall with a window, that wall is drawn on the left. Distances are measured from the
 * inside face of the wall on the left. Openings that are not cut are dashed outlines.
 * Obstructions outside are represented by the line of sight from the middle of the
 * window to their top edge.
 */
#ifndef PP_CHARTS_SECTION_SECTION_CHART_H
#define PP_CHARTS_SECTION_SECTION_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/report.h"

enum pp_section_scale {
    PP_SCALE_AS_FITS, /* logarithmic if the values span more than 30 : 1, else linear */
    PP_SCALE_LINEAR,  /* linear, from 0 */
    PP_SCALE_LOG,
};

struct pp_section_chart {
    const struct pp_report *report; /* report with a world; not owned */
    enum pp_section_scale scale;    /* scale of the daylight factors */
    const char *const *notes;       /* further sentences for the foot of the sheet; not
                                     * owned */
    int note_count;
};

/* Draws the chart. PP_BAD_INPUT if the receivers do not lie on a line. A report without
 * values gives a chart without curves and with a note. */
enum pp_status pp_section_chart_draw(struct pp_canvas *canvas,
                                     const struct pp_section_chart *chart,
                                     struct pp_error *err);

#endif
