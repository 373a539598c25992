/* comparison.h - how far each method is from the simulation, in one room and over
 * several.
 *
 * At the points i of a room the difference is d_i = method - traced, the traced value's
 * standard error s_i:
 *
 *     bias    mean d_i, with the standard error sqrt(sum s_i^2) / n
 *     spread  root mean square of d_i less what of it is the simulation's noise,
 *             sqrt(max(0, mean d_i^2 - mean s_i^2))
 *     worst   the d_i of the largest size
 *
 * Over several rooms differences are taken over the room's mean traced value first, so
 * that dark rooms count as much as bright ones.
 */
#ifndef PP_STUDIES_VALIDATION_COMPARISON_H
#define PP_STUDIES_VALIDATION_COMPARISON_H

#include "model/results/report.h"

/* One column of a report against "traced" of its component; fractions of the open sky.
 */
struct pp_comparison {
    enum pp_component component;
    const char *name; /* the report's */
    const char *why;  /* there is no value at all; NULL: there are some */
    int points;       /* with values of both; 0: see average alone */
    double traced;    /* their mean */
    double bias, bias_error, spread;
    double worst, worst_error; /* of one point */
    int worst_point;           /* of the report's receivers */
    double average, traced_average, traced_average_error; /* NAN: none */
};

/* The list is the caller's to free; *count 0 where nothing was traced. */
enum pp_status pp_comparison_of_report(struct pp_comparison **list, int *count,
                                       const struct pp_report *report,
                                       struct pp_error *err);

/* One method over several rooms; shares of the rooms' mean traced values. */
struct pp_overall {
    enum pp_component component;
    const char *name;
    int rooms, points; /* rooms with values at points */
    double bias, spread;
    double worst;          /* the difference of one point over its room's mean, */
    int worst_room;        /* by place in the list, */
    int averages;          /* rooms with an average of both */
    double average_bias;   /* mean of method/traced - 1, */
    double average_spread; /* its root mean square */
    const struct pp_comparison *worst_comparison; /* not owned */
};

/* rooms[i] has counts[i] comparisons. The list is the caller's to free. */
enum pp_status pp_comparison_overall(struct pp_overall **list, int *count,
                                     struct pp_comparison *const *rooms,
                                     const int *counts, int room_count,
                                     struct pp_error *err);

#endif
