/* lit_area.c - see lit_area.h. */
#include "model/results/lit_area.h"

#include <math.h>

void pp_lit_area_clear(struct pp_lit_area *area)
{
    pp_region_clear(&area->plane);
    pp_curve_list_clear(&area->line);
    pp_curve_list_clear(&area->dark);
    *area = (struct pp_lit_area){0};
}

struct pp_lit_loss pp_lit_area_loss(double plane_m2, double before_m2, double now_m2)
{
    static const double weights[PP_ZONE_COUNT] = {1.5, 1.0, 0.5, 0.25};
    struct pp_lit_loss loss = {0};
    for (int i = 0; i < PP_ZONE_COUNT; i++) {
        double low = plane_m2 * i / PP_ZONE_COUNT;
        double high = plane_m2 * (i + 1) / PP_ZONE_COUNT;
        loss.zones_m2[i] = fmax(fmin(before_m2, high) - fmax(now_m2, low), 0.0);
        loss.equivalent_m2 += weights[i] * loss.zones_m2[i];
    }
    return loss;
}

const char *pp_lit_area_zone_name(enum pp_lit_zone zone)
{
    static const char *const names[] = {[PP_ZONE_FRONT] = "front zone",
                                        [PP_ZONE_FIRST] = "first zone",
                                        [PP_ZONE_SECOND] = "second zone",
                                        [PP_ZONE_MAKEWEIGHT] = "makeweight"};
    return names[zone];
}
