/* diffusing_pane.h - a non-uniformly lit diffusing pane: the illuminance of its
 * outside, and its direct component at a receiver.
 *
 * The illuminance jumps where an obstruction touches the pane's plane, has kinks where
 * the plane of a surface meets the pane and at the heights of the surfaces' corners
 * (seen from there, a corner is on the horizon), and is smooth between these lines. The
 * pane is divided along such lines where they are parallel to its axes, else in the
 * middle, until polynomials through 7 x 7 Chebyshev nodes of each cell have an error of
 * 1e-5 of the flux on the whole pane, as estimated from their last coefficients (in
 * fact 1e-6 or less); or until there are 96 cells, or fewer behind dozens of surfaces,
 * where each node takes long. At that limit errors are larger, for example behind a
 * sloping shelf that touches the pane, or behind many slats.
 */
#ifndef PP_METHODS_EXACT_DIFFUSING_PANE_H
#define PP_METHODS_EXACT_DIFFUSING_PANE_H

#include "methods/exact/direct.h"
#include "methods/exact/pane_cell.h"
#include "methods/view/visible.h"
#include "model/light/outside_light.h"
#include "model/room/world.h"

struct pp_diffusing_pane {
    struct pp_pane_cell *cells;
    int cell_count;
    double error; /* estimated error of the flux on the pane, relative */
};

/* Calculates the illuminance of the outside of an opening's pane. by_table: for skies
 * of ISO 15469 by a table of the sky (sky_table.h), to 1e-6 of the open sky, instead of
 * by quadrature. */
enum pp_status pp_diffusing_pane_init(struct pp_diffusing_pane *pane,
                                      const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_opening *opening, bool by_table,
                                      struct pp_error *err);
void pp_diffusing_pane_clear(struct pp_diffusing_pane *pane);

/* Adds to *sum the integrals over the visible part of the pane of its outside
 * illuminance (divided by Eh) times (n.u). sum->rough as in direct.h. */
enum pp_status pp_diffusing_pane_add(struct pp_direct *sum,
                                     const struct pp_diffusing_pane *pane,
                                     const struct pp_visible *visible,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver,
                                     struct pp_error *err);

#endif
