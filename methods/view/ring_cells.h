/* ring_cells.h - many rings applied to fragments, cell by cell: each ring meets only
 * the fragments of the cells that it overlaps. For occluder_rings.c and
 * convex_patches.c only.
 *
 * The extent of the fragments is halved until a cell has few rings, or halves no longer
 * part them; fragments are cut along the cells' sides. With few rings there are no
 * cells; the result is the same.
 */
#ifndef PP_METHODS_VIEW_RING_CELLS_H
#define PP_METHODS_VIEW_RING_CELLS_H

#include "methods/view/fragments.h"

/* Callback for the fragments of a cell: `rings` has the numbers of rings that reach into
 * it, in their order. */
typedef enum pp_status pp_ring_cells_do(void *data, struct pp_fragments *open,
                                        const int *rings, int count,
                                        struct pp_error *err);

/* Applies `act` to all cells of `open`; afterwards `open` has the remainder of each. */
enum pp_status pp_ring_cells(struct pp_fragments *open,
                             const struct pp_fragment_ring *rings, int count,
                             pp_ring_cells_do *act, void *data, struct pp_error *err);

#endif
