/* smooth.c - the monotone piecewise cubic of Fritsch and Butland [FB84].
 *
 * Between two points stands the cubic that has the slope m of each end. With the widths
 * h0, h1 and slopes d0, d1 of the chords before and behind a point,
 *
 *     m = 1 / (w / d0 + (1 - w) / d1)          d0 d1 > 0, else 0
 *     w = (h0 + 2 h1) / (3 (h0 + h1))
 *
 * At the first and last point m is the slope of the only chord.
 */
#include "charts/sheet/smooth.h"

/* Slope at point i: the weighted harmonic mean of the chords' on either side, 0 at a
 * turn; at the ends the chord's own. */
static double slope_at(const double (*xy)[2], int count, int i)
{
    int left = i > 0 ? i - 1 : 0, right = i + 1 < count ? i : count - 2;
    double h0 = xy[left + 1][0] - xy[left][0], h1 = xy[right + 1][0] - xy[right][0];
    double d0 = (xy[left + 1][1] - xy[left][1]) / h0;
    double d1 = (xy[right + 1][1] - xy[right][1]) / h1;
    if (!(d0 * d1 > 0.0))
        return 0.0;
    double w0 = (h0 + 2.0 * h1) / (3.0 * (h0 + h1)), w1 = 1.0 - w0;
    return 1.0 / (w0 / d0 + w1 / d1);
}

void pp_smooth_path(cairo_t *cr, const double (*xy)[2], int count)
{
    cairo_move_to(cr, xy[0][0], xy[0][1]);
    for (int i = 0; i + 1 < count; i++) {
        double third = (xy[i + 1][0] - xy[i][0]) / 3.0;
        double m0 = slope_at(xy, count, i), m1 = slope_at(xy, count, i + 1);
        cairo_curve_to(cr, xy[i][0] + third, xy[i][1] + third * m0,
                       xy[i + 1][0] - third, xy[i + 1][1] - third * m1, xy[i + 1][0],
                       xy[i + 1][1]);
    }
}
