/* mesh.h - triangles that cover a plane figure and are halved where needed, always edge
 * to edge.
 *
 * A triangle is halved from the middle of its longest edge to the corner opposite, with
 * its neighbour across that edge; where that edge is not the neighbour's longest, the
 * neighbour is halved first (longest-edge propagation [RIV84]). Angles stay at least
 * half of the smallest at first.
 */
#ifndef PP_MODEL_GEOMETRY_CONTOUR_MESH_H
#define PP_MODEL_GEOMETRY_CONTOUR_MESH_H

#include <stdint.h>

#include "model/base/error.h"
#include "model/geometry/region.h"

struct pp_mesh_edge {
    int a, b;         /* nodes, a < b */
    int triangles[2]; /* on either side; -1: none */
};

struct pp_mesh {
    double (*nodes)[2];
    int node_count, node_room;
    int (*triangles)[3]; /* nodes, counter-clockwise */
    int triangle_count, triangle_room;
    struct pp_mesh_edge *edges; /* those that were halved are kept, without triangles */
    int edge_count, edge_room;
    int *table; /* edges by their nodes, open addressing; -1: free */
    int table_room;
};

/* Makes a mesh of the region's constrained Delaunay triangles; it is empty on
 * failure. */
enum pp_status pp_mesh_init(struct pp_mesh *mesh, const struct pp_region *region,
                            struct pp_error *err);
void pp_mesh_clear(struct pp_mesh *mesh);

/* Halves a triangle, and as many others as that takes. The first half keeps its number;
 * new nodes and triangles come at the end. */
enum pp_status pp_mesh_halve(struct pp_mesh *mesh, int triangle, struct pp_error *err);

/* Length of a triangle's longest edge. */
double pp_mesh_longest(const struct pp_mesh *mesh, int triangle);

/* The edge between two nodes, or -1. */
int pp_mesh_edge(const struct pp_mesh *mesh, int a, int b);

#endif
