/* contour_lines.h - contour lines on paper, each with its figure in a gap of the
 * line. */
#ifndef PP_CHARTS_ROOM_CONTOUR_LINES_H
#define PP_CHARTS_ROOM_CONTOUR_LINES_H

#include "charts/sheet/labels.h"
#include "charts/room/room_plan.h"
#include "model/geometry/curve.h"

/* Draws a curve with the figure of its level in a gap, along the line and never upside
 * down. The figure avoids places of other owners and is registered in `labels`. Returns
 * false if the line has no figure because it is too short or has no free place. */
bool pp_contour_lines_draw(cairo_t *cr, const struct pp_style *style,
                           const struct pp_room_plan *plan,
                           const struct pp_curve *curve, double weight_mm,
                           const char *words, struct pp_labels *labels, int owner);

/* Adds a curve to the path. */
void pp_contour_lines_path(cairo_t *cr, const struct pp_room_plan *plan,
                           const struct pp_curve *curve);

#endif
