/* window_schedule.h - the schedule of a planning report: one line for each window with
 * its sky, its sunlight and the lit area of its room, existing and proposed. */
#ifndef PP_STUDIES_CRITERIA_WINDOWS_WINDOW_SCHEDULE_H
#define PP_STUDIES_CRITERIA_WINDOWS_WINDOW_SCHEDULE_H

#include "studies/criteria/assessment.h"

/* Fractions, or m2 for an area; NAN: not known. */
struct pp_schedule_change {
    double existing, proposed, cumulative;
};

/* Fraction of the existing value that is lost (negative: gained), and the ratio of
 * proposed to existing value. */
double pp_schedule_loss(struct pp_schedule_change change);
double pp_schedule_ratio(struct pp_schedule_change change);

enum { PP_SCHEDULE_CHANGES = 5 };
enum pp_schedule_quantity {
    PP_SCHEDULE_SKY,    /* vertical sky component */
    PP_SCHEDULE_YEAR,   /* share of sunlight hours in the year */
    PP_SCHEDULE_WINTER, /* share of these hours in winter */
    PP_SCHEDULE_AREA,   /* area of the window's room with a view of the sky, m2 */
    PP_SCHEDULE_BARE    /* vertical sky component without the overhangs and balconies of
                         * the building itself; unknown if there are none */
};

/* Factor from a stored value to the unit of the quantity's title. */
double pp_schedule_scale(enum pp_schedule_quantity quantity);

struct pp_schedule_row {
    const struct pp_assessment *room; /* not owned */
    const char *window;               /* label of the window, a string of the room's
                                       * world */
    double level_m;                   /* level of the room's floor in its building */
    struct pp_schedule_change changes[PP_SCHEDULE_CHANGES];
    enum pp_verdict verdict; /* verdict on the sky, by [BR209]; PP_NOT_JUDGED without
                              * one */
};

struct pp_window_schedule {
    struct pp_schedule_row *rows;
    int count;
    bool has_cumulative; /* true: the site has a cumulative state */
    bool probable; /* true: sunlight hours are probable ones; false: possible ones */
};

/* A line for each window whose sky or sunlight was assessed, in the order of rooms; new
 * rooms are last. The caller clears the schedule, even after a failure. */
enum pp_status pp_window_schedule_of(struct pp_window_schedule *schedule,
                                     const struct pp_assessment *rooms, int count,
                                     struct pp_error *err);
void pp_window_schedule_clear(struct pp_window_schedule *schedule);

/* Title of a quantity with its unit: "vertical sky component, %", "probable annual
 * sunlight hours, %". */
enum { PP_SCHEDULE_TITLE = 96 };
void pp_window_schedule_title(char title[PP_SCHEDULE_TITLE],
                              const struct pp_window_schedule *schedule,
                              enum pp_schedule_quantity quantity);

#endif
