/* availability_sheet.h - how often daylight suffices, as printed and drawn.
 *
 * studies/climate/availability.h fills it; charts/availability_chart.h draws it.
 * Illuminances are in lx, shares of the working hours 0 to 1.
 */
#ifndef PP_MODEL_RESULTS_SHEETS_AVAILABILITY_SHEET_H
#define PP_MODEL_RESULTS_SHEETS_AVAILABILITY_SHEET_H

#include "model/results/report.h"

/* Source of the outdoor illuminances. */
enum pp_light_origin {
    PP_LIGHT_ILLUMINANCE, /* diffuse illuminance of a weather file */
    PP_LIGHT_IRRADIANCE,  /* diffuse irradiance of a weather file, with a luminous
                           * efficacy model */
    PP_LIGHT_OVERCAST,    /* overcast sky, from the sun's altitude */
};

enum { PP_PERIODS_MOST = 8, PP_ILLUMINANCES_MOST = 8 };

/* A working period, and the cumulative curve of its outdoor illuminances. */
struct pp_availability_period {
    char words[24];     /* "8:30-17" */
    double hours;       /* number of hours in the data */
    double missing_h;   /* further hours without data */
    int count;          /* points of the curve, 1 or more */
    double *lx, *share; /* descending illuminance, and share of hours that reach it;
                         * owned */
    double light;       /* share of hours with any light */
    double half_lx;     /* illuminance reached in half of the hours */
    double most_lx;     /* illuminance reached in 85 % of the hours */
};

/* Values of `place` that are not receiver indices. */
enum { PP_PLACE_AVERAGE = -1, PP_PLACE_MEDIAN = -2 };

/* Share of time that one place reaches one illuminance, by one method's daylight
 * factor. */
struct pp_availability_row {
    int place;                     /* receiver index, PP_PLACE_AVERAGE or
                                    * PP_PLACE_MEDIAN */
    const char *method;            /* "exact+bre"; not owned */
    struct pp_reading df;          /* if it has no value, needs_lx, share and
                                        * std_error are NAN */
    double lx;                     /* target on the working plane */
    double needs_lx;               /* outdoor illuminance: lx / df; INFINITY for 0 */
    double share[PP_PERIODS_MOST]; /* share of time, by period */
    double std_error[PP_PERIODS_MOST]; /* from the error of df; NAN: not sampled */
};

struct pp_availability_sheet {
    const struct pp_report *report; /* NULL: outdoor light only; not owned */
    enum pp_light_origin origin;
    const char *light;    /* place and model, one sentence; not owned */
    const char *calendar; /* days and clock, one sentence; not owned */
    double median_lx;     /* median of the 4380 brightest hours of the year; NAN:
                           * not known */
    int period_count;
    struct pp_availability_period periods[PP_PERIODS_MOST];
    int illuminance_count;
    double illuminances_lx[PP_ILLUMINANCES_MOST];
    int row_count;
    struct pp_availability_row *rows; /* by place, method, illuminance; owned */
};

void pp_availability_sheet_clear(struct pp_availability_sheet *sheet);

#endif
