/* clip.h - clips convex polygons by planes. */
#ifndef PP_MODEL_GEOMETRY_CLIP_H
#define PP_MODEL_GEOMETRY_CLIP_H

#include "model/geometry/vec.h"

/* Part of a convex polygon where normal.v > offset [SH74]. Returns the number of
 * vertices, 0 if nothing is left. out has space for count + 1 vertices and must not be
 * `in`. The intersection of an edge with the plane does not depend on the direction of
 * the edge or the plane. So polygons with a common edge get exactly the same vertex
 * there, and so do the two parts of a divided polygon. */
int pp_clip_convex(struct pp_vec3 *out, const struct pp_vec3 *in, int count,
                   struct pp_vec3 normal, double offset);

/* Removes points of a convex plane ring that lie within `grain` of the previous point.
 * Returns the number of points left, 0 if the remaining ring is no wider than
 * `grain`. */
int pp_clip_tidy(double (*xy)[2], int count, double grain);

#endif
