/* overlay_plot.h - where a direction is on an overlay, and lines with a white edge. Inside
 * charts/sky/ only. */
#ifndef PP_CHARTS_SKY_OVERLAY_PLOT_H
#define PP_CHARTS_SKY_OVERLAY_PLOT_H

#include "charts/sheet/labels.h"
#include "charts/sky/overlay_chart.h"

struct pp_overlay_plot {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_overlay *overlay;
    struct pp_labels *labels;
    double x0, y0, radius; /* of the horizon's circle, mm */
};

/* Position on paper of a direction; angles in radians. */
void pp_overlay_plot_place(const struct pp_overlay_plot *plot, double altitude,
                           double bearing, double xy[2]);

/* Strokes the path in black on a broader white. */
void pp_overlay_plot_stroke(const struct pp_overlay_plot *plot, double weight_mm);

#endif
