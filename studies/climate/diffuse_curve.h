/* diffuse_curve.h - how often the sky gives how much light in working hours: the
 * cumulative curve of the diffuse horizontal illuminance.
 */
#ifndef PP_STUDIES_CLIMATE_DIFFUSE_CURVE_H
#define PP_STUDIES_CLIMATE_DIFFUSE_CURVE_H

#include "studies/climate/working_hours.h"

/* Each value with the working hours that have it, or more. */
struct pp_diffuse_curve {
    int count;         /* of different values, 1 or more */
    double *lx;        /* falling; owned */
    double *reached_h; /* rising: hours with that much or more; owned */
    double total_h;    /* working hours for which the light is known */
    double missing_h;  /* and for which it is not */
};

/* PP_BAD_INPUT where no working hour has a known value. *curve is to be cleared. */
enum pp_status pp_diffuse_curve_create(struct pp_diffuse_curve *curve,
                                       const struct pp_diffuse_light *light,
                                       const struct pp_working_hours *hours,
                                       const struct pp_summer_time *summer,
                                       struct pp_error *err);
void pp_diffuse_curve_clear(struct pp_diffuse_curve *curve);

/* The share of the working hours in which the sky gives `lx` or more, 0 to 1; for 0 or
 * less: any light at all. Falls as lx rises. */
double pp_diffuse_curve_share(const struct pp_diffuse_curve *curve, double lx);

/* The illuminance (lx) that is there in that share of the working hours, 0 to 1, or in
 * more. */
double pp_diffuse_curve_lx(const struct pp_diffuse_curve *curve, double share);

#endif
