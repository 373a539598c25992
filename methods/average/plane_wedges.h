/* plane_wedges.h - the working plane in wedges that spread from an opening, each with
 * its own coordinates for an integral.
 *
 * A narrow opening lights a narrow strip, which a cubature over rectangles of the plane
 * would miss. The plane is therefore divided into wedges. In the plan, the apex of the
 * wedges is behind the opening: in a reveal deeper than the opening is wide, where the
 * lines between opposite jambs of the inside and outside outlines cross. The light of
 * any opening fills its wedges, and the result does not depend on the orientation of
 * the room:
 *
 *     apex       behind the inside outline by half of its width w or half of the
 *                reveal r, whichever is greater
 *     sides      at tan = w/r from the normal: light farther to the side does not pass
 *                both outlines
 *
 * Between the sides there are wedges between all corners of a convex piece of the
 * plane. A rooflight, horizontal or sloping, lights the plan on all sides. The apex is
 * then in the middle of the rooflight, with wedges in all directions.
 */
#ifndef PP_METHODS_AVERAGE_PLANE_WEDGES_H
#define PP_METHODS_AVERAGE_PLANE_WEDGES_H

#include "model/room/world.h"

/* Point from which light spreads. */
struct pp_plane_centre {
    double apex[2];   /* position in the plan (m) */
    double at[2];     /* middle of the opening, in the plan (m) */
    double facing[2]; /* horizontal unit vector into the room; 0, 0: light spreads in
                       * all directions */
    double tan_aside; /* tangent of the sides' angle with `facing`, at the apex;
                       * INFINITY: no sides */
};

struct pp_plane_centre pp_plane_centre_of(const struct pp_opening *opening);

/* A part of a wedge, from a near to a far edge of a convex piece. The part has two
 * coordinates from 0 to 1. One is proportional to the angle; the other follows the
 * square root of the distance, since daylight changes most near the window. */
struct pp_plane_wedge {
    int centre; /* index in the list of centres */
    double apex[2];
    double low_rad, wide_rad;     /* start and width of the wedge's angle about the
                                   * apex */
    double near[2][2], far[2][2]; /* two points on the near edge, two on the far edge
                                   * (m) */
    bool from_apex;               /* true: the wedge begins at its apex and has no near
                                   * edge */
    double low, wide;             /* lowest value and range of the square root of the
                                   * fraction of the distance from near to far edge */
};

struct pp_plane_wedges {
    int count;
    struct pp_plane_wedge *list;
};

/* Finds the wedges of all centres. The caller frees wedges->list. */
enum pp_status pp_plane_wedges_find(struct pp_plane_wedges *wedges,
                                    const struct pp_region *plane,
                                    const struct pp_plane_centre *centres, int count,
                                    struct pp_error *err);

/* The point at these coordinates, and the Jacobian: plane area (m2) per unit of both
 * coordinates. */
double pp_plane_wedge_point(const struct pp_plane_wedge *wedge, const double square[2],
                            double xy[2]);

#endif
