/* atlas_table.h - a file of the atlas in memory: named columns of numbers.
 *
 * The file is CSV: comment lines (#), a line of names, and rows of numbers; an empty
 * field is NAN, but the columns of rooms and points contain whole numbers. The comment
 * "# sky iso, ..." marks rooms under the skies of ISO 15469. The file may still be
 * growing, or may have been cut off. A last line without a line end is therefore left
 * out, and so are the rows of a last room without an average (the row of point -1).
 */
#ifndef PP_STUDIES_RESEARCH_ATLAS_ATLAS_TABLE_H
#define PP_STUDIES_RESEARCH_ATLAS_ATLAS_TABLE_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"

struct pp_atlas_table {
    char **names;
    int column_count, row_count;
    double *values;  /* row after row */
    int room, point; /* columns with these names */
    bool iso;        /* rooms are under the skies of ISO 15469, not the overcast sky */
    char *text;      /* storage of the names */
};

/* PP_BAD_INPUT with the message "FILE:LINE: reason". The caller must clear *table in
 * any case. */
enum pp_status pp_atlas_table_read(struct pp_atlas_table *table, const char *path,
                                   struct pp_error *err);
void pp_atlas_table_clear(struct pp_atlas_table *table);

/* Index of the column with this name, or -1. */
int pp_atlas_table_find(const struct pp_atlas_table *table, const char *name);

/* Value of a row in a column; NAN for column -1. */
static inline double pp_atlas_table_value(const struct pp_atlas_table *table, int row,
                                          int column)
{
    return column < 0 ? NAN
                      : table->values[(size_t)row * (size_t)table->column_count
                                      + (size_t)column];
}

#endif
