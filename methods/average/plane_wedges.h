/* plane_wedges.h - the working plane in wedges that spread from an opening, each with its
 * own coordinates for an integral.
 *
 * Light spreads from an opening, the narrower it is the more sharply: a slit lights a strip
 * that rectangles of the plane step over. Wedges have their apex in the plan behind the
 * opening, where the lines between its jambs cross, so that the light of any opening fills
 * them and turning the room changes nothing:
 *
 *     apex       behind the inside outline by half of its width w, or of the reveal r,
 *                whichever is more
 *     sides      tan = w/r off the normal at most: no light passes both outlines beyond
 *
 * Between the sides there are wedges between all corners of a convex piece of the plane.
 * A rooflight, level or sloping, lights places on both sides of it in the plan: it has its
 * apex in its middle and wedges all round.
 */
#ifndef PP_METHODS_AVERAGE_PLANE_WEDGES_H
#define PP_METHODS_AVERAGE_PLANE_WEDGES_H

#include "model/room/world.h"

/* Point from which light spreads. */
struct pp_plane_centre {
    double apex[2];   /* in the plan (m) */
    double at[2];     /* the middle of the opening */
    double facing[2]; /* unit vector into the room; 0, 0: light spreads all round */
    double tan_aside; /* of the sides against that, at the apex; INFINITY: no sides */
};

struct pp_plane_centre pp_plane_centre_of(const struct pp_opening *opening);

/* A part of a wedge, from a near to a far edge of a convex piece. Its coordinates run from
 * 0 to 1: by the angle, and by the root of the distance from the near edge, since daylight
 * is steepest before the wall. */
struct pp_plane_wedge {
    int centre; /* its index */
    double apex[2];
    double low_rad, wide_rad;     /* angle about the apex */
    double near[2][2], far[2][2]; /* two points of each edge */
    bool from_apex;               /* no near edge */
    double low, wide;             /* part of the root of the distance */
};

struct pp_plane_wedges {
    int count;
    struct pp_plane_wedge *list;
};

/* The wedges of all centres; freed by the caller. */
enum pp_status pp_plane_wedges_find(struct pp_plane_wedges *wedges,
                                    const struct pp_region *plane,
                                    const struct pp_plane_centre *centres, int count,
                                    struct pp_error *err);

/* The point at these coordinates, and the area (m2) for each unit of both. */
double pp_plane_wedge_point(const struct pp_plane_wedge *wedge, const double square[2],
                            double xy[2]);

#endif
