/* lumen_table.h - coefficients of utilization of the lumen method: the program's own
 * tables, tables that a user has, and reading between their lines.
 *
 * Light from the side: one coefficient for each sky (by the ratio Ev/Eh of the open
 * sky's illuminance on the window to that on the ground; 0.396 is the CIE overcast sky)
 * and for light from the ground, by reflectances, room depth and width in window
 * heights, at the method's five positions and on average. Light from above: by room
 * cavity ratio and reflectances. Nothing is ever read outside a table's ranges.
 */
#ifndef PP_METHODS_LUMEN_LUMEN_TABLE_H
#define PP_METHODS_LUMEN_LUMEN_TABLE_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"
#include "model/base/mistakes.h"

enum {
    PP_LUMEN_AXIS_MOST = 24,
    PP_LUMEN_POSITIONS = 6, /* 10, 30, 50, 70, 90 % of the depth; the average */
    PP_LUMEN_AVERAGE = 5,
};

struct pp_lumen_axis {
    int count; /* 0: the table does not ask for it */
    double at[PP_LUMEN_AXIS_MOST];
};

enum pp_lumen_side_axis {
    PP_LUMEN_CEILING,
    PP_LUMEN_WALLS,
    PP_LUMEN_DEPTH, /* of the room, in window heights */
    PP_LUMEN_WIDTH, /* the same; INFINITY is allowed */
    PP_LUMEN_SIDE_AXES
};

struct pp_lumen_table; /* one for light from the side, one for light from above */

/* The program's own tables, made by bench/make_lumen_tables. On success *table is the
 * caller's. */
enum pp_status pp_lumen_table_create(struct pp_lumen_table **table,
                                     struct pp_error *err);
void pp_lumen_table_destroy(struct pp_lumen_table *table); /* NULL is allowed */

/* Puts the table of a CSV file in the place of the one for light from the side or from
 * above, as its columns say:
 *
 *     Ev_over_Eh (empty, "uniform" or "ground": light from the ground),
 *     [component (sky or ground),] [ceiling_reflectance, wall_reflectance,]
 *     depth_over_window_height, position_percent (empty: the average), then a column
 *     for each width over window height, ascending, "inf" last
 *
 *     rcr, ceiling_reflectance, wall_reflectance, cu
 *
 * Lines that begin with # are comments. All mistakes are noted with their lines; then
 * PP_BAD_INPUT, and the table is as it was. A file that can't be read is PP_BAD_INPUT
 * or PP_SYSTEM with a message. */
enum pp_status pp_lumen_csv_read(struct pp_lumen_table *table, const char *path,
                                 struct pp_mistakes *mistakes, struct pp_error *err);

/* The same of a file's text. */
enum pp_status pp_lumen_csv_parse(struct pp_lumen_table *table, const char *text,
                                  size_t length, struct pp_mistakes *mistakes,
                                  struct pp_error *err);

/* What to read: ev_over_eh of the sky, NAN for the ground; overcast: of the table for
 * Ev/Eh below 0.45, whatever ev_over_eh is, else of those from 0.45 on. */
struct pp_lumen_query {
    double ev_over_eh;
    bool overcast;
    double at[PP_LUMEN_SIDE_AXES];
};

/* The coefficients at the five positions and the average: between neighbouring lines
 * linear in Ev/Eh and in the reflectances, geometric in depth and in the reciprocal of
 * the width. Against the rooms themselves, half-way between lines, that is good to 8 %.
 * A table without averages gives the mean of its five positions. False, with the reason
 * in `why` as the end of a sentence that begins with an opening, where the table does
 * not reach. */
bool pp_lumen_table_side(double cu[PP_LUMEN_POSITIONS],
                         const struct pp_lumen_table *table,
                         const struct pp_lumen_query *query, char *why, size_t room);

/* At a share of the depth from the window, 0.1 to 0.9: geometric between positions. */
double pp_lumen_table_at_depth(const double cu[PP_LUMEN_POSITIONS], double share);

/* The coefficient for light from above, linear between neighbouring lines; NAN with the
 * reason as above where the table does not reach. */
double pp_lumen_table_top(const struct pp_lumen_table *table, double rcr,
                          double ceiling, double walls, char *why, size_t room);

#endif
