/* exact.h - the direct component without approximation. */
#ifndef PP_METHODS_EXACT_EXACT_H
#define PP_METHODS_EXACT_EXACT_H

#include "methods/method.h"

/* Sky component by closed form [ARVO95] for the overcast and uniform skies without
 * glass (to 1e-9 or 1e-15 of the open sky), by quadrature with glass (to 1e-6) and for
 * the skies of ISO 15469 (to 1e-9 without glass); externally reflected component by the
 * conventions in direct.h. Any number of windows, rooflights and sloping openings, any
 * receiver, any shape of room; reveals, skylines, blocks and loose surfaces.
 *
 * A diffusing pane is a Lambertian emitter of what falls on its outside: exact where
 * that is the same all over it (nothing before it but the sky, ground and far
 * skylines), else to 1e-6 by polynomials over parts of the pane (diffusing_pane.h, which
 * says where it is less). Those are lit once for a room where the method is prepared,
 * else for each receiver anew; the numbers are the same. */
extern const struct pp_method pp_method_exact;

#endif
