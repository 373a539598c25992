/* availability_sheet.h - how often daylight suffices, as it is printed and drawn.
 *
 * studies/climate/availability.h fills it; charts/availability_chart.h draws it.
 * Illuminances are in lx, shares of the working hours 0 to 1.
 */
#ifndef PP_MODEL_RESULTS_SHEETS_AVAILABILITY_SHEET_H
#define PP_MODEL_RESULTS_SHEETS_AVAILABILITY_SHEET_H

#include "model/results/report.h"

/* Source of the light outside. */
enum pp_light_origin {
    PP_LIGHT_ILLUMINANCE, /* diffuse illuminance of a weather file */
    PP_LIGHT_IRRADIANCE,  /* its diffuse irradiance, by a model of luminous efficacy */
    PP_LIGHT_OVERCAST,    /* an overcast sky, by the altitude of the sun */
};

enum { PP_PERIODS_MOST = 8, PP_ILLUMINANCES_MOST = 8 };

/* Working hours, and the cumulative curve of the light outside in them. */
struct pp_availability_period {
    char words[24];     /* "8:30-17" */
    double hours;       /* how many there are in the data */
    double missing_h;   /* further hours whose light is unknown */
    int count;          /* of the curve's points, 1 or more */
    double *lx, *share; /* falling illuminance, share of the hours that have as much;
                         * owned */
    double light;       /* share of the hours that have any */
    double half_lx;     /* illuminance in half of the hours, or more */
    double most_lx;     /* illuminance in 85 of 100 hours, or more */
};

/* Values of `place` other than the index of a receiver. */
enum { PP_PLACE_AVERAGE = -1, PP_PLACE_MEDIAN = -2 };

/* Share of time that one place has one illuminance, by one method's daylight factor. */
struct pp_availability_row {
    int place;                     /* a receiver, PP_PLACE_AVERAGE or PP_PLACE_MEDIAN */
    const char *method;            /* "exact+bre"; not owned */
    struct pp_reading df;          /* if it has no value, neither have the others */
    double lx;                     /* target on the working plane */
    double needs_lx;               /* outside: lx over df; INFINITY where df is 0 */
    double share[PP_PERIODS_MOST]; /* of each period's hours */
    double std_error[PP_PERIODS_MOST]; /* by that of df; NAN if it was not sampled */
};

struct pp_availability_sheet {
    const struct pp_report *report; /* NULL: the light outside alone; not owned */
    enum pp_light_origin origin;
    const char *light;    /* where and by which model, one sentence; not owned */
    const char *calendar; /* which days, which clock, one sentence; not owned */
    double median_lx;     /* of the brightest 4380 hours of the year; NAN: not known */
    int period_count;
    struct pp_availability_period periods[PP_PERIODS_MOST];
    int illuminance_count;
    double illuminances_lx[PP_ILLUMINANCES_MOST];
    int row_count;
    struct pp_availability_row *rows; /* by place, method, illuminance; owned */
};

void pp_availability_sheet_clear(struct pp_availability_sheet *sheet);

#endif
