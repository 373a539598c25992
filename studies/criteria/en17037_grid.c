#include "studies/criteria/en17037_grid.h"

#include <math.h>

double pp_en17037_spacing(double width_m, double depth_m)
{
    double longer = fmax(width_m, depth_m), shorter = fmin(width_m, depth_m);
    double d = longer >= 2.0 * shorter ? shorter : longer;
    return fmin(0.5 * pow(5.0, log10(d)), 10.0);
}
