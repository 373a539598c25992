/* comparison.h - the differences between hand methods and the simulation, in one room
 * and over several rooms.
 *
 * At the n points i of a room the difference is d_i = method - simulated; s_i is the
 * standard error of the simulated value:
 *
 *     bias    mean d_i; its standard error follows from the s_i and their correlation
 *             (common_error.h), and is sqrt(sum s_i^2) / n for independent errors
 *     spread  sqrt(max(0, mean d_i^2 - mean s_i^2)), the root mean square of d_i,
 *             corrected for the simulation's noise
 *     worst   the d_i of the largest magnitude
 *
 * The bias, and likewise the difference of the average, is the sum of two parts
 * (own_world.h). One is due to the method's assumption: the difference between the
 * simulated values in the method's own world and in the room. The other is due to its
 * formula: the difference between the method and the simulated value in its own world.
 *
 * Over several rooms differences are first divided by the room's mean simulated value,
 * so that dark rooms count as much as bright ones.
 */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_COMPARISON_H
#define PP_STUDIES_RESEARCH_VALIDATION_COMPARISON_H

#include "model/results/report.h"
#include "studies/research/validation/own_world.h"

/* The two parts of a difference; NAN: unknown. */
struct pp_error_parts {
    double assumption, assumption_error; /* own - traced, and its standard error */
    double formula, formula_error;       /* method - own, and its standard error */
};

/* Comparison of one column of a report with the simulated column of its component;
 * fractions of the open sky. */
struct pp_comparison {
    enum pp_component component;
    const char *name; /* name of the column in the report */
    const char *why;  /* reason if the method has no value at all; else NULL */
    int points;       /* number of points with both values; 0: only averages compare */
    double traced;    /* mean simulated value of those points */
    double bias, bias_error, spread;
    double worst, worst_error; /* d_i and s_i of the worst point */
    int worst_point;           /* index of the report's receiver */
    double average, traced_average, traced_average_error; /* NAN: none */
    bool own_world; /* true if the method's world differs from the room's world; if
                     * false, the assumption part is 0 */
    struct pp_error_parts of_bias, of_average; /* parts of the bias, and of average -
                                                * traced_average */
};

/* Compares each column of the report with the simulated column of its component;
 * worlds: the methods' own worlds, simulated. The caller frees *list; *count is 0 if
 * nothing was simulated. */
enum pp_status pp_comparison_of_report(struct pp_comparison **list, int *count,
                                       const struct pp_report *report,
                                       const struct pp_own_worlds *worlds,
                                       struct pp_error *err);

/* The two parts of a column's difference at one point of the report; point -1: of the
 * average. */
struct pp_error_parts pp_comparison_parts(const struct pp_report *report,
                                          const struct pp_column *column,
                                          const struct pp_own_worlds *worlds,
                                          int point);

/* Comparison of one method over several rooms. Differences are relative to the rooms'
 * mean simulated values. */
struct pp_overall {
    enum pp_component component;
    const char *name;
    int rooms, points; /* rooms with values at points, and all their points */
    double bias, spread;
    double worst;          /* the difference at the worst point of all rooms */
    int worst_room;        /* index of the room with the worst point */
    int averages;          /* rooms for which both the method and the simulation give an
                            * average */
    double average_bias;   /* mean of method/traced - 1 for these rooms' averages */
    double average_spread; /* root mean square of method/traced - 1 for these
                            * averages */
    double assumption, formula;                 /* parts of bias */
    double average_assumption, average_formula; /* parts of average_bias */
    bool own_world; /* true if the method's world differs from the room's world in some
                     * room */
    const struct pp_comparison *worst_comparison; /* comparison with the worst point;
                                                   * not owned */
};

/* Combines the comparisons of room_count rooms; rooms[i] contains counts[i]
 * comparisons. The caller frees *list. */
enum pp_status pp_comparison_overall(struct pp_overall **list, int *count,
                                     struct pp_comparison *const *rooms,
                                     const int *counts, int room_count,
                                     struct pp_error *err);

#endif
