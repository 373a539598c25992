/* table.h - a table of text: columns in groups, as wide as needed. Groups that do not
 * fit on the line are printed in further panels below. */
#ifndef PP_REPORTS_PARTS_TABLE_H
#define PP_REPORTS_PARTS_TABLE_H

#include <stdbool.h>
#include <stdio.h>

enum { PP_CELL_BYTES = 64 };

struct pp_table_column {
    const char *group;       /* not owned; equal pointers are one group; NULL: keys */
    const char *group_short; /* used if `group` is wider than its columns */
    char heading[48];        /* may be broken before "+" and after "-" */
    char (*cells)[PP_CELL_BYTES];
    int width;
    bool is_words; /* left-aligned; numbers are right-aligned */
};

struct pp_table {
    struct pp_table_column *columns;
    int column_count;
    int key_count; /* columns at the start that every panel repeats */
    int row_count;
    const char *last_label; /* replaces the keys of the last row, below a rule; NULL:
                             * the last row is an ordinary one */
};

void pp_table_init(struct pp_table *table, int row_count);
void pp_table_clear(struct pp_table *table);

/* Adds a column with empty cells; NULL: out of memory. Columns of a group must be
 * consecutive. The pointer is valid until the next call. */
struct pp_table_column *pp_table_add(struct pp_table *table, const char *group,
                                     const char *group_short, const char *heading);

/* Shortens the words of keys in their middle ("south, l..winter"), the widest first, so
 * that the whole table fits lines of `width`; different cells remain different. Does
 * nothing if the table cannot be made to fit. */
void pp_table_fit(struct pp_table *table, int width);

/* Prints the table, each line indented by two; no line is wider than `width` unless a
 * single group is. */
void pp_table_print(struct pp_table *table, int width, FILE *out);

#endif
