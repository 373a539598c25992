/* atlas_columns.h - contents, order and names of the columns of an atlas.
 *
 *     room, point              indices from 0; the last row of a room has the point -1
 *                              and contains averages over its working plane
 *     x, y                     m; empty for the average
 *     features                 room_features.h, with the names given there
 *     true.C, se.C             simulated component C (sc, erc, irc, df) of the room as
 *                              it is, and its standard error
 *     C.METHOD                 result of a method or a pair: "df.exact+bre"
 *     own.df.METHOD            simulated value in the world that the method assumes
 *                              (studies/research/validation/own_world.h), daylight
 *                              factors only
 *
 * Components are in per cent of the open sky's horizontal illuminance; all values have
 * five significant digits. An empty field is a missing value.
 */
#ifndef PP_STUDIES_RESEARCH_ATLAS_ATLAS_COLUMNS_H
#define PP_STUDIES_RESEARCH_ATLAS_ATLAS_COLUMNS_H

#include <stdio.h>

#include "model/results/report.h"

enum { PP_ATLAS_NAME = 64 }; /* bytes of a column's name at most */

/* The columns of a report: component and method of each. A column of daylight factors
 * has a counterpart, simulated in the method's own world. */
struct pp_atlas_columns {
    int count;
    struct pp_atlas_method {
        enum pp_component component;
        char name[48];
    } * methods;
};

/* Lists the columns of a report; the result does not refer to the report. On success
 * the caller must clear *columns. */
enum pp_status pp_atlas_columns_of(struct pp_atlas_columns *columns,
                                   const struct pp_report *report,
                                   struct pp_error *err);
void pp_atlas_columns_clear(struct pp_atlas_columns *columns);

/* Writes the line of column names, with a line end. */
void pp_atlas_columns_print_names(const struct pp_atlas_columns *columns, FILE *out);

/* Simulated values of a row: fractions; NAN if a value is missing. */
struct pp_atlas_truth {
    double value[PP_COMPONENT_COUNT], std_error[PP_COMPONENT_COUNT]; /* of the room as
                                                                      * it is */
    double *own; /* daylight factor in each method's own world; only for columns of
                  * daylight factors */
};

/* Provides the simulated values of a row: for a point, or for the average if point is
 * -1. */
typedef void pp_atlas_truth_of(const void *data, int point,
                               struct pp_atlas_truth *truth);

/* Writes all rows of a room, from a report with the results of all methods. */
enum pp_status pp_atlas_columns_print_room(const struct pp_atlas_columns *columns,
                                           int room, const struct pp_report *report,
                                           pp_atlas_truth_of *truth_of,
                                           const void *data, FILE *out,
                                           struct pp_error *err);

#endif
