/* lattice.h - receivers that stand in rows and columns over a plane, as a grid's do. */
#ifndef PP_MODEL_RESULTS_LATTICE_H
#define PP_MODEL_RESULTS_LATTICE_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/room/world.h"

struct pp_lattice {
    int columns, rows; /* 0: the receivers are no lattice */
    double *x, *y;     /* of the columns and rows, ascending (m) */
    int *receivers;    /* [row * columns + column]; -1: none stands there */
};

/* Finds a lattice: receivers that face up at one height, in two or more evenly spaced
 * columns and rows, with a receiver at half or more of the crossings. Places without
 * one (walls of an L, furniture) are omitted. The caller clears *lattice; empty if
 * there is none. Fails only if out of memory. */
enum pp_status pp_lattice_find(struct pp_lattice *lattice,
                               const struct pp_receiver *receivers, int count,
                               struct pp_error *err);
void pp_lattice_clear(struct pp_lattice *lattice);

#endif
