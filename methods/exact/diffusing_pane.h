/* diffusing_pane.h - a diffusing pane that is not lit the same all over: what falls on its
 * outside, and what it gives a receiver.
 *
 * What stands before a pane leaves jumps in its illuminance where it touches the pane's
 * plane, kinks where the plane of a surface meets it and at the height of the corners
 * of what rises above the horizon, and is smooth between. The pane is divided where
 * that runs along its axes, and in the middle else, until polynomials through 7 x 7
 * places (Chebyshev's) of each cell are within 1e-6 of what falls on the whole, by the
 * last of their coefficients; or until there are 96 cells, fewer behind dozens of
 * surfaces, of which each place takes milliseconds. Measured then: 1e-3 behind a shelf
 * that touches the pane on a slope, 1.2e-2 behind twenty slats.
 */
#ifndef PP_METHODS_EXACT_DIFFUSING_PANE_H
#define PP_METHODS_EXACT_DIFFUSING_PANE_H

#include "methods/exact/direct.h"
#include "methods/view/visible.h"
#include "model/room/world.h"

struct pp_diffusing_pane {
    struct pp_pane_cell *cells;
    int cell_count;
    double error; /* estimated, of what falls on the whole, as a share of it */
};

enum pp_status pp_diffusing_pane_init(struct pp_diffusing_pane *pane,
                                      const struct pp_world *world,
                                      const struct pp_opening *opening,
                                      struct pp_error *err);
void pp_diffusing_pane_clear(struct pp_diffusing_pane *pane);

/* Adds to *sum the integrals of what falls on the outside (over Eh) times (n.u) over
 * what is seen of the pane; `rough` as there. */
enum pp_status pp_diffusing_pane_add(struct pp_direct *sum,
                                     const struct pp_diffusing_pane *pane,
                                     const struct pp_visible *visible,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver,
                                     struct pp_error *err);

#endif
