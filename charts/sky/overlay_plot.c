/* overlay_plot.c - north up, east on the left or, on a sheet, on the right. */
#include "charts/sky/overlay_plot.h"

#include <math.h>

void pp_overlay_plot_place(const struct pp_overlay_plot *plot, double altitude,
                           double bearing, double xy[2])
{
    double r =
        plot->radius * pp_lens_radius(plot->overlay->lens, 0.5 * PP_PI - altitude);
    double east = plot->overlay->title ? 1.0 : -1.0;
    xy[0] = plot->x0 + east * r * sin(bearing);
    xy[1] = plot->y0 - r * cos(bearing);
}

void pp_overlay_plot_stroke(const struct pp_overlay_plot *plot, double weight_mm)
{
    pp_style_line(plot->cr, weight_mm + 0.3 * plot->style.scale, 1.0);
    cairo_stroke_preserve(plot->cr);
    pp_style_line(plot->cr, weight_mm, PP_INK);
    cairo_stroke(plot->cr);
}
