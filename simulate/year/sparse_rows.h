/* sparse_rows.h - rows of a matrix that are mostly zero, filled one after the other. */
#ifndef PP_SIMULATE_YEAR_SPARSE_ROWS_H
#define PP_SIMULATE_YEAR_SPARSE_ROWS_H

#include "model/base/error.h"

struct pp_sparse_entry {
    int column;
    float value;
};

struct pp_sparse_rows {
    int count;  /* number of completed rows */
    int *first; /* entries of row i: first[i] to first[i + 1] - 1 */
    struct pp_sparse_entry *entries; /* in ascending order of column within a row */
    int first_capacity, entry_capacity, width;
    double *sums; /* sums of the row being filled, by column */
    int *touched, touched_count;
    unsigned char *is_touched;
};

/* Columns are 0 to width - 1. The caller must clear *rows, even after a failure. */
enum pp_status pp_sparse_rows_init(struct pp_sparse_rows *rows, int width,
                                   struct pp_error *err);
void pp_sparse_rows_clear(struct pp_sparse_rows *rows);

/* pp_sparse_rows_add adds to a value of the row being filled; pp_sparse_rows_end
 * completes that row. */
void pp_sparse_rows_add(struct pp_sparse_rows *rows, int column, double value);
enum pp_status pp_sparse_rows_end(struct pp_sparse_rows *rows, struct pp_error *err);

#endif
