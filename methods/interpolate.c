/* interpolate.c - Lagrange cubics, Gauss quadrature and inversion for tables with equal
 * steps, and linear interpolation between the rows of published tables. */
#include "methods/interpolate.h"

#include <math.h>

/* Index of the first of the four entries used to interpolate between two entries. */
static int first_of_four(int below, int count)
{
    return below < 1 ? 0 : below > count - 3 ? count - 4 : below - 1;
}

/* Lagrange's form with the entries at t = 0, 1, 2, 3. */
static double cubic(const double v[4], double t)
{
    double t1 = t - 1.0, t2 = t - 2.0, t3 = t - 3.0;
    return -v[0] * t1 * t2 * t3 / 6.0 + v[1] * t * t2 * t3 / 2.0
           - v[2] * t * t1 * t3 / 2.0 + v[3] * t * t1 * t2 / 6.0;
}

double pp_interpolate_cubic(const double *values, int count, double low, double high,
                            double x)
{
    double last = count - 1, place = (x - low) / (high - low) * last;
    place = place > 0.0 ? place : 0.0;
    place = place < last ? place : last;
    int first = first_of_four((int)place, count);
    return cubic(values + first, place - first);
}

void pp_interpolate_tabulate_integral(double *values, int count, double low,
                                      double high,
                                      double (*function)(const void *context, double x),
                                      const void *context)
{
    static const double place[] = {0.33998104358485626, 0.86113631159405258};
    static const double weight[] = {0.65214515486254614, 0.34785484513745386};
    double half = (high - low) / (count - 1) / 2.0;
    values[0] = 0.0;
    for (int i = 1; i < count; i++) {
        double middle = low + (2 * i - 1) * half, sum = 0.0;
        for (int k = 0; k < 2; k++)
            sum += weight[k]
                   * (function(context, middle - half * place[k])
                      + function(context, middle + half * place[k]));
        values[i] = values[i - 1] + half * sum;
    }
}

double pp_interpolate_inverse(const double *values, int count, double low, double high,
                              double value)
{
    /* Finds the step that contains the value, then the position within it. */
    int below = 0, above = count - 1;
    while (above - below > 1) {
        int middle = (below + above) / 2;
        if (values[middle] < value)
            below = middle;
        else
            above = middle;
    }
    int first = first_of_four(below, count), side = 0;
    double step = (high - low) / (count - 1), left = below - first, right = left + 1.0;
    double off_left = values[below] - value, off_right = values[above] - value;
    if (off_left >= 0.0 || off_right <= 0.0)
        return low + (off_left >= 0.0 ? below : above) * step;
    /* Regula falsi with the Illinois modification: the value at the retained end is
     * halved. Needs about six evaluations of the cubic. */
    double t = left, last;
    do {
        last = t;
        t = right - off_right * (right - left) / (off_right - off_left);
        double off = cubic(values + first, t) - value;
        if (off < 0.0) {
            left = t;
            off_left = off;
            off_right *= side < 0 ? 0.5 : 1.0;
            side = -1;
        } else {
            right = t;
            off_right = off;
            off_left *= side > 0 ? 0.5 : 1.0;
            side = 1;
        }
    } while (fabs(t - last) > 1e-11 && off_right > off_left);
    return low + (first + t) * step;
}

int pp_interpolate_interval(const double *rows, int count, int width, int column,
                            double x, double *share)
{
    int upper = 1;
    while (upper < count - 1 && x > rows[upper * width + column])
        upper++;
    double low = rows[(upper - 1) * width + column],
           high = rows[upper * width + column];
    *share = fmin(fmax((x - low) / (high - low), 0.0), 1.0);
    return upper;
}

double pp_interpolate_linear(const double (*rows)[2], int count, double x)
{
    double share;
    int upper = pp_interpolate_interval(&rows[0][0], count, 2, 0, x, &share);
    double low = rows[upper - 1][1], high = rows[upper][1];
    return low + share * (high - low);
}
