/* elevation.h - an opening and what stands before it, as upright rectangles: what a
 * person draws to work with tables and protractors.
 *
 * Everything is seen from a point and measured as on paper, over the distance d from
 * the opening's plane: x/d along the opening, to the right seen from inside, and z/d
 * above the point.
 *
 * What of the opening the point sees above its own horizon is taken as a rectangle. A
 * rectangle stays what it is, with a reveal what both outlines leave of it; any other
 * shape, by form or because something inside hides a part, becomes the rectangle with
 * its area, its centroid and the proportions of its bounding box, the centroid raised
 * where that would fall below the horizon.
 *
 * Obstructions are upright rectangles too: of the opening's own wall's skyline all
 * below its head, at h/d = (head - z)/(D + d), or tan alpha if it is far; of a block, a
 * loose surface outside or another part of the building what its silhouette cuts from
 * the opening, with the jambs and the lower edge of that and an equal area. Where
 * several overlap the one with the nearest corner counts.
 */
#ifndef PP_METHODS_VIEW_ELEVATION_H
#define PP_METHODS_VIEW_ELEVATION_H

#include "model/room/world.h"

/* A part of the opening with one thing behind it, edges over d. */
struct pp_elevation_part {
    double left, right, low, high;
    double reflectance; /* of the obstruction; NAN: sky */
};

struct pp_elevation {
    int count; /* 0: the point sees nothing of it */
    struct pp_elevation_part *parts;
};

/* The opening must be vertical. A point behind it or in its plane sees nothing. */
enum pp_status pp_elevation_create(struct pp_elevation *elevation,
                                   const struct pp_world *world,
                                   const struct pp_opening *opening,
                                   struct pp_vec3 point, struct pp_error *err);
void pp_elevation_clear(struct pp_elevation *elevation);

#endif
