/* availability.h - share of the working hours in which daylight gives an illuminance.
 *
 * With a daylight factor D, an illuminance E on the working plane needs an illuminance
 * Eh = E/D outside. The cumulative curve of the diffuse horizontal illuminance in the
 * working hours gives the share of hours with Eh or more [GEEBELEN]. The daylight
 * factor is assumed constant through the year, whatever the sky; sunlight is left out.
 */
#ifndef PP_STUDIES_CLIMATE_AVAILABILITY_H
#define PP_STUDIES_CLIMATE_AVAILABILITY_H

#include "studies/climate/diffuse_curve.h"
#include "model/results/sheets/availability_sheet.h"

struct pp_availability_question {
    const struct pp_diffuse_light *light;
    const char *light_words, *calendar_words; /* for the sheet; not owned */
    int period_count;                         /* 1 to PP_PERIODS_MOST */
    const struct pp_working_hours *periods;
    struct pp_summer_time summer;
    int illuminance_count; /* 0 to PP_ILLUMINANCES_MOST; with a report 1 or more */
    const double *illuminances_lx; /* each greater than 0 */
};

/* E/D, both greater than 0; INFINITY for D of 0. */
double pp_availability_needed_lx(double lx, double daylight_factor);

/* Fills the sheet with the curves and, from the report's daylight factors (report may
 * be NULL), with the share of each period in which each place has each illuminance.
 * Places are the report's points, their median where three or more have values, and the
 * average. A share's standard error is half the difference between the shares at one
 * standard error of the daylight factor up and down. PP_BAD_INPUT if a period has no
 * hour whose light is known. *sheet is to be cleared by the caller, in any case. */
enum pp_status pp_availability_fill(struct pp_availability_sheet *sheet,
                                    const struct pp_availability_question *question,
                                    const struct pp_report *report,
                                    struct pp_error *err);

#endif
