/* smooth.h - a smooth curve through points, which stays between neighbouring points. */
#ifndef PP_CHARTS_SHEET_SMOOTH_H
#define PP_CHARTS_SHEET_SMOOTH_H

#include <cairo.h>

/* Adds to the path the piecewise cubic through the points, with slopes after Fritsch
 * and Butland [FB84]: monotone wherever the points are, smooth elsewhere. The x of the
 * points must ascend strictly; count is 1 or more, of one only the point is moved to.
 */
void pp_smooth_path(cairo_t *cr, const double (*xy)[2], int count);

#endif
