/* cache_octree.h - the records sorted by place: an octree of the scene's box. Inside
 * simulate/ only.
 *
 * A record is stored in every cell of about its own size that the box of its ellipse
 * touches. One path down from the root therefore meets all records whose ellipses may
 * contain a point.
 */
#ifndef PP_SIMULATE_CACHE_CACHE_OCTREE_H
#define PP_SIMULATE_CACHE_CACHE_OCTREE_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"
#include "model/geometry/vec.h"

struct pp_cache_octree_cell {
    int children[8]; /* 0: none */
    int first;       /* first link of the node; -1: none */
};

struct pp_cache_octree_link {
    int record, next;
};

struct pp_cache_octree {
    struct pp_vec3 low;
    double size_m;
    struct pp_cache_octree_cell *cells;
    int cell_count, cell_capacity;
    struct pp_cache_octree_link *links;
    int link_count, link_capacity;
};

/* low and size_m: a cube that contains all points; points outside it are stored at the
 * root. */
enum pp_status pp_cache_octree_init(struct pp_cache_octree *tree, struct pp_vec3 low,
                                    double size_m, struct pp_error *err);
void pp_cache_octree_clear(struct pp_cache_octree *tree);

/* Removes all records; the box of the tree is unchanged. */
enum pp_status pp_cache_octree_reset(struct pp_cache_octree *tree,
                                     struct pp_error *err);

enum pp_status pp_cache_octree_add(struct pp_cache_octree *tree, int record,
                                   struct pp_vec3 point, double radius_m,
                                   struct pp_error *err);

/* A cell and its cube. */
struct pp_cache_octree_cube {
    int cell;
    struct pp_vec3 low;
    double size_m;
};

/* Iterator over the records of all cells that contain a point. */
struct pp_cache_octree_iterator {
    const struct pp_cache_octree *tree;
    struct pp_vec3 point;
    struct pp_cache_octree_cube at;
    int link;
};
struct pp_cache_octree_iterator pp_cache_octree_iterator(
    const struct pp_cache_octree *tree, struct pp_vec3 point);
bool pp_cache_octree_next(struct pp_cache_octree_iterator *iterator, int *record);

/* Calls `visit` for each record in cells touched by the box of half-width radius_m
 * about the point; a record may be visited more than once. */
void pp_cache_octree_visit_near(const struct pp_cache_octree *tree,
                                struct pp_vec3 point, double radius_m,
                                void (*visit)(void *context, int record),
                                void *context);

#endif
