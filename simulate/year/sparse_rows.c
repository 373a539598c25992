/* sparse_rows.c - see sparse_rows.h. */
#include "simulate/year/sparse_rows.h"

#include <stdlib.h>

#include "model/base/array.h"

enum pp_status pp_sparse_rows_init(struct pp_sparse_rows *rows, int width,
                                   struct pp_error *err)
{
    *rows = (struct pp_sparse_rows){.width = width};
    rows->sums = calloc((size_t)width + 1, sizeof *rows->sums);
    rows->touched = calloc((size_t)width + 1, sizeof *rows->touched);
    rows->is_touched = calloc((size_t)width + 1, sizeof *rows->is_touched);
    if (!rows->sums || !rows->touched || !rows->is_touched)
        return pp_fail_memory(err);
    enum pp_status status = pp_array_reserve(&rows->first, &rows->first_capacity, 1,
                                             sizeof *rows->first, err);
    if (status == PP_OK)
        rows->first[0] = 0;
    return status;
}

void pp_sparse_rows_clear(struct pp_sparse_rows *rows)
{
    free(rows->first);
    free(rows->entries);
    free(rows->sums);
    free(rows->touched);
    free(rows->is_touched);
    *rows = (struct pp_sparse_rows){.count = 0};
}

void pp_sparse_rows_add(struct pp_sparse_rows *rows, int column, double value)
{
    if (!rows->is_touched[column]) {
        rows->is_touched[column] = 1;
        rows->touched[rows->touched_count++] = column;
    }
    rows->sums[column] += value;
}

static int compare_columns(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

enum pp_status pp_sparse_rows_end(struct pp_sparse_rows *rows, struct pp_error *err)
{
    int used = rows->first[rows->count], touched = rows->touched_count;
    enum pp_status status = pp_array_reserve(&rows->first, &rows->first_capacity,
                                             rows->count + 2, sizeof *rows->first, err);
    if (status == PP_OK)
        status = pp_array_reserve(&rows->entries, &rows->entry_capacity, used + touched,
                                  sizeof *rows->entries, err);
    if (status != PP_OK)
        return status;
    qsort(rows->touched, (size_t)touched, sizeof *rows->touched, compare_columns);
    for (int i = 0; i < touched; i++) {
        int column = rows->touched[i];
        rows->entries[used + i] =
            (struct pp_sparse_entry){column, (float)rows->sums[column]};
        rows->sums[column] = 0.0;
        rows->is_touched[column] = 0;
    }
    rows->touched_count = 0;
    rows->first[++rows->count] = used + touched;
    return PP_OK;
}
