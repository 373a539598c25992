/* hunt_switching.c - see hunt_switching.h. */
#include "studies/lighting/hunt_switching.h"

#include <math.h>

double pp_hunt_switching_probability(double E)
{
    static const double a = -0.0175, b = -4.0835, c = 1.0361, m = 1.8223;
    static const double FROM = 0.843, TO = 2.818;
    double x = E > 0.0 ? log10(E) : -INFINITY;
    if (x <= FROM)
        return 1.0;
    if (x >= TO)
        return 0.0;
    double P = a + c / (1.0 + exp(-b * (x - m)));
    return fmax(0.0, fmin(1.0, P));
}
