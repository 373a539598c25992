/* polygon.h - plane polygons in space: normal, area, flatness, and positions of points.
 *
 * Polygons are simple and may be concave. Normal and area are Newell's, half the sum of
 * the cross products of edges. This is exact for any simple plane polygon, and the best
 * fit for a slightly uneven one:
 *
 *     A n = 1/2 sum (v_i - v_0) x (v_i+1 - v_0)
 */
#ifndef PP_MODEL_GEOMETRY_POLYGON_H
#define PP_MODEL_GEOMETRY_POLYGON_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/vec.h"

/* A plane, simple polygon. Vertices are counter-clockwise for a viewer towards whom the
 * normal points. Faces of an envelope may be uneven by 1 mm; neighbouring faces share
 * corners exactly. */
struct pp_polygon {
    int count;
    struct pp_vec3 *vertices;
    struct pp_vec3 normal; /* unit */
    double area_m2;
};

/* Area times normal (m2); the normal points to the side from which the vertices are
 * counter-clockwise. Zero for fewer than three vertices. */
struct pp_vec3 pp_polygon_area_vector(const struct pp_vec3 *vertices, int count);

/* Copies the vertices, with normal and area; the normal of a polygon without area is
 * zero. On success the caller frees the copy with pp_polygon_clear. */
enum pp_status pp_polygon_of(struct pp_polygon *polygon, const struct pp_vec3 *vertices,
                             int count, struct pp_error *err);
/* Recalculates normal and area after vertices have moved. */
void pp_polygon_measure(struct pp_polygon *polygon);
void pp_polygon_clear(struct pp_polygon *polygon);

/* Mean of the vertices; not the centroid of the area. */
struct pp_vec3 pp_polygon_middle(const struct pp_polygon *polygon);

/* Signed distance (m) of a point from the polygon's plane, positive along the
 * normal. */
double pp_polygon_height(const struct pp_polygon *polygon, struct pp_vec3 point);

/* True if no vertex of the polygon is more than 1e-7 m behind the plane of the polygon
 * `plane`. */
bool pp_polygon_is_before(const struct pp_polygon *polygon,
                          const struct pp_polygon *plane);

/* Greatest distance of a vertex from the polygon's plane (m). */
double pp_polygon_unevenness(const struct pp_polygon *polygon);

/* Finds axes in a plane with this unit normal, so that along x up = normal. `along` is
 * horizontal and points right for a viewer towards whom the normal points; `up` points
 * uphill. In a horizontal plane `along` is +x. */
void pp_polygon_plane_axes(struct pp_vec3 normal, struct pp_vec3 *along,
                           struct pp_vec3 *up);

/* Coordinates of the vertices in their plane, relative to `origin`: count pairs. */
void pp_polygon_flatten(const struct pp_vec3 *vertices, int count,
                        struct pp_vec3 origin, struct pp_vec3 along, struct pp_vec3 up,
                        double (*xy)[2]);

enum pp_side { PP_OUTSIDE, PP_INSIDE, PP_ON_EDGE };

/* Position of a point relative to a ring of either orientation. A point at most
 * `tolerance` (m) from the edge is on the edge. */
enum pp_side pp_polygon_ring_side(const double (*xy)[2], int count, double x, double y,
                                  double tolerance);

/* Distance from a point to a ring's edge; nearest (may be NULL) is the nearest
 * point. */
double pp_polygon_ring_edge_distance(const double (*xy)[2], int count, double x,
                                     double y, double nearest[2]);

/* Position of a point's projection on the polygon's plane, as in
 * pp_polygon_ring_side. */
enum pp_side pp_polygon_side(const struct pp_polygon *polygon, struct pp_vec3 point,
                             double tolerance);

/* Distance (m) from a point to the polygon including its interior. */
double pp_polygon_distance(const struct pp_polygon *polygon, struct pp_vec3 point);

#endif
