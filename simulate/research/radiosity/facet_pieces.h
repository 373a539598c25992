/* facet_pieces.h - cuts a facet into convex pieces along lines through its corners.
 * With horizontal and vertical edges the pieces are rectangles, the best shape for
 * elements. */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_FACET_PIECES_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_FACET_PIECES_H

#include "model/geometry/clipper.h"
#include "simulate/research/radiosity/facets.h"

/* Appends the pieces of facet `index`, and sets its region. */
enum pp_status pp_facet_pieces_add(struct pp_facets *facets, int index,
                                   struct pp_clipper *clipper, struct pp_error *err);

#endif
