/* table.h - a text table with columns in groups, as wide as necessary. Groups that do
 * not fit on the line are printed in further panels below. */
#ifndef PP_REPORTS_PARTS_TABLE_H
#define PP_REPORTS_PARTS_TABLE_H

#include <stdbool.h>
#include <stdio.h>

enum { PP_CELL_BYTES = 64 };

struct pp_table_column {
    const char *group;       /* title of the column's group; not owned; equal pointers
                              * are the same group; NULL: a key column */
    const char *group_short; /* short title, used if `group` is wider than its
                              * columns */
    char heading[48];        /* may be broken before "+" or a blank, and after "-" */
    char (*cells)[PP_CELL_BYTES];
    int width;
    bool is_words; /* text, left-aligned; false: numbers, right-aligned */
};

struct pp_table {
    struct pp_table_column *columns;
    int column_count;
    int key_count; /* number of key columns: the first columns, repeated in every
                    * panel */
    int row_count;
    const char *last_label; /* label of the last row, instead of its keys, below a rule;
                             * NULL: the last row is an ordinary row */
};

void pp_table_init(struct pp_table *table, int row_count);
void pp_table_clear(struct pp_table *table);

/* Adds a column with empty cells. Columns of a group must be consecutive. The pointer
 * is valid until the next call. NULL: out of memory. */
struct pp_table_column *pp_table_add(struct pp_table *table, const char *group,
                                     const char *group_short, const char *heading);

/* Shortens the text of key columns in the middle ("south, l..winter"), the widest
 * column first, until the whole table fits lines of `width`. Cells that differ still
 * differ afterwards. Does nothing if the table cannot be made to fit. */
void pp_table_fit(struct pp_table *table, int width);

/* Prints the table, with each line indented by two. A line is wider than `width` only
 * if a single column is too wide. */
void pp_table_print(struct pp_table *table, int width, FILE *out);

#endif
