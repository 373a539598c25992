/* elevation.h - an opening and the obstructions in front of it as vertical rectangles,
 * for tables and protractors.
 *
 * Rectangles are measured as seen from a point, as lengths divided by the distance d of
 * the point from the opening's plane: x/d along the opening, to the right as seen from
 * inside, and z/d above the point.
 *
 * The visible part of the opening above the point's horizon becomes one rectangle. For
 * a rectangular opening that is the rectangle itself or, with a reveal, the
 * intersection of both outlines; any other shape, or one partly hidden by an occluder
 * inside, becomes the rectangle of equal area with the same centroid and the
 * proportions of the bounding box, raised where it would extend below the horizon.
 *
 * Obstructions are vertical rectangles too. The skyline of the opening's own wall hides
 * all below its head, at h/d = (head - z)/(D + d), or at tan alpha for a skyline
 * without a distance. A block, a free-standing surface outside or another part of the
 * building becomes the rectangle with the jambs and the lower edge of its silhouette
 * within the opening and with an equal area. Where several obstructions overlap, the
 * one with the nearest corner counts.
 */
#ifndef PP_METHODS_VIEW_ELEVATION_H
#define PP_METHODS_VIEW_ELEVATION_H

#include "model/room/world.h"

/* A part of the opening that shows the sky or obstructions of one reflectance; edges
 * divided by d. */
struct pp_elevation_part {
    double left, right, low, high;
    double reflectance; /* reflectance of the obstruction; NAN: sky */
};

struct pp_elevation {
    int count; /* 0: the point does not see the opening */
    struct pp_elevation_part *parts;
};

/* The opening must be vertical. From a point behind it or in its plane, no parts are
 * visible. On success the caller clears *elevation. */
enum pp_status pp_elevation_init(struct pp_elevation *elevation,
                                 const struct pp_world *world,
                                 const struct pp_opening *opening, struct pp_vec3 point,
                                 struct pp_error *err);
void pp_elevation_clear(struct pp_elevation *elevation);

#endif
