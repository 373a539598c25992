/* hatch.h - hatching at 45 degrees, to distinguish areas in print. */
#ifndef PP_CHARTS_SHEET_HATCH_H
#define PP_CHARTS_SHEET_HATCH_H

#include "charts/sheet/lettering.h"

/* Draws hatching lines over a box, within the clip of cairo, apart_mm apart on paper,
 * with the given weight (mm) and grey level. */
void pp_hatch_box(cairo_t *cr, struct pp_box box, double apart_mm, double weight_mm,
                  double grey);

/* Hatches the current path within the box, by the current fill rule, and clears the
 * path. */
void pp_hatch_path(cairo_t *cr, struct pp_box box, double apart_mm, double weight_mm,
                   double grey);

#endif
