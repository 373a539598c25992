/* year_solve.c - sums V of equation (2) term by term, for a block of receivers at once:
 * V = G_x + G_x G + ... */
#include "simulate/year/year_solve.h"

#include <stdlib.h>
#include <string.h>

#include "simulate/sampling/lanes.h"

int pp_year_solve_columns(const struct pp_year_task *task)
{
    return task->column_count + PP_YEAR_OUTDOOR_CELLS + task->class_count + 1;
}

enum { BLOCK = 8, TERMS_MOST = 400 };
static const double LAST_TERM = 1e-5; /* the series ends with the first term below
                                       * this fraction of the sum */

typedef float block_row[BLOCK];
typedef float block_lanes __attribute__((vector_size(sizeof(block_row))));

PP_LANES_BODY void add_products(block_row *sum, const block_row *factor, int count,
                                const struct pp_sparse_rows *rows)
{
    for (int c = 0; c < count; c++) {
        block_lanes of_row, to;
        __builtin_memcpy(&of_row, factor[c], sizeof of_row);
        for (int k = rows->first[c]; k < rows->first[c + 1]; k++) {
            float *at = sum[rows->entries[k].column];
            __builtin_memcpy(&to, at, sizeof to);
            to += of_row * rows->entries[k].value;
            __builtin_memcpy(at, &to, sizeof to);
        }
    }
}

static void narrow_products(block_row *sum, const block_row *factor, int count,
                            const struct pp_sparse_rows *rows)
{
    add_products(sum, factor, count, rows);
}

PP_LANES_WIDE static void wide_products(block_row *sum, const block_row *factor,
                                        int count, const struct pp_sparse_rows *rows)
{
    add_products(sum, factor, count, rows);
}

/* sum[column] += factor[row] x entry, for all entries of the first `count` rows. */
static void add_times(block_row *sum, const block_row *factor, int count,
                      const struct pp_sparse_rows *rows)
{
    if (pp_lanes_are_wide())
        wide_products(sum, factor, count, rows);
    else
        narrow_products(sum, factor, count, rows);
}

static double sum_of_block(const block_row *rows, int count)
{
    double sum = 0.0;
    for (int c = 0; c < count; c++)
        for (int p = 0; p < BLOCK; p++)
            sum += rows[c][p];
    return sum;
}

static void load(block_row *to, const struct pp_sparse_rows *rows, int first, int count)
{
    for (int p = 0; p < count; p++)
        for (int k = rows->first[first + p]; k < rows->first[first + p + 1]; k++)
            to[rows->entries[k].column][p] += rows->entries[k].value;
}

struct year_system {
    struct pp_year_batch *batch;
    const struct pp_year_task *task;
    const struct pp_sparse_rows *of_cells, *of_points;
};

/* Buffers for a block of points: V, the current and the next term of its series, the
 * rows of the sun, and the columns of D. */
struct block_space {
    block_row *V, *term, *next, *sun, *D;
};

static void solve_block(const struct year_system *system, struct block_space *space,
                        int first, int count)
{
    const struct pp_year_task *task = system->task;
    int cells = task->cells->count;
    int per_group = pp_year_solve_columns(task);
    int columns = task->group_count * per_group;
    size_t cell_bytes = (size_t)cells * sizeof(block_row);
    memset(space->term, 0, cell_bytes);
    memset(space->sun, 0, cell_bytes);
    memset(space->D, 0, (size_t)columns * sizeof(block_row));
    load(space->term, &system->of_points[PP_YEAR_ROWS_G], first, count);
    memcpy(space->V, space->term, cell_bytes);
    for (int i = 0; i < TERMS_MOST; i++) {
        memset(space->next, 0, cell_bytes);
        add_times(space->next, (const block_row *)space->term, cells,
                  &system->of_cells[PP_YEAR_ROWS_G]);
        block_row *swap = space->term;
        space->term = space->next;
        space->next = swap;
        for (int c = 0; c < cells; c++)
            for (int p = 0; p < BLOCK; p++)
                space->V[c][p] += space->term[c][p];
        if (sum_of_block((const block_row *)space->term, cells)
            <= LAST_TERM * sum_of_block((const block_row *)space->V, cells))
            break;
    }
    load(space->D, &system->of_points[PP_YEAR_ROWS_D], first, count);
    add_times(space->D, (const block_row *)space->V, cells,
              &system->of_cells[PP_YEAR_ROWS_D]);
    memcpy(space->sun, space->V, cell_bytes);
    load(space->sun, &system->of_points[PP_YEAR_ROWS_N], first, count);
    add_times(space->sun, (const block_row *)space->V, cells,
              &system->of_cells[PP_YEAR_ROWS_N]);

    struct pp_year_batch *batch = system->batch;
    for (int p = 0; p < count; p++) {
        size_t x = (size_t)(first + p);
        for (int c = 0; c < cells; c++)
            batch->inside[x * (size_t)cells + (size_t)c] = space->sun[c][p];
        for (int g = 0; g < task->group_count; g++) {
            size_t row = x * (size_t)task->group_count + (size_t)g;
            for (int k = 0; k < task->column_count; k++)
                batch->light[row * (size_t)task->column_count + (size_t)k] =
                    space->D[g * per_group + k][p];
            for (int k = 0; k < PP_YEAR_OUTDOOR_CELLS; k++)
                batch->outdoor[row * PP_YEAR_OUTDOOR_CELLS + (size_t)k] =
                    space->D[g * per_group + task->column_count + k][p];
            for (int k = 0; k < task->class_count; k++)
                batch->classes[row * (size_t)task->class_count + (size_t)k] =
                    space->D[g * per_group + task->column_count + PP_YEAR_OUTDOOR_CELLS
                             + k][p];
            batch->by_pane[row] =
                space->D[g * per_group + per_group - 1][p] / (float)PP_PI;
        }
    }
}

enum pp_status pp_year_solve(struct pp_year_batch *batch,
                             const struct pp_year_task *task,
                             const struct pp_sparse_rows of_cells[PP_YEAR_ROWS_COUNT],
                             const struct pp_sparse_rows of_points[PP_YEAR_ROWS_COUNT],
                             struct pp_error *err)
{
    const struct year_system system = {batch, task, of_cells, of_points};
    size_t cells = (size_t)task->cells->count + 1;
    size_t columns = (size_t)(task->group_count * pp_year_solve_columns(task));
    block_row *all = malloc((4 * cells + columns) * sizeof *all);
    if (!all)
        return pp_fail_memory(err);
    struct block_space space = {all, all + cells, all + 2 * cells, all + 3 * cells,
                                all + 4 * cells};
    for (int x = 0; x < task->receiver_count; x += BLOCK) {
        int left = task->receiver_count - x;
        solve_block(&system, &space, x, left < BLOCK ? left : BLOCK);
    }
    free(all);
    return PP_OK;
}
