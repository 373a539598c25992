/* nomogram_curve.h - drawing state of a nomogram, and the parts peculiar to nomogram
 * IV: the curve of q, for the position of a point, and the lines through the curve. */
#ifndef PP_CHARTS_DRAWING_BOARD_NOMOGRAM_CURVE_H
#define PP_CHARTS_DRAWING_BOARD_NOMOGRAM_CURVE_H

#include "charts/sheet/style.h"
#include "model/results/nomogram_sheet.h"

/* Drawing state. left, width, bottom, height: area of the scales on paper, mm. */
struct pp_nomogram_curve_frame {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_nomogram_sheet *sheet;
    double left, width, bottom, height;
};

/* Position on paper (mm) from fractions of the width and height of the frame; y runs
 * upwards from the bottom. */
double pp_nomogram_curve_x(const struct pp_nomogram_curve_frame *frame, double x);
double pp_nomogram_curve_y(const struct pp_nomogram_curve_frame *frame, double y);

/* Draws the curve with its marks and figures, if the sheet has one. */
void pp_nomogram_curve_draw(const struct pp_nomogram_curve_frame *frame);

/* Draws the positions of the straight-edge across the curve, two for each window: "d"
 * marks the depth factor, "s" the sideways factor. */
void pp_nomogram_curve_edges(const struct pp_nomogram_curve_frame *frame);

#endif
