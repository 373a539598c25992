/* nomogram_curve.h - state of a nomogram while it is drawn, and the parts of nomogram
 * IV: the curve of the room's depth in ranges of the light, and the lines through
 * it. */
#ifndef PP_CHARTS_DRAWING_BOARD_NOMOGRAM_CURVE_H
#define PP_CHARTS_DRAWING_BOARD_NOMOGRAM_CURVE_H

#include "charts/sheet/style.h"
#include "model/results/nomogram_sheet.h"

/* Positions of the scales on paper: x from the left, y down, in mm. */
struct pp_nomogram_curve_frame {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_nomogram_sheet *sheet;
    double left, width, bottom, height;
};

/* Position from fractions of the sheet's width and the scales' height. */
double pp_nomogram_curve_x(const struct pp_nomogram_curve_frame *frame, double x);
double pp_nomogram_curve_y(const struct pp_nomogram_curve_frame *frame, double y);

/* Draws the curve with its marks and figures, if the sheet has one. */
void pp_nomogram_curve_draw(const struct pp_nomogram_curve_frame *frame);

/* Draws the straight-edges across the curve for all windows: "d" for the factor by
 * depth, "s" for the sideways factor. */
void pp_nomogram_curve_edges(const struct pp_nomogram_curve_frame *frame);

#endif
