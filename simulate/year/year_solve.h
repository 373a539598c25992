/* year_solve.h - solves equation (2) of year_batch.h for the receivers of one
 * randomisation. */
#ifndef PP_SIMULATE_YEAR_YEAR_SOLVE_H
#define PP_SIMULATE_YEAR_YEAR_SOLVE_H

#include "simulate/year/sparse_rows.h"
#include "simulate/year/year_batch.h"

/* Kinds of rows; each exists for cells and for receivers. */
enum pp_year_rows {
    PP_YEAR_ROWS_D,
    PP_YEAR_ROWS_N,
    PP_YEAR_ROWS_G,
    PP_YEAR_ROWS_COUNT
};

/* Number of columns of D for each group: the columns of light, the outdoor cells, the
 * classes of light that leaves scattering panes and, last, the panes as emitters. */
int pp_year_solve_columns(const struct pp_year_task *task);

/* Fills light, outdoor, inside, classes and by_pane of the batch. of_cells, of_points:
 * by pp_year_rows. */
enum pp_status pp_year_solve(struct pp_year_batch *batch,
                             const struct pp_year_task *task,
                             const struct pp_sparse_rows of_cells[PP_YEAR_ROWS_COUNT],
                             const struct pp_sparse_rows of_points[PP_YEAR_ROWS_COUNT],
                             struct pp_error *err);

#endif
