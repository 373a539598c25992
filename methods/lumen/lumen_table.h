/* lumen_table.h - coefficients of utilization of the lumen method [IES84]: the
 * program's tables, and interpolation in these or in a user's tables (lumen_csv.h).
 *
 * Light from the side has coefficients for each sky and for light from the ground. A
 * sky is given by Ev/Eh, the ratio of its illuminance on the window to that on the
 * ground, without obstructions (0.396: CIE overcast sky). The coefficients depend on
 * the reflectances and on the room's depth and width in window heights. The tables have
 * coefficients for the method's five positions and the average. Coefficients for light
 * from above depend on the room cavity ratio and the reflectances. There is no
 * extrapolation.
 */
#ifndef PP_METHODS_LUMEN_LUMEN_TABLE_H
#define PP_METHODS_LUMEN_LUMEN_TABLE_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"

enum {
    PP_LUMEN_AXIS_MOST = 24,
    PP_LUMEN_POSITIONS = 6, /* 10, 30, 50, 70, 90 % of the depth; the average */
    PP_LUMEN_AVERAGE = 5,
};

struct pp_lumen_axis {
    int count; /* 0: the table has no such axis */
    double at[PP_LUMEN_AXIS_MOST];
};

enum pp_lumen_side_axis {
    PP_LUMEN_CEILING,
    PP_LUMEN_WALLS,
    PP_LUMEN_DEPTH, /* depth of the room, in window heights */
    PP_LUMEN_WIDTH, /* width of the room, in window heights; INFINITY is allowed */
    PP_LUMEN_SIDE_AXES
};

struct pp_lumen_table; /* for light from the side and for light from above */

/* The program's own tables, made by bench/make_lumen_tables. On success the caller
 * destroys *table. */
enum pp_status pp_lumen_table_create(struct pp_lumen_table **table,
                                     struct pp_error *err);
void pp_lumen_table_destroy(struct pp_lumen_table *table); /* NULL is allowed */

/* Arguments of a reading from the side table. ev_over_eh: ratio of the sky, NAN for the
 * ground. For an overcast sky the table with Ev/Eh below 0.45 is read, whatever
 * ev_over_eh is; for any other sky, the tables with Ev/Eh of 0.45 and more. */
struct pp_lumen_query {
    double ev_over_eh;
    bool overcast;
    double at[PP_LUMEN_SIDE_AXES];
};

/* Coefficients at the five positions and the average, interpolated between neighbouring
 * lines: linearly in Ev/Eh and in the reflectances, geometrically in depth and in the
 * reciprocal of the width. Half-way between lines, the result agrees to 8 % with flux
 * transfer calculated for the room itself (lumen_room.h). If the table has no averages,
 * the average is the mean of the five positions. Returns false outside the table's
 * range, or if the table has no coefficients for that light. The reason is then in
 * `why`, as the end of a sentence that begins with an opening. */
bool pp_lumen_table_side(double cu[PP_LUMEN_POSITIONS],
                         const struct pp_lumen_table *table,
                         const struct pp_lumen_query *query, char *why, size_t room);

/* The coefficient at a fraction of the depth from the window, 0.1 to 0.9, interpolated
 * geometrically between the five positions. */
double pp_lumen_table_at_depth(const double cu[PP_LUMEN_POSITIONS], double share);

/* The coefficient for light from above, interpolated linearly between neighbouring
 * lines. Outside the table's range NAN, with the reason in `why`. */
double pp_lumen_table_top(const struct pp_lumen_table *table, double rcr,
                          double ceiling, double walls, char *why, size_t room);

#endif
