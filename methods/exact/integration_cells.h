/* integration_cells.h - divides a region of a view's plane into cells, each bounded by
 * two edges of the region and two vertical lines. For quadrature.c only. */
#ifndef PP_METHODS_EXACT_INTEGRATION_CELLS_H
#define PP_METHODS_EXACT_INTEGRATION_CELLS_H

#include "model/base/error.h"
#include "model/geometry/region.h"
#include "model/geometry/vec.h"

/* An edge of the clipped rings, from left to right. */
struct ring_edge {
    double x[2], y[2];
};

/* The line y = level + slope x. */
struct cell_bound {
    double level, slope;
};

/* The area between two such lines, from x[0] to x[1]. */
struct integration_cell {
    double x[2];
    struct cell_bound lower, upper;
    int lower_edge, upper_edge; /* indices in `edges`; -1: the line is not an edge */
};

/* The edges of the region and the cells between them. */
struct integration_cells {
    struct ring_edge *edges;
    int edge_count, edge_capacity;
    double *stops; /* the x at which cells begin and end */
    int stop_count;
    struct integration_cell *list;
    int count, capacity;
};

/* Adds the edges of the part of a ring within the half-spaces n.(x, y, distance_m) >
 * 0. */
enum pp_status pp_integration_cells_add_ring(struct integration_cells *cells,
                                             const struct pp_ring *ring,
                                             const struct pp_vec3 *planes,
                                             int plane_count, double distance_m,
                                             struct pp_error *err);

/* Finds the cells between all edges. Cells are split so that the cusp (NULL: none) is a
 * corner. */
enum pp_status pp_integration_cells_find(struct integration_cells *cells,
                                         const double *cusp, struct pp_error *err);

void pp_integration_cells_clear(struct integration_cells *cells);

#endif
