/* diffuse_curve.h - cumulative curve of the diffuse horizontal illuminance: the
 * fraction of working hours in which the sky gives an illuminance or more
 * [GEEBELEN]. */
#ifndef PP_STUDIES_CLIMATE_DIFFUSE_CURVE_H
#define PP_STUDIES_CLIMATE_DIFFUSE_CURVE_H

#include "studies/climate/working_hours.h"

/* For each illuminance of the year, the working hours in which it is reached. */
struct pp_diffuse_curve {
    int count;         /* number of different illuminances, 1 or more */
    double *lx;        /* the illuminances, descending; owned */
    double *reached_h; /* working hours with lx[i] or more, ascending; owned */
    double total_h;    /* working hours whose illuminance is known */
    double missing_h;  /* working hours whose illuminance is not known */
};

/* Makes the curve. PP_BAD_INPUT if the illuminance is unknown in all working hours. On
 * success the caller clears *curve. */
enum pp_status pp_diffuse_curve_init(struct pp_diffuse_curve *curve,
                                     const struct pp_diffuse_light *light,
                                     const struct pp_working_hours *hours,
                                     const struct pp_summer_time *summer,
                                     struct pp_error *err);
void pp_diffuse_curve_clear(struct pp_diffuse_curve *curve);

/* Fraction (0 to 1) of the working hours in which the sky gives `lx` or more. lx of 0
 * or less: fraction with any light. The fraction decreases with lx. */
double pp_diffuse_curve_share(const struct pp_diffuse_curve *curve, double lx);

/* Greatest illuminance (lx) that is reached in at least that fraction (0 to 1) of the
 * working hours. */
double pp_diffuse_curve_lx(const struct pp_diffuse_curve *curve, double share);

#endif
