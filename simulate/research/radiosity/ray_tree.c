/* ray_tree.c - boxes divided at the median triangle along their longest side. */
#include "simulate/research/radiosity/ray_tree.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "model/geometry/bounds.h"

enum { LEAF = 4, DEEPEST = 64 };

struct box {
    struct pp_bounds3 bounds;
    int first, count; /* range of triangles; if count is 0: two boxes, at first and
                       * first + 1 */
};

struct pp_ray_tree {
    struct pp_ray_triangle *triangles; /* in the order of the boxes */
    int count;
    struct box *boxes;
    int box_count;
};

static double along(struct pp_vec3 v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static struct pp_bounds3 triangles_bounds(const struct pp_ray_triangle *triangles,
                                          int count)
{
    struct pp_bounds3 bounds = pp_bounds3_empty();
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 3; k++)
            pp_bounds3_add(&bounds, triangles[i].corners[k]);
    return bounds;
}

static double middle(const struct pp_ray_triangle *triangle, int axis)
{
    return along(triangle->corners[0], axis) + along(triangle->corners[1], axis)
           + along(triangle->corners[2], axis);
}

/* Partitions the triangles at the median along the axis (quickselect). */
static void halve(struct pp_ray_triangle *triangles, int count, int axis)
{
    int low = 0, high = count - 1, half = count / 2;
    while (low < high) {
        double pivot = middle(&triangles[low + (high - low) / 2], axis);
        int i = low, k = high;
        while (i <= k) {
            while (middle(&triangles[i], axis) < pivot)
                i++;
            while (middle(&triangles[k], axis) > pivot)
                k--;
            if (i <= k) {
                struct pp_ray_triangle other = triangles[i];
                triangles[i++] = triangles[k];
                triangles[k--] = other;
            }
        }
        if (half <= k)
            high = k;
        else if (half >= i)
            low = i;
        else
            return;
    }
}

static void build_ray_node(struct pp_ray_tree *tree, int at, int first, int count)
{
    struct pp_ray_triangle *mine = &tree->triangles[first];
    struct pp_bounds3 bounds = triangles_bounds(mine, count);
    struct pp_vec3 size = pp_vec_sub(bounds.high, bounds.low);
    int axis = size.y > size.x ? 1 : 0;
    if (size.z > along(size, axis))
        axis = 2;
    tree->boxes[at] = (struct box){bounds, first, count};
    if (count <= LEAF)
        return;
    int below = tree->box_count, half = count / 2;
    tree->box_count += 2;
    tree->boxes[at].first = below;
    tree->boxes[at].count = 0;
    halve(mine, count, axis);
    build_ray_node(tree, below, first, half);
    build_ray_node(tree, below + 1, first + half, count - half);
}

enum pp_status pp_ray_tree_create(struct pp_ray_tree **result,
                                  const struct pp_ray_triangle *triangles, int count,
                                  struct pp_error *err)
{
    *result = NULL;
    struct pp_ray_tree *tree = calloc(1, sizeof *tree);
    if (!tree)
        return pp_fail_memory(err);
    tree->triangles = malloc(((size_t)count + 1) * sizeof *tree->triangles);
    tree->boxes = malloc(((size_t)count * 2 + 1) * sizeof *tree->boxes);
    if (!tree->triangles || !tree->boxes) {
        pp_ray_tree_destroy(tree);
        return pp_fail_memory(err);
    }
    if (count > 0)
        memcpy(tree->triangles, triangles, (size_t)count * sizeof *triangles);
    tree->count = count;
    tree->box_count = 1;
    build_ray_node(tree, 0, 0, count);
    *result = tree;
    return PP_OK;
}

void pp_ray_tree_destroy(struct pp_ray_tree *tree)
{
    if (!tree)
        return;
    free(tree->triangles);
    free(tree->boxes);
    free(tree);
}

