/* hatch.h - lines at 45 degrees, to distinguish areas in print. */
#ifndef PP_CHARTS_SHEET_HATCH_H
#define PP_CHARTS_SHEET_HATCH_H

#include "charts/sheet/lettering.h"

/* Draws lines over a box, within cairo's clip: apart_mm apart on paper, of that weight
 * (mm) and grey. */
void pp_hatch_box(cairo_t *cr, struct pp_box box, double apart_mm, double weight_mm,
                  double grey);

/* Hatches the current path, by the current fill rule, within the box, and clears the
 * path. */
void pp_hatch_path(cairo_t *cr, struct pp_box box, double apart_mm, double weight_mm,
                   double grey);

#endif
