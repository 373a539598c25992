/* pane_rectangle.h - the direct component of rectangles of a diffusing pane by a fixed
 * rule, in place of quadrature: the part of a cell that a receiver sees is often one.
 */
#ifndef PP_METHODS_EXACT_PANE_RECTANGLE_H
#define PP_METHODS_EXACT_PANE_RECTANGLE_H

#include <stdbool.h>

#include "methods/exact/direct.h"
#include "methods/exact/pane_cell.h"
#include "methods/view/visible.h"
#include "model/geometry/bounds.h"

/* The rectangle on the pane around its visible part, without what is below the
 * receiver's horizon if that is parallel to the pane's lower edge; from the foot of the
 * eye's perpendicular. */
struct pp_bounds2 pp_pane_rectangle_around(const struct pp_pane_cell_seen *seen,
                                           const struct pp_visible *visible,
                                           struct pp_vec3 normal);

/* Adds the light of the cell's part within `bounds`, before division by pi, to sum->sky
 * and sum->external: to 1e-8, or to 1e-5 if sum->rough. Returns false, and adds
 * nothing, if the part is too near, or not all of it is visible. */
bool pp_pane_rectangle_add(struct pp_direct *sum, const struct pp_pane_cell_seen *seen,
                           const struct pp_bounds2 *bounds,
                           const struct pp_visible *visible, struct pp_vec3 normal);

#endif
