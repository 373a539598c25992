/* sheet_pieces.h - a sheet cut into convex pieces along the lines of its corners: with
 * upright edges rectangles, as elements like to be. */
#ifndef PP_SIMULATE_ELEMENTS_SHEET_PIECES_H
#define PP_SIMULATE_ELEMENTS_SHEET_PIECES_H

#include "model/geometry/clipper.h"
#include "simulate/elements/sheets.h"

/* Appends sheet `index`'s pieces and sets its region. */
enum pp_status pp_sheet_pieces_add(struct pp_sheets *sheets, int index,
                                   struct pp_clipper *clipper, struct pp_error *err);

#endif
