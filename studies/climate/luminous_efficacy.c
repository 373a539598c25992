/* luminous_efficacy.c - equation (1) of luminous_efficacy.h [PISMS90]. Its coefficients
 * are columns of tables/perez_1993_all_weather.csv. */
#include "studies/climate/luminous_efficacy.h"

#include <math.h>

#include "model/geometry/vec.h"

/* Indices of columns: upper limit of the clearness bin; a of (1), which is followed by
 * b, c and d. */
enum { EPS_HIGH = 2, DIFFUSE = 27, COLUMNS = 39 };

static const double bins[][COLUMNS] = {
#include "tables/perez_1993_all_weather.inc"
};

double pp_luminous_efficacy_diffuse(double diffuse_w_m2, double direct_w_m2,
                                    double sun_zenith_rad, double sun_distance_au,
                                    double dew_point_c)
{
    double z = sun_zenith_rad, zenith_term = 1.041 * z * z * z;
    double clearness = ((diffuse_w_m2 + direct_w_m2) / diffuse_w_m2 + zenith_term)
                       / (1.0 + zenith_term);
    const double(*bin)[COLUMNS] = bins;
    while (clearness >= (*bin)[EPS_HIGH])
        bin++;

    double mass = 1.0 / (cos(z) + 0.15 * pow(93.885 - z / PP_RAD, -1.253));
    double outside = 1367.0 / (sun_distance_au * sun_distance_au);
    double brightness = diffuse_w_m2 * mass / outside;
    double water = exp(0.07 * dew_point_c - 0.075);

    const double *k = *bin + DIFFUSE;
    double efficacy = k[0] + k[1] * water + k[2] * cos(z) + k[3] * log(brightness);
    return fmin(fmax(efficacy, 60.0), 250.0);
}
