/* availability.h - fraction of the working hours in which daylight gives at least a
 * certain illuminance.
 *
 * With a daylight factor D, an illuminance E on the working plane requires an
 * illuminance Eh = E/D outside. The cumulative curve of the diffuse horizontal
 * illuminance in working hours gives the fraction of hours with Eh or more [GEEBELEN].
 * The daylight factor is assumed to be the same under all skies of the year. Sunlight
 * is not included.
 */
#ifndef PP_STUDIES_CLIMATE_AVAILABILITY_H
#define PP_STUDIES_CLIMATE_AVAILABILITY_H

#include "studies/climate/diffuse_curve.h"
#include "model/results/sheets/availability_sheet.h"

struct pp_availability_question {
    const struct pp_diffuse_light *light;
    const char *light_words, *calendar_words; /* descriptions for the sheet; not
                                               * owned */
    int period_count;                         /* 1 to PP_PERIODS_MOST */
    const struct pp_working_hours *periods;
    struct pp_summer_time summer;
    int illuminance_count; /* 0 to PP_ILLUMINANCES_MOST; at least 1 if there is a
                            * report */
    const double *illuminances_lx; /* each greater than 0 */
};

/* Returns E/D, the illuminance required outside (lx). lx > 0; daylight_factor >= 0;
 * INFINITY if it is 0. */
double pp_availability_needed_lx(double lx, double daylight_factor);

/* Fills the sheet with the curves. If report is not NULL, also adds the fraction of
 * each period in which the illuminances are reached at each place, from the daylight
 * factors of the report. Places are the points, their median if three or more have
 * values, and the average. The standard error of a fraction is half the difference
 * between the fractions for daylight factors one standard error higher and lower.
 * PP_BAD_INPUT if the illuminance is unknown in all hours of a period. The caller
 * clears *sheet, also after a failure. */
enum pp_status pp_availability_fill(struct pp_availability_sheet *sheet,
                                    const struct pp_availability_question *question,
                                    const struct pp_report *report,
                                    struct pp_error *err);

#endif
