/* outline.c - see outline.h. */
#include "model/room/build/outline.h"

#include <stdlib.h>

#include "model/geometry/tolerance.h"

static bool is_unread(const struct pp_vertices *vertices)
{
    for (int i = 0; i < vertices->count; i++) {
        struct pp_vec3 v = vertices->list[i];
        if (!isfinite(v.x) || !isfinite(v.y) || !isfinite(v.z))
            return true;
    }
    return false;
}

static bool has_repeated(struct pp_resolver *r, const char *what,
                         const struct pp_vertices *vertices)
{
    bool repeated = false;
    for (int i = 0; i < vertices->count; i++) {
        int before = (i + vertices->count - 1) % vertices->count;
        struct pp_vec3 v = vertices->list[i];
        if (pp_vec_length(pp_vec_sub(v, vertices->list[before])) >= PP_SAME_M)
            continue;
        repeated = true;
        pp_mistakes_add(
            r->mistakes, vertices->lines[i],
            "%s: vertex %d at (%g, %g, %g) is in the same place as vertex %d on line "
            "%d; expected 1 mm or more between them",
            what, i + 1, v.x, v.y, v.z, before + 1, vertices->lines[before]);
    }
    return repeated;
}

static double distance_to_segment(const double p[2], const double a[2],
                                  const double b[2])
{
    double ends[2][2] = {{a[0], a[1]}, {b[0], b[1]}};
    return pp_polygon_ring_edge_distance(ends, 2, p[0], p[1], NULL);
}

/* True if the segments ab and cd cross or come closer than PP_SAME_M. */
static bool segments_meet(const double a[2], const double b[2], const double c[2],
                          const double d[2])
{
    for (int k = 0; k < 2; k++)
        if (fmin(a[k], b[k]) > fmax(c[k], d[k]) + PP_SAME_M
            || fmin(c[k], d[k]) > fmax(a[k], b[k]) + PP_SAME_M)
            return false;
    bool ab_parts = (pp_region_turn(a, b, c) > 0.0) != (pp_region_turn(a, b, d) > 0.0);
    bool cd_parts = (pp_region_turn(c, d, a) > 0.0) != (pp_region_turn(c, d, b) > 0.0);
    return (ab_parts && cd_parts) || distance_to_segment(a, c, d) < PP_SAME_M
           || distance_to_segment(b, c, d) < PP_SAME_M
           || distance_to_segment(c, a, b) < PP_SAME_M
           || distance_to_segment(d, a, b) < PP_SAME_M;
}

/* First two edges that meet where they should not, numbered from 0. Neighbours share a
 * vertex; they meet elsewhere if one runs back over the other. Compares all pairs; the
 * reader limits the number of vertices. */
static bool edges_that_meet(const double (*xy)[2], int count, int *first, int *second)
{
    for (int i = 0; i < count; i++)
        for (int k = i + 1; k < count; k++) {
            const double *a = xy[i], *b = xy[i + 1];
            const double *c = xy[k], *d = xy[(k + 1) % count];
            bool meet;
            if (k == i + 1)
                meet = distance_to_segment(d, a, b) < PP_SAME_M
                       || distance_to_segment(a, c, d) < PP_SAME_M;
            else if (i == 0 && k == count - 1)
                meet = distance_to_segment(c, a, b) < PP_SAME_M
                       || distance_to_segment(b, c, d) < PP_SAME_M;
            else
                meet = segments_meet(a, b, c, d);
            if (meet) {
                *first = i, *second = k;
                return true;
            }
        }
    return false;
}

static bool crosses_itself(struct pp_resolver *r, const char *what, int line,
                           const struct pp_vertices *vertices, struct pp_vec3 normal)
{
    int count = vertices->count;
    double(*xy)[2] = malloc(count * sizeof *xy);
    if (!xy) {
        r->mistakes->truncated = true;
        return true;
    }
    struct pp_vec3 along, up;
    pp_polygon_plane_axes(normal, &along, &up);
    pp_polygon_flatten(vertices->list, count, vertices->list[0], along, up, xy);
    int i = 0, k = 0;
    bool crosses = edges_that_meet(xy, count, &i, &k);
    free(xy);
    if (crosses) {
        struct pp_vec3 a = vertices->list[i], b = vertices->list[k];
        pp_mistakes_add(
            r->mistakes, line,
            "%s: crosses or touches itself; the edge from vertex %d at (%g, %g, "
            "%g) meets the edge from vertex %d at (%g, %g, %g)",
            what, i + 1, a.x, a.y, a.z, k + 1, b.x, b.y, b.z);
    }
    return crosses;
}

/* Unit normal of the largest triangle formed by the first vertex and two consecutive
 * others; zero if all vertices are collinear. This normal is valid also for a bow-tie,
 * whose halves cancel in Newell's sum. */
static struct pp_vec3 largest_triangle(const struct pp_vertices *vertices)
{
    struct pp_vec3 largest = {0.0, 0.0, 0.0};
    double extent = 0.0;
    for (int i = 1; i + 1 < vertices->count; i++) {
        struct pp_vec3 first = pp_vec_sub(vertices->list[i], vertices->list[0]);
        struct pp_vec3 second = pp_vec_sub(vertices->list[i + 1], vertices->list[0]);
        struct pp_vec3 cross = pp_vec_cross(first, second);
        extent = fmax(extent, fmax(pp_vec_length(first), pp_vec_length(second)));
        if (pp_vec_length(cross) > pp_vec_length(largest))
            largest = cross;
    }
    if (pp_vec_length(largest) < PP_SAME_M * extent)
        return pp_vec(0.0, 0.0, 0.0);
    return pp_vec_unit(largest);
}

bool pp_build_outline_is_good(struct pp_resolver *r, const char *what, int line,
                              const struct pp_vertices *vertices)
{
    int count = vertices->count;
    if (is_unread(vertices))
        return false;
    if (count < 3) {
        pp_mistakes_add(r->mistakes, line,
                        "%s: has %d vertices; expected three or more", what, count);
        return false;
    }
    if (has_repeated(r, what, vertices))
        return false;

    struct pp_polygon polygon;
    if (pp_polygon_of(&polygon, vertices->list, count, NULL) != PP_OK) {
        r->mistakes->truncated = true;
        return false;
    }
    double extent = 0.0;
    for (int i = 1; i < count; i++)
        extent = fmax(extent,
                      pp_vec_length(pp_vec_sub(vertices->list[i], vertices->list[0])));
    double uneven = pp_polygon_unevenness(&polygon);
    bool thin = polygon.area_m2 < PP_SAME_M * extent;
    struct pp_vec3 normal = thin ? largest_triangle(vertices) : polygon.normal;
    pp_polygon_clear(&polygon);

    if (!thin && uneven > PP_SAME_M) {
        pp_mistakes_add(r->mistakes, line,
                        "%s: is not planar, because a vertex is %.3g m off the plane; "
                        "expected all vertices within 1 mm of one plane",
                        what, uneven);
        return false;
    }
    if (pp_vec_length(normal) > 0.0 && crosses_itself(r, what, line, vertices, normal))
        return false;
    if (thin) {
        pp_mistakes_add(
            r->mistakes, line,
            "%s: has no area; expected vertices that are not all on one straight line",
            what);
        return false;
    }
    return true;
}
