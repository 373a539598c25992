/* monthly_suns.c - see monthly_suns.h. */
#include "studies/year/hand/monthly_suns.h"

#include <string.h>

int pp_monthly_suns_index(const struct pp_hand_hour *hour)
{
    int clock = (int)hour->start_h;
    clock = clock < PP_MONTHLY_SUNS_HOURS ? clock : PP_MONTHLY_SUNS_HOURS - 1;
    return (hour->date.month - 1) * PP_MONTHLY_SUNS_HOURS + clock;
}

void pp_monthly_suns_fill(struct pp_monthly_suns *suns, const struct pp_hand_case *of)
{
    struct pp_monthly_sun *list = suns->list;
    memset(suns, 0, sizeof *suns);
    for (int i = 0; i < of->hour_count; i++) {
        const struct pp_hand_hour *hour = &of->hours[i];
        struct pp_monthly_sun *sun = &list[pp_monthly_suns_index(hour)];
        double length_h = hour->length_h;
        sun->hours += length_h;
        if (hour->sunny) {
            sun->sunny_h += length_h;
            sun->sunny_diffuse_lx += length_h * hour->diffuse_lx;
            sun->sunny_direct_lx += length_h * hour->direct_lx;
        } else {
            sun->dull_diffuse_lx += length_h * hour->diffuse_lx;
        }
        if (hour->sun.z > 0.0)
            sun->sun = pp_vec_add(sun->sun, pp_vec_scale(hour->sun, length_h));
    }
    for (int i = 0; i < PP_MONTHLY_SUNS; i++) {
        struct pp_monthly_sun *sun = &list[i];
        double dull_h = sun->hours - sun->sunny_h;
        sun->is_up = sun->sun.z > 0.0;
        if (sun->is_up)
            sun->sun = pp_vec_unit(sun->sun);
        if (sun->sunny_h > 0.0) {
            sun->sunny_diffuse_lx /= sun->sunny_h;
            sun->sunny_direct_lx /= sun->sunny_h;
        }
        if (dull_h > 1e-9)
            sun->dull_diffuse_lx /= dull_h;
    }
}
