/* grid_error.h - the error that the spacing of a grid makes in a median, in the level that
 * another part of the plane reaches, and in the area over a target.
 *
 * A point stands for its whole cell. Here each cell has 16 points instead, whose factors
 * follow the slopes to the neighbouring cells: a surface of planes in place of one of
 * steps. The difference of the two is the error, to first order in the spacing.
 */
#ifndef PP_STUDIES_CRITERIA_GRID_GRID_ERROR_H
#define PP_STUDIES_CRITERIA_GRID_GRID_ERROR_H

#include "model/base/error.h"
#include "model/results/reading.h"
#include "studies/criteria/grid/plane_grid.h"

struct pp_grid_error {
    double level; /* of the level that the part reaches, as pp_plane_share has it */
    double over;  /* of the share of the plane that reaches the target */
};

/* Errors, 0 or more, of a grid of one point or more, all with values. */
enum pp_status pp_grid_error(struct pp_grid_error *error,
                             const struct pp_plane_grid *grid,
                             const struct pp_reading *points, double part,
                             double target, struct pp_error *err);

#endif
