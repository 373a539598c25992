/* point_areas.c - see point_areas.h. */
#include "model/results/sheets/point_areas.h"

#include <math.h>

double pp_point_areas_sum(const struct pp_receiver *receivers, int count)
{
    double sum = 0.0;
    for (int i = 0; i < count; i++) {
        if (!receivers || !(receivers[i].area_m2 > 0.0))
            return NAN;
        sum += receivers[i].area_m2;
    }
    return sum;
}

bool pp_point_areas_differ(const struct pp_receiver *receivers, int count)
{
    if (isnan(pp_point_areas_sum(receivers, count)))
        return false;
    for (int i = 1; i < count; i++)
        if (fabs(receivers[i].area_m2 / receivers[0].area_m2 - 1.0) > 1e-9)
            return true;
    return false;
}

double pp_point_areas_weight(const struct pp_receiver *receivers, double sum, int index)
{
    return isnan(sum) ? 1.0 : receivers[index].area_m2 / receivers[0].area_m2;
}

double pp_point_areas_whole(const struct pp_receiver *receivers, int count)
{
    double area_m2 = pp_point_areas_sum(receivers, count), whole = 0.0;
    for (int i = 0; i < count; i++)
        whole += pp_point_areas_weight(receivers, area_m2, i);
    return whole;
}

double pp_point_areas_share(const struct pp_receiver *receivers, int count, double sum,
                            int index)
{
    return isnan(sum) ? 1.0 / count : receivers[index].area_m2 / sum;
}
