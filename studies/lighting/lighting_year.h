/* lighting_year.h - use of electric light in a year, from the daylight in each record.
 *
 * Lamps are on only in occupied hours. A photoelectric control follows the daylight in
 * all hours, so that its state at arrival is known. With manual control, people arrive
 * at the first occupied moment of each day. They switch the light on with Hunt's
 * probability (hunt_switching.h), and off when they leave. The results are expected
 * values.
 */
#ifndef PP_STUDIES_LIGHTING_LIGHTING_YEAR_H
#define PP_STUDIES_LIGHTING_LIGHTING_YEAR_H

#include "model/results/sheets/annual_sheet.h"

/* Occupied hours of a year, and use of the lamps in them. */
struct pp_lighting_year {
    double occupied_h;
    double used_h; /* hours at full power that would use the same energy */
    double on_h;   /* hours with lamps on */
};

/* Calculates the use of lamps in a year. E: daylight at the control point in each
 * record (lx), ignored if the record is not known; fraction: is set to the mean
 * fraction of the installed power in each record; NULL: not needed. */
struct pp_lighting_year pp_lighting_year_of(const struct pp_lighting_control *control,
                                            const struct pp_annual_hour *hours,
                                            int hour_count, const float *E,
                                            float *fraction);

/* Number of consecutive records, beginning with `first`, that start in the same hour of
 * the clock. */
int pp_lighting_year_records_of_hour(const struct pp_annual_hour *hours, int hour_count,
                                     int first);

/* Replaces the value of each record by the mean of the known records in the same
 * hour. */
void pp_lighting_year_average_hours(float *E, const struct pp_annual_hour *hours,
                                    int hour_count);

#endif