/* A ray, with the reciprocals of its direction for tests of boxes. */
struct ray {
    struct pp_vec3 from, to, inverse;
};

/* Distance at which the ray enters the box; INFINITY if it never enters, or only beyond
 * `far_m`. */
static double enters(const struct ray *ray, const struct pp_bounds3 *box, double far_m)
{
    double near_m = 0.0;
    for (int axis = 0; axis < 3; axis++) {
        double inverse = along(ray->inverse, axis), from = along(ray->from, axis);
        double a = (along(box->low, axis) - from) * inverse;
        double b = (along(box->high, axis) - from) * inverse;
        /* 0 times infinity is NaN: a ray in a box's plane counts as inside. */
        if (a > b) {
            double other = a;
            a = b;
            b = other;
        }
        if (a > near_m)
            near_m = a;
        if (b < far_m)
            far_m = b;
    }
    return near_m <= far_m * (1.0 + 1e-14) ? near_m : INFINITY;
}

/* Distance to a triangle [MT97]; INFINITY: none. */
static double meets(const struct ray *ray, const struct pp_ray_triangle *triangle)
{
    struct pp_vec3 e1 = pp_vec_sub(triangle->corners[1], triangle->corners[0]);
    struct pp_vec3 e2 = pp_vec_sub(triangle->corners[2], triangle->corners[0]);
    struct pp_vec3 p = pp_vec_cross(ray->to, e2);
    double determinant = pp_vec_dot(e1, p);
    if (determinant == 0.0)
        return INFINITY;
    struct pp_vec3 s = pp_vec_sub(ray->from, triangle->corners[0]);
    double u = pp_vec_dot(s, p) / determinant;
    struct pp_vec3 q = pp_vec_cross(s, e1);
    double v = pp_vec_dot(ray->to, q) / determinant;
    /* Triangles are enlarged by rounding error, so that neighbours leave no gap. */
    if (u < -1e-12 || v < -1e-12 || u + v > 1.0 + 1e-12)
        return INFINITY;
    double distance = pp_vec_dot(e2, q) / determinant;
    return distance > 1e-9 ? distance : INFINITY;
}

static void find_first_hit(const struct pp_ray_tree *tree, const struct box *box,
                           const struct ray *ray, int but, int *owner, double *distance)
{
    for (int i = box->first; i < box->first + box->count; i++) {
        const struct pp_ray_triangle *triangle = &tree->triangles[i];
        double t = triangle->owner == but ? INFINITY : meets(ray, triangle);
        if (t < *distance
            || (t == *distance && t < INFINITY && triangle->owner < *owner)) {
            *distance = t;
            *owner = triangle->owner;
        }
    }
}

int pp_ray_tree_first(const struct pp_ray_tree *tree, struct pp_vec3 from,
                      struct pp_vec3 to, int but, double *distance)
{
    struct ray ray = {from, to, pp_vec(1.0 / to.x, 1.0 / to.y, 1.0 / to.z)};
    int waiting[DEEPEST], count = 0, owner = -1;
    double entered[DEEPEST];
    *distance = INFINITY;
    waiting[count] = 0;
    entered[count++] = enters(&ray, &tree->boxes[0].bounds, INFINITY);
    while (count > 0) {
        const struct box *box = &tree->boxes[waiting[--count]];
        if (entered[count] == INFINITY || entered[count] > *distance)
            continue;
        if (box->count > 0 || tree->count == 0) {
            find_first_hit(tree, box, &ray, but, &owner, distance);
            continue;
        }
        double a = enters(&ray, &tree->boxes[box->first].bounds, *distance);
        double b = enters(&ray, &tree->boxes[box->first + 1].bounds, *distance);
        bool b_first = b < a;
        waiting[count] = box->first + (b_first ? 0 : 1);
        entered[count++] = b_first ? a : b;
        waiting[count] = box->first + (b_first ? 1 : 0);
        entered[count++] = b_first ? b : a;
    }
    return owner;
}
