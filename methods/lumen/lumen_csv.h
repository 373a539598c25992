/* lumen_csv.h - reads a user's tables of coefficients of utilization from CSV files.
 *
 * Columns of a table for light from the side, in any order:
 *
 *     Ev_over_Eh (empty, "uniform" or "ground": light from the ground),
 *     [component (sky or ground),] [ceiling_reflectance, wall_reflectance,]
 *     depth_over_window_height, position_percent (empty: the average), then a column
 *     for each width over window height, ascending, "inf" last
 *
 * Columns of a table for light from above:
 *
 *     rcr, ceiling_reflectance, wall_reflectance, cu
 *
 * Lines that begin with # are comments.
 */
#ifndef PP_METHODS_LUMEN_LUMEN_CSV_H
#define PP_METHODS_LUMEN_LUMEN_CSV_H

#include <stddef.h>

#include "methods/lumen/lumen_table.h"
#include "model/base/mistakes.h"

/* Replaces a table by the file's table: the table for light from the side or from
 * above, depending on the columns. All mistakes are noted with their lines; the result
 * is then PP_BAD_INPUT, and the table is unchanged. An unreadable file is PP_BAD_INPUT
 * or PP_SYSTEM with a message. */
enum pp_status pp_lumen_csv_read(struct pp_lumen_table *table, const char *path,
                                 struct pp_mistakes *mistakes, struct pp_error *err);

/* As pp_lumen_csv_read, for the text of a file in memory. */
enum pp_status pp_lumen_csv_parse(struct pp_lumen_table *table, const char *text,
                                  size_t length, struct pp_mistakes *mistakes,
                                  struct pp_error *err);

#endif
