/* polygon.h - plane polygons in space: normal, area, flatness, and where points lie.
 *
 * Polygons are simple and may be concave. Normal and area are Newell's, from the sum
 * over the edges of half their cross products, which is right for any simple polygon
 * and the best fit for one that is not quite plane:
 *
 *     A n = 1/2 sum (v_i - v_0) x (v_i+1 - v_0)
 */
#ifndef PP_MODEL_GEOMETRY_POLYGON_H
#define PP_MODEL_GEOMETRY_POLYGON_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/vec.h"

/* Plane, simple, counter-clockwise seen against its normal (the normal points to the
 * eye). Faces of an envelope may be 1 mm uneven: neighbours share corners to the
 * bit. */
struct pp_polygon {
    int count;
    struct pp_vec3 *vertices;
    struct pp_vec3 normal; /* unit */
    double area_m2;
};

/* Area times normal (m2), towards the side from which the vertices run
 * counter-clockwise; zero for fewer than three vertices. */
struct pp_vec3 pp_polygon_area_vector(const struct pp_vec3 *vertices, int count);

/* A copy of the vertices with normal and area calculated; an area of zero leaves the
 * normal zero. On success the vertices are the caller's, to be given to
 * pp_polygon_clear. */
enum pp_status pp_polygon_of(struct pp_polygon *polygon, const struct pp_vec3 *vertices,
                             int count, struct pp_error *err);
/* Recalculates normal and area from vertices that have been moved. */
void pp_polygon_measure(struct pp_polygon *polygon);
void pp_polygon_clear(struct pp_polygon *polygon);

/* The mean of the vertices (not the centre of area). */
struct pp_vec3 pp_polygon_middle(const struct pp_polygon *polygon);

/* Height of a point above the polygon's plane (through its middle), along the normal,
 * in metres. */
double pp_polygon_height(const struct pp_polygon *polygon, struct pp_vec3 point);

/* True if no vertex of the polygon is behind the plane of the other, to a ten
 * thousandth of a millimetre. */
bool pp_polygon_is_before(const struct pp_polygon *polygon,
                          const struct pp_polygon *plane);

/* Greatest distance of a vertex from the polygon's plane (m). */
double pp_polygon_unevenness(const struct pp_polygon *polygon);

/* Axes in a plane with this unit normal, so that along x up = normal: along is
 * horizontal, to the right for an eye that looks against the normal, and up is uphill;
 * in a level plane along is +x. */
void pp_polygon_plane_axes(struct pp_vec3 normal, struct pp_vec3 *along,
                           struct pp_vec3 *up);

/* Coordinates of the vertices in their own plane, from `origin`: xy is count pairs. */
void pp_polygon_flatten(const struct pp_vec3 *vertices, int count,
                        struct pp_vec3 origin, struct pp_vec3 along, struct pp_vec3 up,
                        double (*xy)[2]);

enum pp_side { PP_OUTSIDE, PP_INSIDE, PP_ON_EDGE };

/* Side of a ring (of either orientation) on which a point of the plane lies: on its
 * edge if nearer to it than `tolerance` (m). */
enum pp_side pp_polygon_ring_side(const double (*xy)[2], int count, double x, double y,
                                  double tolerance);

/* Distance from a point to a ring's edge, and the edge's nearest point in nearest (may
 * be NULL). */
double pp_polygon_ring_edge_distance(const double (*xy)[2], int count, double x,
                                     double y, double nearest[2]);

/* Side for a point's projection on the polygon's plane, like pp_polygon_ring_side. */
enum pp_side pp_polygon_side(const struct pp_polygon *polygon, struct pp_vec3 point,
                             double tolerance);

/* Distance from a point to the polygon, its inside included (m). */
double pp_polygon_distance(const struct pp_polygon *polygon, struct pp_vec3 point);

#endif
