/* broken_line.c - see broken_line.h. */
#include "methods/broken_line.h"

#include <math.h>

int pp_broken_line_place(const double *rows, int count, int width, int column, double x,
                         double *share)
{
    int upper = 1;
    while (upper < count - 1 && x > rows[upper * width + column])
        upper++;
    double low = rows[(upper - 1) * width + column],
           high = rows[upper * width + column];
    *share = fmin(fmax((x - low) / (high - low), 0.0), 1.0);
    return upper;
}

double pp_broken_line(const double (*rows)[2], int count, double x)
{
    double share;
    int upper = pp_broken_line_place(&rows[0][0], count, 2, 0, x, &share);
    double low = rows[upper - 1][1], high = rows[upper][1];
    return low + share * (high - low);
}
