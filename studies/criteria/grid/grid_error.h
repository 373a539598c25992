/* grid_error.h - the error due to the spacing of a grid: in a median, in the level that
 * a given part of the plane reaches, and in the area over a target.
 *
 * A point represents its whole cell. To find the error, each cell gets 16 points whose
 * factors follow the slopes to the neighbouring cells: a piecewise linear surface
 * instead of a piecewise constant one. The difference between the two is the error, to
 * first order in the spacing.
 */
#ifndef PP_STUDIES_CRITERIA_GRID_GRID_ERROR_H
#define PP_STUDIES_CRITERIA_GRID_GRID_ERROR_H

#include "model/base/error.h"
#include "model/results/reading.h"
#include "studies/criteria/grid/plane_grid.h"

struct pp_grid_error {
    double level; /* error of pp_plane_share's level */
    double over;  /* error of the fraction of the plane that reaches the target */
};

/* Calculates the errors (0 or more) of a grid of at least one point, all points with
 * values. */
enum pp_status pp_grid_error(struct pp_grid_error *error,
                             const struct pp_plane_grid *grid,
                             const struct pp_reading *points, double part,
                             double target, struct pp_error *err);

#endif
