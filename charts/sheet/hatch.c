/* hatch.c - see hatch.h. */
#include "charts/sheet/hatch.h"

#include <math.h>

void pp_hatch_box(cairo_t *cr, struct pp_box box, double apart_mm, double weight_mm,
                  double grey)
{
    double step = apart_mm * sqrt(2.0);
    pp_style_line(cr, weight_mm, grey);
    for (double at = box.x - box.height; at < box.x + box.width; at += step) {
        cairo_move_to(cr, at, box.y + box.height);
        cairo_line_to(cr, at + box.height, box.y);
    }
    cairo_stroke(cr);
}

void pp_hatch_path(cairo_t *cr, struct pp_box box, double apart_mm, double weight_mm,
                   double grey)
{
    cairo_save(cr);
    cairo_clip(cr);
    pp_hatch_box(cr, box, apart_mm, weight_mm, grey);
    cairo_restore(cr);
}
