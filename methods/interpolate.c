/* interpolate.c - Lagrange's cubic, Gauss's rule and bisection for tables of even
 * steps, and straight lines between the rows of published ones. */
#include "methods/interpolate.h"

#include <math.h>

double pp_interpolate_cubic(const double *values, int count, double low, double high,
                            double x)
{
    double place = (x - low) / (high - low) * (count - 1);
    place = fmin(fmax(place, 0.0), count - 1.0);
    int first = (int)place - 1;
    first = first < 0 ? 0 : first > count - 4 ? count - 4 : first;
    double t = place - first;
    const double *v = values + first;

    /* Lagrange's form with the entries at t = 0, 1, 2, 3. */
    double t1 = t - 1.0, t2 = t - 2.0, t3 = t - 3.0;
    return -v[0] * t1 * t2 * t3 / 6.0 + v[1] * t * t2 * t3 / 2.0
           - v[2] * t * t1 * t3 / 2.0 + v[3] * t * t1 * t2 / 6.0;
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
    /* The step that holds the value, then the place within that step. */
    int below = 0, above = count - 1;
    while (above - below > 1) {
        int middle = (below + above) / 2;
        if (values[middle] < value)
            below = middle;
        else
            above = middle;
    }
    double step = (high - low) / (count - 1);
    double left = low + below * step, right = low + above * step;
    while (right - left > 1e-10 * (high - low)) {
        double middle = (left + right) / 2.0;
        if (pp_interpolate_cubic(values, count, low, high, middle) < value)
            left = middle;
        else
            right = middle;
    }
    return (left + right) / 2.0;
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
