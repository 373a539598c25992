/* pane_cell.h - a rectangle of a diffusing pane, with the illuminance of its outside as
 * a polynomial: its values at 7 x 7 Chebyshev nodes. */
#ifndef PP_METHODS_EXACT_PANE_CELL_H
#define PP_METHODS_EXACT_PANE_CELL_H

#include "model/geometry/vec.h"

enum { PP_PANE_CELL_NODES = 7 };

/* Coordinates are along the opening's own axes (m, from the room's origin). */
struct pp_pane_cell {
    double low[2], high[2];
    double sky[PP_PANE_CELL_NODES][PP_PANE_CELL_NODES];
    double external[PP_PANE_CELL_NODES][PP_PANE_CELL_NODES];
    double total, error; /* integral over the cell, and its error */
    int worse;           /* the axis with the larger part of the error */
};

/* The plane of the pane: foot + x along + y up. */
struct pp_pane_plane {
    struct pp_vec3 foot, along, up, toward;
};

/* A cell as seen from a receiver. */
struct pp_pane_cell_seen {
    const struct pp_pane_cell *cell;
    struct pp_pane_plane plane;
    double eye[2]; /* the foot of the eye's perpendicular, on the pane's axes */
    double distance_m;
};

/* Nodes from -1 to 1: the zeros of the Chebyshev polynomial, -cos((2 i + 1) pi/14). */
extern const double pp_pane_cell_nodes[PP_PANE_CELL_NODES];

/* Weights of the values at the nodes for interpolation at t, from -1 to 1: Lagrange
 * polynomials in their barycentric form. */
void pp_pane_cell_weights(double weights[PP_PANE_CELL_NODES], double t);

#endif
