/* table.h - a table of text for people: columns in groups, as wide as they need to be,
 * side by side as far as the line goes and then in a further panel below.
 */
#ifndef PP_REPORTS_PARTS_TABLE_H
#define PP_REPORTS_PARTS_TABLE_H

#include <stdbool.h>
#include <stdio.h>

enum { PP_CELL_BYTES = 64 };

struct pp_table_column {
    const char *group; /* not owned; the same pointer is the same group; NULL: keys */
    const char *group_short; /* where `group` is wider than its columns */
    char heading[48];        /* broken before "+" and behind "-" to be narrow */
    char (*cells)[PP_CELL_BYTES];
    int width;
    bool is_words; /* to the left; numbers are to the right */
};

struct pp_table {
    struct pp_table_column *columns;
    int column_count;
    int key_count; /* columns at the start that every panel repeats */
    int row_count;
    const char *last_label; /* replaces the keys of the last row, below a rule; NULL:
                             * the last row is like the others */
};

void pp_table_init(struct pp_table *table, int row_count);
void pp_table_clear(struct pp_table *table);

/* A new column with empty cells; NULL when memory is out. Columns of a group follow one
 * another. The pointer is good until the next call. */
struct pp_table_column *pp_table_add(struct pp_table *table, const char *group,
                                     const char *group_short, const char *heading);

/* Shortens the words of keys in their middle ("south, l..winter"), the widest first, so
 * that all of the table stands side by side on lines of `width`; cells that differ do so
 * still. Nothing is done to a table that cannot be made to fit so. */
void pp_table_fit(struct pp_table *table, int width);

/* Prints it, each line indented by two; no line is wider than `width` unless a single
 * group is. */
void pp_table_print(struct pp_table *table, int width, FILE *out);

#endif
