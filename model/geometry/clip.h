/* clip.h - convex polygons cut by planes. */
#ifndef PP_MODEL_GEOMETRY_CLIP_H
#define PP_MODEL_GEOMETRY_CLIP_H

#include "model/geometry/vec.h"

/* The part of a convex polygon where normal.v > offset [SH74]. Returns how many
 * vertices are left, 0 if nothing; out has room for count + 1 and is not `in`. Where an
 * edge is cut depends neither on its direction nor on the plane's, so that polygons
 * which share an edge, and the two parts of one polygon, share the cut to the bit. */
int pp_clip_convex(struct pp_vec3 *out, const struct pp_vec3 *in, int count,
                   struct pp_vec3 normal, double offset);

/* Takes out of a convex plane ring points that lie within `grain` of the one before.
 * Returns how many are left, 0 if what is left has no breadth above the grain. */
int pp_clip_tidy(double (*xy)[2], int count, double grain);

#endif
