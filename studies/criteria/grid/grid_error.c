/* grid_error.c - see grid_error.h. */
#include "studies/criteria/grid/grid_error.h"

#include <math.h>
#include <stdlib.h>

#include "studies/criteria/grid/plane_share.h"

/* Subdivisions of a cell in each direction. */
enum { FINER = 4 };

/* Change of the factor over one cell along an axis: mean of the differences to existing
 * neighbours. index: point in each cell of the lattice; -1: none. */
static double slope_at(const struct pp_plane_grid *grid, const int *index,
                       const struct pp_reading *points, int point, int axis)
{
    const int at[2] = {grid->cells[point][0], grid->cells[point][1]};
    const int size[2] = {grid->columns, grid->rows};
    double sum = 0.0;
    int found = 0;
    for (int side = -1; side <= 1; side += 2) {
        int other[2] = {at[0], at[1]};
        other[axis] += side;
        if (other[axis] < 0 || other[axis] >= size[axis])
            continue;
        int neighbour = index[other[1] * grid->columns + other[0]];
        if (neighbour < 0)
            continue;
        sum += side * (points[neighbour].value - points[point].value);
        found++;
    }
    return found > 0 ? sum / found : 0.0;
}

/* Writes to `finer`, cell after cell, the FINER * FINER interpolated factors of each
 * cell, none below 0. */
static void refine_cells(struct pp_reading *finer, const struct pp_plane_grid *grid,
                         const int *index, const struct pp_reading *points)
{
    for (int i = 0; i < grid->count; i++) {
        double along_x = slope_at(grid, index, points, i, 0);
        double along_y = slope_at(grid, index, points, i, 1);
        for (int k = 0; k < FINER * FINER; k++) {
            double x = (k % FINER + 0.5) / FINER - 0.5;
            double y = (k / FINER + 0.5) / FINER - 0.5;
            double value = points[i].value + along_x * x + along_y * y;
            *finer++ = pp_reading_of(fmax(value, 0.0));
        }
    }
}

enum pp_status pp_grid_error(struct pp_grid_error *error,
                             const struct pp_plane_grid *grid,
                             const struct pp_reading *points, double part,
                             double target, struct pp_error *err)
{
    const int cells = grid->columns * grid->rows, count = grid->count;
    int *index = malloc((size_t)cells * sizeof *index);
    struct pp_reading *finer =
        malloc((size_t)count * (FINER * FINER + 1) * sizeof *finer);
    struct pp_receiver *parts = malloc((size_t)count * FINER * FINER * sizeof *parts);
    struct pp_plane_share coarse, fine;
    enum pp_status status = index && finer && parts ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK) {
        struct pp_reading *bare = finer + (size_t)count * FINER * FINER;
        for (int i = 0; i < cells; i++)
            index[i] = -1;
        for (int i = 0; i < count; i++) {
            index[grid->cells[i][1] * grid->columns + grid->cells[i][0]] = i;
            bare[i] = pp_reading_of(points[i].value);
            for (int k = 0; k < FINER * FINER; k++)
                parts[i * FINER * FINER + k] = grid->receivers[i];
        }
        refine_cells(finer, grid, index, points);
        status = pp_plane_share(&coarse, bare, grid->receivers, count, 0.0, part,
                                target, err);
    }
    if (status == PP_OK)
        status = pp_plane_share(&fine, finer, parts, count * FINER * FINER, 0.0, part,
                                target, err);
    if (status == PP_OK)
        *error = (struct pp_grid_error){fabs(coarse.level - fine.level),
                                        fabs(coarse.over - fine.over)};
    free(index);
    free(finer);
    free(parts);
    return status;
}
