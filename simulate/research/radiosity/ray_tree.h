/* ray_tree.h - a bounding volume hierarchy that finds the first triangle on a ray, in
 * double precision.
 *
 * The tree is built once and only read afterwards, by any number of threads.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_RAY_TREE_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_RAY_TREE_H

#include "model/base/error.h"
#include "model/geometry/vec.h"

struct pp_ray_triangle {
    struct pp_vec3 corners[3];
    int owner; /* the caller's identifier */
};

struct pp_ray_tree;

/* Copies the triangles, possibly none. On success the caller owns *tree. */
enum pp_status pp_ray_tree_create(struct pp_ray_tree **tree,
                                  const struct pp_ray_triangle *triangles, int count,
                                  struct pp_error *err);
void pp_ray_tree_destroy(struct pp_ray_tree *tree); /* NULL is allowed */

/* Owner of the first triangle, seen from either side, along the ray from `from` towards
 * `to` (unit), and its distance. Ignores the triangles of owner `but` (-1: none). -1
 * and INFINITY if no triangle is met. */
int pp_ray_tree_first(const struct pp_ray_tree *tree, struct pp_vec3 from,
                      struct pp_vec3 to, int but, double *distance);

#endif
