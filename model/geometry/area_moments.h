/* area_moments.h - area, centroid and bounding box of plane regions, and of their
 * clipped parts.
 *
 * Sums over the edges from a to b, with c = a_x b_z - a_z b_x:
 *
 *     area      1/2 sum c
 *     moments   1/6 sum c (a_x + b_x),  1/6 sum c (a_z + b_z)
 *
 * Regions may have any shape, and holes. Clipping leaves bridges that are traversed in
 * both directions; their contributions cancel.
 */
#ifndef PP_MODEL_GEOMETRY_AREA_MOMENTS_H
#define PP_MODEL_GEOMETRY_AREA_MOMENTS_H

#include "model/geometry/region.h"

struct pp_area_moments {
    double area;               /* negative for a clockwise outline */
    double x_moment, z_moment; /* area times the centroid's coordinates */
    double left, right, low, high;
};

/* Moments of an empty region, to which edges are added. */
struct pp_area_moments pp_area_moments_empty(void);

/* Adds an edge: the triangle that it forms with the origin. Edges on a line through the
 * origin may be omitted. */
void pp_area_moments_add_edge(struct pp_area_moments *moments, const double a[2],
                              const double b[2]);

/* Moments of the part of a region above z = 0. Removes spikes from the region's
 * rings. */
struct pp_area_moments pp_area_moments_above_horizon(struct pp_region *region);

/* Number of points that pp_area_moments_in_box stores per original point. Each clip
 * multiplies the number of points by at most 1.5; a polygon clipped once before the
 * call is clipped five times in total, and 1.5^5 = 7.6. */
enum { PP_AREA_MOMENTS_POINTS = 8 };

/* Moments of the part of a polygon of `count` points within a box. points and spare
 * have space for PP_AREA_MOMENTS_POINTS times count points; both are overwritten. */
struct pp_area_moments pp_area_moments_in_box(double (*points)[2], double (*spare)[2],
                                              int count, double left, double right,
                                              double low, double high);

#endif
