/* plane_points.h - points of a room's working plane, each of which represents a known
 * area. There is one point in each of many squares; squares that the plane's edge cuts
 * are divided into triangles, with a point in the middle of each. No two points of
 * squares are on a line parallel to a wall, since the edge of a partition or of a
 * shadow along such a line would affect both points in the same way. */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_PLANE_POINTS_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_PLANE_POINTS_H

#include "model/room/world.h"

struct pp_plane_points {
    struct pp_vec3 *list;
    double *shares; /* fraction of the plane's area that each point represents; the sum
                     * is 1 */
    int count;
};

/* Makes about `wanted` points; none without a plane. The caller clears them. */
enum pp_status pp_plane_points_of(struct pp_plane_points *points,
                                  const struct pp_world *world, int wanted,
                                  struct pp_error *err);
void pp_plane_points_clear(struct pp_plane_points *points);

#endif
