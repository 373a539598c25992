/* obstruction_factor.c - see obstruction_factor.h. */
#include "methods/reflected/obstruction_factor.h"

#include "methods/interpolate.h"
#include "model/geometry/vec.h"

/* obstruction (degrees), C (per cent) */
static const double printed[][2] = {
#include "tables/bre_obstruction_factors.inc"
};

enum { ROWS = sizeof printed / sizeof printed[0] };

double pp_obstruction_factor(double angle_rad)
{
    return pp_interpolate_linear(printed, ROWS, angle_rad / PP_RAD) / 100.0;
}
