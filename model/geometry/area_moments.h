/* area_moments.h - area, centroid and bounding box of plane figures, and of their parts
 * after cuts.
 *
 * Each is a sum over edges a to b, with c = a_x b_z - a_z b_x:
 *
 *     area      1/2 sum c
 *     moments   1/6 sum c (a_x + b_x),  1/6 sum c (a_z + b_z)
 *
 * Figures may be of any shape, with holes; cuts leave bridges that run both ways and
 * cancel.
 */
#ifndef PP_MODEL_GEOMETRY_AREA_MOMENTS_H
#define PP_MODEL_GEOMETRY_AREA_MOMENTS_H

#include "model/geometry/region.h"

struct pp_area_moments {
    double area;               /* negative for a clockwise figure */
    double x_moment, z_moment; /* of the area: times the centroid's coordinates */
    double left, right, low, high;
};

/* Moments of the empty figure, to which edges are added. */
struct pp_area_moments pp_area_moments_empty(void);

/* Adds an edge of a figure. Edges add up to its area as seen from the origin; those on
 * a line through the origin may be left out. */
void pp_area_moments_add_edge(struct pp_area_moments *moments, const double a[2],
                              const double b[2]);

/* Moments of the part of a region above z = 0. Takes spikes off the region's rings. */
struct pp_area_moments pp_area_moments_above_horizon(struct pp_region *region);

/* Room that pp_area_moments_in_box needs for each point, of a figure that one cut may
 * have gone through already: each cut adds at most half as many. */
enum { PP_AREA_MOMENTS_POINTS = 8 };

/* Moments of the part of a polygon of `count` points within a box. points and spare have
 * room for PP_AREA_MOMENTS_POINTS times the first count of points; both are written over. */
struct pp_area_moments pp_area_moments_in_box(double (*points)[2], double (*spare)[2],
                                              int count, double left, double right,
                                              double low, double high);

#endif
