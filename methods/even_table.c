/* even_table.c - see even_table.h. */
#include "methods/even_table.h"

#include <math.h>

double pp_even_table(const double *values, int count, double low, double high, double x)
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
