/* lighting_year.h - use of electric light in a year, from the daylight in each record.
 *
 * Lamps are on in occupied hours only. A photoelectric control follows the daylight in
 * all hours, so that its state at arrival is known. Under the manual control, people
 * arrive at the first occupied moment of each day, switch the light on with Hunt's
 * probability (hunt_switching.h), and off when they leave; the results are expected
 * values.
 */
#ifndef PP_STUDIES_LIGHTING_LIGHTING_YEAR_H
#define PP_STUDIES_LIGHTING_LIGHTING_YEAR_H

#include "model/results/sheets/annual_sheet.h"

/* Hours of a year, occupied. */
struct pp_lighting_year {
    double occupied_h;
    double used_h; /* hours at full power with the same energy */
    double on_h;   /* hours with lamps on */
};

/* E: daylight at the control point in each record (lx); ignored for records that are not
 * known. fraction: receives the mean share of the installed power in each record; NULL:
 * not needed. */
struct pp_lighting_year pp_lighting_year_of(const struct pp_lighting_control *control,
                                            const struct pp_annual_hour *hours,
                                            int hour_count, const float *E,
                                            float *fraction);

/* Number of records, from `first` on, within the same hour of the clock. */
int pp_lighting_year_records_of_hour(const struct pp_annual_hour *hours, int hour_count,
                                     int first);

/* Replaces values of records by the means of the known records of the same hour. */
void pp_lighting_year_average_hours(float *E, const struct pp_annual_hour *hours,
                                    int hour_count);

#endif
