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

struct pp_lit_change pp_lit_area_change(double plane_m2, double before_m2,
                                        double now_m2)
{
    struct pp_lit_change change = {.plane_m2 = plane_m2,
                                   .lit_m2 = now_m2,
                                   .before_m2 = before_m2,
                                   .lost_m2 = before_m2 - now_m2};
    if (!isnan(before_m2))
        change.loss = pp_lit_area_loss(plane_m2, before_m2, now_m2);
    for (int i = 0; i < PP_ZONE_COUNT && isnan(before_m2); i++)
        change.loss.zones_m2[i] = NAN;
    if (isnan(before_m2))
        change.loss.equivalent_m2 = NAN;
    return change;
}

static void add_compensated(double *sum, double value)
{
    if (!isnan(value))
        *sum = isnan(*sum) ? value : *sum + value;
}

void pp_lit_area_add(struct pp_lit_change *sum, const struct pp_lit_change *room)
{
    add_compensated(&sum->plane_m2, room->plane_m2);
    add_compensated(&sum->lit_m2, room->lit_m2);
    add_compensated(&sum->before_m2, room->before_m2);
    add_compensated(&sum->lost_m2, room->lost_m2);
    for (int i = 0; i < PP_ZONE_COUNT; i++)
        add_compensated(&sum->loss.zones_m2[i], room->loss.zones_m2[i]);
    add_compensated(&sum->loss.equivalent_m2, room->loss.equivalent_m2);
}

const char *pp_lit_area_zone_name(enum pp_lit_zone zone)
{
    static const char *const names[] = {[PP_ZONE_FRONT] = "front zone",
                                        [PP_ZONE_FIRST] = "first zone",
                                        [PP_ZONE_SECOND] = "second zone",
                                        [PP_ZONE_MAKEWEIGHT] = "makeweight"};
    return names[zone];
}
