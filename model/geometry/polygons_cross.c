/* polygons_cross.c - see polygons_cross.h.
 *
 * Each polygon is cut by the other's plane, offset slightly to one side and then to the
 * other. The polygons cross along the intervals, on the intersection line of the two
 * planes, that all four cuts have in common.
 */
#include "model/geometry/polygons_cross.h"

#include <stdlib.h>
#include <string.h>

#include "model/geometry/polygon.h"
#include "model/geometry/tolerance.h"

/* Disjoint intervals along a line, in order: [from, to] pairs. */
struct stretches {
    double (*list)[2];
    int count;
};

/* Intersects the polygon with a plane, and returns intervals along `line`. The plane
 * has the given normal and is at the distance `level` from `origin`. cuts->list has
 * space for half as many intervals as vertices. */
static void cut_polygon(struct stretches *cuts, const struct pp_polygon *polygon,
                        struct pp_vec3 origin, struct pp_vec3 normal, double level,
                        struct pp_vec3 line)
{
    double *ends = (double *)cuts->list;
    int count = 0;
    for (int i = 0; i < polygon->count; i++) {
        struct pp_vec3 p = pp_vec_sub(polygon->vertices[i], origin);
        struct pp_vec3 q =
            pp_vec_sub(polygon->vertices[(i + 1) % polygon->count], origin);
        double over_p = pp_vec_dot(normal, p) - level,
               over_q = pp_vec_dot(normal, q) - level;
        if ((over_p > 0.0) == (over_q > 0.0))
            continue;
        double t = over_p / (over_p - over_q);
        double at = pp_vec_dot(line, p) + t * pp_vec_dot(line, pp_vec_sub(q, p));
        int k = count++;
        for (; k > 0 && ends[k - 1] > at; k--)
            ends[k] = ends[k - 1];
        ends[k] = at;
    }
    cuts->count = count / 2;
}

/* Intersection of two lists of intervals; `both` has space for as many intervals as a
 * and b together. */
static void intersect(struct stretches *both, const struct stretches *a,
                      const struct stretches *b)
{
    both->count = 0;
    for (int i = 0, k = 0; i < a->count && k < b->count;) {
        double from = fmax(a->list[i][0], b->list[k][0]);
        double to = fmin(a->list[i][1], b->list[k][1]);
        if (to > from) {
            both->list[both->count][0] = from;
            both->list[both->count++][1] = to;
        }
        if (a->list[i][1] < b->list[k][1])
            i++;
        else
            k++;
    }
}

/* True if the polygon has vertices clearly on both sides of the other polygon's
 * plane. */
static bool straddles(const struct pp_polygon *polygon, const struct pp_polygon *plane)
{
    bool above = false, below = false;
    struct pp_vec3 middle = pp_polygon_middle(plane);
    for (int i = 0; i < polygon->count; i++) {
        double height =
            pp_vec_dot(plane->normal, pp_vec_sub(polygon->vertices[i], middle));
        above |= height > PP_SAME_M;
        below |= height < -PP_SAME_M;
    }
    return above && below;
}

enum pp_status pp_polygons_cross(bool *cross, const struct pp_polygon *a,
                                 const struct pp_polygon *b, struct pp_vec3 *where,
                                 struct pp_error *err)
{
    *cross = false;
    if (!straddles(a, b) || !straddles(b, a))
        return PP_OK;
    struct pp_vec3 line = pp_vec_cross(a->normal, b->normal);
    if (pp_vec_length(line) < PP_LEVEL_RAD)
        return PP_OK;
    line = pp_vec_unit(line);

    size_t space = (size_t)a->count + b->count;
    double(*buffers)[2] = malloc(3 * space * sizeof *buffers);
    if (!buffers)
        return pp_fail_memory(err);
    struct stretches common = {buffers, 0}, next = {buffers + space, 0},
                     both = {buffers + 2 * space, 0};
    /* Both cuts use one origin, so that their intervals are comparable. */
    struct pp_vec3 origin = pp_polygon_middle(a);
    double b_level = pp_vec_dot(b->normal, pp_vec_sub(pp_polygon_middle(b), origin));
    for (int k = 0; k < 4; k++) {
        double side = k % 2 ? PP_SAME_M : -PP_SAME_M;
        if (k < 2)
            cut_polygon(&next, b, origin, a->normal, side, line);
        else
            cut_polygon(&next, a, origin, b->normal, b_level + side, line);
        if (k == 0) {
            memcpy(common.list, next.list, next.count * sizeof *next.list);
            common.count = next.count;
            continue;
        }
        intersect(&both, &common, &next);
        struct stretches swap = common;
        common = both;
        both = swap;
    }
    for (int i = 0; i < common.count && !*cross; i++) {
        double from = common.list[i][0], to = common.list[i][1];
        *cross = to - from > PP_SAME_M;
        if (!*cross || !where)
            continue;
        /* Point on both planes at the middle of the interval: the line's point nearest
         * to the origin, moved along the line. */
        double c = pp_vec_dot(a->normal, b->normal);
        struct pp_vec3 foot = pp_vec_sub(b->normal, pp_vec_scale(a->normal, c));
        *where = pp_vec_along(pp_vec_along(origin, b_level / (1.0 - c * c), foot),
                              0.5 * (from + to), line);
    }
    free(buffers);
    return PP_OK;
}
