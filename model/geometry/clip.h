/* clip.h - convex polygons cut by planes. */
#ifndef PP_MODEL_GEOMETRY_CLIP_H
#define PP_MODEL_GEOMETRY_CLIP_H

#include "model/geometry/vec.h"

/* Part of a convex polygon where normal.v > offset [SH74]. Returns the number of
 * vertices, 0 if nothing is left; out has space for count + 1 and is not `in`. The cut
 * of an edge depends neither on its direction nor on the plane's. Polygons that share
 * an edge, and the two parts of one polygon, therefore share the cut to the bit. */
int pp_clip_convex(struct pp_vec3 *out, const struct pp_vec3 *in, int count,
                   struct pp_vec3 normal, double offset);

/* Removes points of a convex plane ring that lie within `grain` of the one before.
 * Returns the remaining number, 0 if the rest is no wider than the grain. */
int pp_clip_tidy(double (*xy)[2], int count, double grain);

#endif
