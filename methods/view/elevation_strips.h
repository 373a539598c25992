/* elevation_strips.h - cuts the visible part of an opening by the obstructions in front
 * of it, all vertical rectangles (elevation.h).
 *
 * The visible part is divided into vertical strips from jamb to jamb, and each strip by
 * the obstructions visible in it; equal neighbours are joined. A sweep line crosses the
 * edges, so that the time for a strip depends only on the obstructions that cross it.
 */
#ifndef PP_METHODS_VIEW_ELEVATION_STRIPS_H
#define PP_METHODS_VIEW_ELEVATION_STRIPS_H

#include "methods/view/elevation.h"

/* An obstruction on the drawing, as a rectangle. */
struct pp_elevation_obstruction {
    struct pp_elevation_part outline;
    double distance_m; /* distance of the nearest corner: the nearer obstruction
                        * hides the other */
    int order;         /* at equal distances, the lower order is in front */
};

struct pp_elevation_obstructions {
    int count;
    struct pp_elevation_obstruction *list;
};

/* Adds the parts of `seen`, which is not empty, to an empty elevation. Obstructions are
 * not empty either; they are put in order, the nearest first. The caller clears
 * *elevation, even after a failure. */
enum pp_status pp_elevation_strips_cut(struct pp_elevation *elevation,
                                       const struct pp_elevation_part *seen,
                                       struct pp_elevation_obstructions *obstructions,
                                       struct pp_error *err);

#endif
