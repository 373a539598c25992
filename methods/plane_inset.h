/* plane_inset.h - points of a plane figure's edge, moved a little off the walls.
 */
#ifndef PP_METHODS_PLANE_INSET_H
#define PP_METHODS_PLANE_INSET_H

#include "model/geometry/region.h"
#include "model/geometry/vec.h"

/* The place at height z over (x, y), as far inside the figure as the inset (m): moved
 * along the inward normals of the edges that it is nearer to. On the edge itself, in a
 * window's plane or under one, what is seen has no value of its own. */
struct pp_vec3 pp_plane_inset(const struct pp_region *plane, double z, double inset_m,
                              double x, double y);

#endif
