/* year_metrics.h - figures of one point from its illuminances in the hours of a year.
 *
 * Occupied hours include those after dark. Useful daylight illuminance after
 * Mardaljevic: below 100, 100 to 300, 300 to 3000 (both included), above 3000 lx. The
 * median is the one of EN 17037, method 2: the illuminance reached in 2190 of the 4380
 * hours with the highest diffuse horizontal illuminance. Direct sun counts if it is
 * above 1000 lx [LM83].
 */
#ifndef PP_STUDIES_YEAR_YEAR_METRICS_H
#define PP_STUDIES_YEAR_YEAR_METRICS_H

#include "model/results/sheets/annual_sheet.h"
#include "studies/climate/working_hours.h"
#include "studies/year/weather_year.h"

/* Data on the hours of a year from which the figures are calculated. Arrays are indexed
 * by sky. */
struct pp_year_clock {
    int sky_count;
    double *occupied_h, *length_h;
    bool *is_daylight;     /* true in the 4380 brightest hours */
    double all_occupied_h; /* hours of darkness included */
    int median_rank;       /* rank of the median among the daylight values, in
                            * descending order; it may exceed the number of values */
    double diffuse_median_lx;
};

/* PP_BAD_INPUT if no hour is occupied. On success the caller clears *clock. */
enum pp_status pp_year_clock_init(struct pp_year_clock *clock,
                                  const struct pp_weather_year *year,
                                  const struct pp_working_hours *hours,
                                  const struct pp_summer_time *summer,
                                  struct pp_error *err);
void pp_year_clock_clear(struct pp_year_clock *clock);

/* Illuminances of a point (lx). Arrays are indexed by sky. */
struct pp_year_values {
    const float *open;                      /* all light, without blinds */
    const float *sky, *sun, *sun_reflected; /* parts of `open` */
    const float *blinds; /* all light, with blinds; NULL: no blinds */
    float *space;        /* scratch of the same size, for the median */
};

/* Fills the values of *figures, not their standard errors. */
void pp_year_metrics_of(struct pp_annual_figures *figures,
                        const struct pp_year_values *values,
                        const struct pp_year_clock *clock,
                        const double *illuminances_lx, int illuminance_count);

/* Standard error of a figure from its values with each of `count` batches left out
 * (jackknife): sqrt((n - 1)/n sum (x - mean)^2). */
double pp_year_metrics_error(const double *without, int count);

#endif
