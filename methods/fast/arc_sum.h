/* arc_sum.h - the light of a polygon as a sum over its edges, for any luminance.
 *
 * A function f of direction is integrated along meridians about an axis a. With theta
 * the angle from the axis and psi the angle around it,
 *
 *     A(theta, psi) = integral from 0 to theta of f sin theta' dtheta'
 *     B = A / sin^2 theta
 *
 *     integral of f over a polygon = sum over its edges of integral A dpsi
 *                                  = sum over its edges of (a.G) integral B ds      (1)
 *
 * G is the unit normal of an edge's plane through the eye, and s the arc length along
 * the edge. B is the potential. B is as smooth as f, also on the axis, and singular
 * only opposite to the axis, where no polygon may be. Only B is evaluated, not f.
 *
 * An arc from r to r' is r + t (r' - r) over its length, with t from 0 to 1, and (a.G)
 * ds = a.(r x r') dt / |r + t (r' - r)|^2. The integral uses a Gauss-Legendre rule in
 * t.
 */
#ifndef PP_METHODS_FAST_ARC_SUM_H
#define PP_METHODS_FAST_ARC_SUM_H

#include <stdbool.h>

#include "methods/exact/half_space_clip.h"
#include "model/geometry/vec.h"

enum { PP_ARC_NODES = 8 };

/* Nodes along an arc: directions u (unit) and weights dt / |r + t (r' - r)|^2. */
struct pp_arc_nodes {
    int count;
    struct pp_vec3 across; /* r x r' */
    struct pp_vec3 u[PP_ARC_NODES];
    double weight[PP_ARC_NODES];
};

/* The sum over the nodes of weight times a.across times B. */
typedef double pp_arc_potential(const void *context, const struct pp_arc_nodes *nodes);

/* A plane through the eye, axis.u = 0. Near this plane, for |axis.u| up to about
 * `width`, the slope of the potential changes rapidly. */
struct pp_arc_bend {
    struct pp_vec3 axis;
    double width;
};

/* Limits the length of an arc that one quadrature rule covers. */
struct pp_arc_spacing {
    double longest; /* longest chord (of unit vectors) for one rule */
    int bend_count;
    struct pp_arc_bend bends[2];
    const struct pp_vec3 *cusp; /* a direction (unit) where f has a cusp, or NULL */
    struct pp_vec3 axis;        /* axis of the potential, if there is a cusp */
};

/* Sum (1) over the part of a ring within the half-spaces. Vertices are relative to the
 * eye, counter-clockwise about the axis if the axis passes through the ring; the sum of
 * a clockwise ring is negative. Allocates nothing. */
double pp_arc_sum(pp_arc_potential *potential, const void *context,
                  const struct pp_arc_spacing *spacing, const struct pp_vec3 *vertices,
                  int count, const struct pp_vec3 *half_spaces, int half_space_count);

#endif
