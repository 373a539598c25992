/* obstruction_factor.c - see obstruction_factor.h. */
#include "methods/obstruction_factor.h"

#include <math.h>

#include "model/vec.h"

/* obstruction (degrees), C (per cent) */
static const double printed[][2] = {
#include "tables/bre_obstruction_factors.inc"
};

enum { ROWS = sizeof printed / sizeof printed[0] };

double pp_obstruction_factor(double angle_rad)
{
    double angle_deg = fmax(angle_rad / PP_RAD, printed[0][0]);
    for (int i = 1; i < ROWS; i++) {
        const double *low = printed[i - 1], *high = printed[i];
        if (angle_deg <= high[0]) {
            double t = (angle_deg - low[0]) / (high[0] - low[0]);
            return (low[1] + t * (high[1] - low[1])) / 100.0;
        }
    }
    return printed[ROWS - 1][1] / 100.0;
}
