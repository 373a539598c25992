/* axis.h - straight axes with round ticks: linear, or logarithmic with ticks at 1, 2
 * and 5 times powers of ten. */
#ifndef PP_CHARTS_SHEET_AXIS_H
#define PP_CHARTS_SHEET_AXIS_H

#include <stdbool.h>

#include "charts/sheet/style.h"
#include "charts/sheet/lettering.h"

enum { PP_TICKS_MOST = 64 };

/* Map from values to positions on paper (mm). If from > to, values increase upwards or
 * to the left. */
struct pp_axis {
    double low, high; /* values at the ends of the axis, low < high */
    double from, to;  /* positions of the ends, mm */
    bool logarithmic; /* requires low > 0 */
    int tick_count;
    double ticks[PP_TICKS_MOST]; /* ascending, within low ... high */
    int decimals;                /* decimals of tick labels; -1: as few as possible */
};

/* Makes a linear axis from low to high (low < high, both finite) with ticks at least
 * apart_mm apart. round: move the ends outwards to the next ticks. */
struct pp_axis pp_axis_linear(double low, double high, double from, double to,
                              double apart_mm, bool round);

/* Makes a logarithmic axis (0 < low < high) and moves its ends outwards to the next
 * ticks. */
struct pp_axis pp_axis_log(double low, double high, double from, double to,
                           double apart_mm);

/* Position of a value (mm), also for values beyond the ends. On a logarithmic axis a
 * value of 0 or less is at the low end. */
double pp_axis_at(const struct pp_axis *axis, double value);

/* Writes the label of a tick. */
void pp_axis_label(const struct pp_axis *axis, int tick, char *text, size_t room);

/* Draws a horizontal axis with ticks below y, or a vertical axis with ticks left of x.
 * Returns how far labels extend from the axis (mm). A label that would overlap the
 * previous label is omitted. */
double pp_axis_draw_across(cairo_t *cr, const struct pp_style *style,
                           const struct pp_axis *axis, double y);
double pp_axis_draw_up(cairo_t *cr, const struct pp_style *style,
                       const struct pp_axis *axis, double x);

/* Distance to which the tick labels of a vertical axis extend from the axis, mm. */
double pp_axis_reach(cairo_t *cr, const struct pp_style *style,
                     const struct pp_axis *axis);

/* Draws grid lines at the ticks, over the whole length of the other axis. */
void pp_axis_grid_across(cairo_t *cr, const struct pp_style *style,
                         const struct pp_axis *up, double left, double right);
void pp_axis_grid_up(cairo_t *cr, const struct pp_style *style,
                     const struct pp_axis *across, double top, double bottom);

#endif
