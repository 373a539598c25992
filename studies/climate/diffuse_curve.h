/* diffuse_curve.h - the share of working hours in which the sky gives an illuminance or
 * more: the cumulative curve of the diffuse horizontal illuminance [GEEBELEN]. */
#ifndef PP_STUDIES_CLIMATE_DIFFUSE_CURVE_H
#define PP_STUDIES_CLIMATE_DIFFUSE_CURVE_H

#include "studies/climate/working_hours.h"

/* Each illuminance of the year with the working hours that reach it. */
struct pp_diffuse_curve {
    int count;         /* number of different illuminances, 1 or more */
    double *lx;        /* the illuminances, falling; owned */
    double *reached_h; /* working hours with lx[i] or more, rising; owned */
    double total_h;    /* working hours whose illuminance is known */
    double missing_h;  /* working hours whose illuminance is not known */
};

/* PP_BAD_INPUT if no working hour has a known illuminance. On success the caller clears
 * *curve. */
enum pp_status pp_diffuse_curve_init(struct pp_diffuse_curve *curve,
                                     const struct pp_diffuse_light *light,
                                     const struct pp_working_hours *hours,
                                     const struct pp_summer_time *summer,
                                     struct pp_error *err);
void pp_diffuse_curve_clear(struct pp_diffuse_curve *curve);

/* Share of the working hours in which the sky gives `lx` or more, 0 to 1; with 0 or
 * less: the share with any light at all. Falls as lx rises. */
double pp_diffuse_curve_share(const struct pp_diffuse_curve *curve, double lx);

/* Largest illuminance (lx) that is reached in at least that share (0 to 1) of the
 * working hours. */
double pp_diffuse_curve_lx(const struct pp_diffuse_curve *curve, double share);

#endif
