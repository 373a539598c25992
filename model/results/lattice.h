/* lattice.h - receivers in rows and columns of a horizontal plane, as in a grid. */
#ifndef PP_MODEL_RESULTS_LATTICE_H
#define PP_MODEL_RESULTS_LATTICE_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/room/world.h"

struct pp_lattice {
    int columns, rows; /* 0: the receivers are not a lattice */
    double *x, *y;     /* coordinates of columns and rows, ascending (m) */
    int *receivers;    /* index [row * columns + column]; -1: no receiver */
};

/* Finds a lattice: receivers that face up at one height, in two or more evenly spaced
 * columns and rows, with a receiver at half or more of the crossings. Crossings without
 * a receiver (outside an L-shaped plan, in furniture) have index -1. *lattice is empty
 * if there is no lattice; the caller clears it. Fails only if memory runs out. */
enum pp_status pp_lattice_find(struct pp_lattice *lattice,
                               const struct pp_receiver *receivers, int count,
                               struct pp_error *err);
void pp_lattice_clear(struct pp_lattice *lattice);

#endif
