/* monthly_suns.h - statistics of a weather file for each month and hour of the day: the
 * mean position of the sun, the fraction of sunny hours, and the mean illuminances of
 * sunny and of other hours. */
#ifndef PP_STUDIES_YEAR_HAND_MONTHLY_SUNS_H
#define PP_STUDIES_YEAR_HAND_MONTHLY_SUNS_H

#include "studies/year/hand/hand_case.h"

enum { PP_MONTHLY_SUNS_HOURS = 24, PP_MONTHLY_SUNS = 12 * PP_MONTHLY_SUNS_HOURS };

struct pp_monthly_sun {
    double hours, sunny_h; /* hours with daylight, and hours of these with sunshine */
    bool is_up;            /* true: the sun is above the horizon in some of the hours */
    struct pp_vec3 sun;    /* unit: mean direction over the hours with the sun up */
    double sunny_diffuse_lx, sunny_direct_lx; /* means over sunny hours; 0: none */
    double dull_diffuse_lx;                   /* mean over hours without sunshine; 0:
                                               * none */
};

struct pp_monthly_suns {
    struct pp_monthly_sun list[PP_MONTHLY_SUNS]; /* by pp_monthly_suns_index */
};

void pp_monthly_suns_fill(struct pp_monthly_suns *suns, const struct pp_hand_case *of);

/* Index of an hour: month, from 0, times PP_MONTHLY_SUNS_HOURS plus hour of the day. */
int pp_monthly_suns_index(const struct pp_hand_hour *hour);

#endif
