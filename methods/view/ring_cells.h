/* ring_cells.h - many rings applied to fragments, cell by cell: each ring is compared
 * only with the fragments of the cells that it overlaps. For occluder_rings.c and
 * convex_patches.c only.
 *
 * The extent of the fragments is halved until a cell has few rings, or further halving
 * does not separate them; fragments are cut along the cells' sides. With few rings
 * there are no cells; the result is the same.
 */
#ifndef PP_METHODS_VIEW_RING_CELLS_H
#define PP_METHODS_VIEW_RING_CELLS_H

#include "methods/view/fragments.h"

/* Callback for the fragments of a cell. `rings`: indices of the rings that overlap the
 * cell, in ascending order. */
typedef enum pp_status pp_ring_cells_do(void *data, struct pp_fragments *open,
                                        const int *rings, int count,
                                        struct pp_error *err);

/* Calls `act` for each cell of `open`; afterwards `open` contains the fragments that
 * remain in all cells. */
enum pp_status pp_ring_cells(struct pp_fragments *open,
                             const struct pp_fragment_ring *rings, int count,
                             pp_ring_cells_do *act, void *data, struct pp_error *err);

#endif
