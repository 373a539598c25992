/* axis.h - straight axes with round ticks: linear, or logarithmic by 1, 2, 5. */
#ifndef PP_CHARTS_SHEET_AXIS_H
#define PP_CHARTS_SHEET_AXIS_H

#include <stdbool.h>

#include "charts/sheet/style.h"
#include "charts/sheet/lettering.h"

enum { PP_TICKS_MOST = 64 };

/* Map from values to places on paper; from > to reverses it (upwards, on paper). */
struct pp_axis {
    double low, high; /* values at its ends, low < high */
    double from, to;  /* positions of the ends, mm */
    bool logarithmic; /* then low > 0 */
    int tick_count;
    double ticks[PP_TICKS_MOST]; /* ascending, within low ... high */
    int decimals;                /* decimals of tick labels; -1: as few as possible */
};

/* A linear axis from low to high (low < high; both finite), with ticks at least
 * apart_mm apart. round: the ends are moved outwards to the next ticks. */
struct pp_axis pp_axis_linear(double low, double high, double from, double to,
                              double apart_mm, bool round);

/* A logarithmic axis, whose ends are moved outwards to ticks; 0 < low < high. */
struct pp_axis pp_axis_log(double low, double high, double from, double to,
                           double apart_mm);

/* Position of a value (mm), also for values beyond the ends. On a logarithmic axis
 * values of 0 or less are at its low end. */
double pp_axis_at(const struct pp_axis *axis, double value);

/* A tick's label. */
void pp_axis_label(const struct pp_axis *axis, int tick, char *text, size_t room);

/* Draws a horizontal axis with its ticks below y, or a vertical one with ticks left of
 * x. Returns how far labels extend from the line. Labels that would overlap the one
 * before are left out. */
double pp_axis_draw_across(cairo_t *cr, const struct pp_style *style,
                           const struct pp_axis *axis, double y);
double pp_axis_draw_up(cairo_t *cr, const struct pp_style *style,
                       const struct pp_axis *axis, double x);

/* Width of the labels of a vertical axis, mm. */
double pp_axis_reach(cairo_t *cr, const struct pp_style *style,
                     const struct pp_axis *axis);

/* Grid lines at the ticks, over the whole length of the other axis. */
void pp_axis_grid_across(cairo_t *cr, const struct pp_style *style,
                         const struct pp_axis *up, double left, double right);
void pp_axis_grid_up(cairo_t *cr, const struct pp_style *style,
                     const struct pp_axis *across, double top, double bottom);

#endif
