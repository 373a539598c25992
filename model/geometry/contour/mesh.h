/* mesh.h - a conforming triangle mesh of a plane region; triangles can be halved.
 *
 * A triangle is halved from the midpoint of its longest edge to the opposite corner,
 * together with its neighbour across that edge. If that edge is not the longest one of
 * the neighbour, the neighbour is halved first (longest-edge propagation [RIV84]).
 * Angles stay at least half the smallest initial angle.
 */
#ifndef PP_MODEL_GEOMETRY_CONTOUR_MESH_H
#define PP_MODEL_GEOMETRY_CONTOUR_MESH_H

#include <stdint.h>

#include "model/base/error.h"
#include "model/geometry/region.h"

struct pp_mesh_edge {
    int a, b;         /* nodes, a < b */
    int triangles[2]; /* triangles on both sides; -1: none */
};

struct pp_mesh {
    double (*nodes)[2];
    int node_count, node_room;
    int (*triangles)[3]; /* indices of nodes, counter-clockwise */
    int triangle_count, triangle_room;
    struct pp_mesh_edge *edges; /* halved edges are kept, without triangles */
    int edge_count, edge_room;
    int *table; /* edges by their nodes, open addressing; -1: free */
    int table_room;
};

/* Makes a mesh of the region's constrained Delaunay triangles; empty on failure. */
enum pp_status pp_mesh_init(struct pp_mesh *mesh, const struct pp_region *region,
                            struct pp_error *err);
void pp_mesh_clear(struct pp_mesh *mesh);

/* Halves a triangle, and others as required. The first half keeps its index; new nodes
 * and triangles are appended. */
enum pp_status pp_mesh_halve(struct pp_mesh *mesh, int triangle, struct pp_error *err);

/* Length of a triangle's longest edge. */
double pp_mesh_longest(const struct pp_mesh *mesh, int triangle);

/* Edge between two nodes; -1 if there is none. */
int pp_mesh_edge(const struct pp_mesh *mesh, int a, int b);

#endif
