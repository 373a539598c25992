/* nomogram_curve.h - drawing state of a nomogram, and the parts peculiar to nomogram
 * IV: the curve for the depth of the room, and the lines through the curve. */
#ifndef PP_CHARTS_DRAWING_BOARD_NOMOGRAM_CURVE_H
#define PP_CHARTS_DRAWING_BOARD_NOMOGRAM_CURVE_H

#include "charts/sheet/style.h"
#include "model/results/nomogram_sheet.h"

/* Drawing state, with the positions of the scales on paper: left, and y down to bottom,
 * in mm. */
struct pp_nomogram_curve_frame {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_nomogram_sheet *sheet;
    double left, width, bottom, height;
};

/* Position on paper (mm) from fractions of the sheet's width and of the height of the
 * scales. */
double pp_nomogram_curve_x(const struct pp_nomogram_curve_frame *frame, double x);
double pp_nomogram_curve_y(const struct pp_nomogram_curve_frame *frame, double y);

/* Draws the curve with its marks and figures, if the sheet has one. */
void pp_nomogram_curve_draw(const struct pp_nomogram_curve_frame *frame);

/* Draws the straight-edges across the curve for all windows. "d" marks the depth
 * factor, "s" the sideways factor. */
void pp_nomogram_curve_edges(const struct pp_nomogram_curve_frame *frame);

#endif
