/* plane_points.h - points of a room's working plane, each of which represents a known
 * area. There is one point in each of many squares; squares that the plane's edge cuts
 * are divided into triangles, with a point in the middle of each. No two points of
 * squares are on a line parallel to a wall, since a partition or the edge of a shadow
 * could then cover both or neither. */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_PLANE_POINTS_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_PLANE_POINTS_H

#include "model/room/world.h"

struct pp_plane_points {
    struct pp_vec3 *list;
    double *shares; /* shares of the plane's area, whose sum is 1 */
    int count;
};

/* Makes about `wanted` points; none without a plane. The caller clears them. */
enum pp_status pp_plane_points_of(struct pp_plane_points *points,
                                  const struct pp_world *world, int wanted,
                                  struct pp_error *err);
void pp_plane_points_clear(struct pp_plane_points *points);

#endif
