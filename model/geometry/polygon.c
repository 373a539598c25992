/* polygon.c - see polygon.h. */
#include "model/geometry/polygon.h"

#include <stdlib.h>
#include <string.h>

#include "model/geometry/tolerance.h"

struct pp_vec3 pp_polygon_area_vector(const struct pp_vec3 *vertices, int count)
{
    struct pp_vec3 sum = {0.0, 0.0, 0.0};
    for (int i = 1; i + 1 < count; i++)
        sum = pp_vec_add(sum, pp_vec_cross(pp_vec_sub(vertices[i], vertices[0]),
                                           pp_vec_sub(vertices[i + 1], vertices[0])));
    return pp_vec_scale(sum, 0.5);
}

enum pp_status pp_polygon_of(struct pp_polygon *polygon, const struct pp_vec3 *vertices,
                             int count, struct pp_error *err)
{
    *polygon = (struct pp_polygon){.count = count};
    polygon->vertices = calloc(count > 0 ? count : 1, sizeof *vertices);
    if (!polygon->vertices)
        return pp_fail_memory(err);
    if (count > 0)
        memcpy(polygon->vertices, vertices, count * sizeof *vertices);
    pp_polygon_measure(polygon);
    return PP_OK;
}

void pp_polygon_measure(struct pp_polygon *polygon)
{
    struct pp_vec3 area = pp_polygon_area_vector(polygon->vertices, polygon->count);
    double m2 = pp_vec_length(area);
    polygon->area_m2 = m2;
    polygon->normal = pp_vec(0.0, 0.0, 0.0);
    /* Divides instead of scaling, so that a normal along an axis is exactly 1. */
    if (m2 > 0.0)
        polygon->normal = pp_vec(area.x / m2, area.y / m2, area.z / m2);
}

void pp_polygon_clear(struct pp_polygon *polygon)
{
    free(polygon->vertices);
    *polygon = (struct pp_polygon){0};
}

struct pp_vec3 pp_polygon_middle(const struct pp_polygon *polygon)
{
    struct pp_vec3 sum = {0.0, 0.0, 0.0};
    for (int i = 0; i < polygon->count; i++)
        sum = pp_vec_add(sum, pp_vec_sub(polygon->vertices[i], polygon->vertices[0]));
    return pp_vec_along(polygon->vertices[0], 1.0 / polygon->count, sum);
}

double pp_polygon_height(const struct pp_polygon *polygon, struct pp_vec3 point)
{
    return pp_vec_dot(polygon->normal, pp_vec_sub(point, pp_polygon_middle(polygon)));
}

bool pp_polygon_is_before(const struct pp_polygon *polygon,
                          const struct pp_polygon *plane)
{
    const double rounding_m = 1e-7;
    for (int i = 0; i < polygon->count; i++)
        if (pp_vec_dot(plane->normal,
                       pp_vec_sub(polygon->vertices[i], plane->vertices[0]))
            < -rounding_m)
            return false;
    return true;
}

double pp_polygon_unevenness(const struct pp_polygon *polygon)
{
    struct pp_vec3 middle = pp_polygon_middle(polygon);
    double most = 0.0;
    for (int i = 0; i < polygon->count; i++) {
        struct pp_vec3 from = pp_vec_sub(polygon->vertices[i], middle);
        most = fmax(most, fabs(pp_vec_dot(polygon->normal, from)));
    }
    return most;
}

void pp_polygon_plane_axes(struct pp_vec3 normal, struct pp_vec3 *along,
                           struct pp_vec3 *up)
{
    /* z x normal points to the right for a viewer towards whom the normal points. */
    struct pp_vec3 right = pp_vec(-normal.y, normal.x, 0.0);
    if (pp_vec_length(right) < PP_LEVEL_RAD)
        right = pp_vec(fabs(normal.z), 0.0, normal.z < 0.0 ? normal.x : -normal.x);
    *along = pp_vec_unit(right);
    *up = pp_vec_cross(normal, *along);
}

void pp_polygon_flatten(const struct pp_vec3 *vertices, int count,
                        struct pp_vec3 origin, struct pp_vec3 along, struct pp_vec3 up,
                        double (*xy)[2])
{
    for (int i = 0; i < count; i++) {
        struct pp_vec3 from = pp_vec_sub(vertices[i], origin);
        xy[i][0] = pp_vec_dot(along, from);
        xy[i][1] = pp_vec_dot(up, from);
    }
}

double pp_polygon_ring_edge_distance(const double (*xy)[2], int count, double x,
                                     double y, double nearest[2])
{
    double least = INFINITY;
    for (int i = 0; i < count; i++) {
        const double *p = xy[i], *q = xy[(i + 1) % count];
        double ex = q[0] - p[0], ey = q[1] - p[1];
        double length2 = ex * ex + ey * ey;
        double t = length2 > 0.0 ? ((x - p[0]) * ex + (y - p[1]) * ey) / length2 : 0.0;
        t = fmin(fmax(t, 0.0), 1.0);
        double nx = t < 1.0 ? p[0] + t * ex : q[0];
        double ny = t < 1.0 ? p[1] + t * ey : q[1];
        double distance = hypot(x - nx, y - ny);
        if (distance < least) {
            least = distance;
            if (nearest)
                nearest[0] = nx, nearest[1] = ny;
        }
    }
    return least;
}

/* True if a ray in +x crosses an odd number of edges. Edges are half-open, so that a
 * vertex at the height of the point counts once. */
static bool ring_encloses(const double (*xy)[2], int count, double x, double y)
{
    bool inside = false;
    for (int i = 0; i < count; i++) {
        const double *p = xy[i], *q = xy[(i + 1) % count];
        if ((p[1] > y) == (q[1] > y))
            continue;
        const double *low = p[1] < q[1] ? p : q, *high = low == p ? q : p;
        double left_of =
            (high[0] - low[0]) * (y - low[1]) - (x - low[0]) * (high[1] - low[1]);
        if (left_of > 0.0)
            inside = !inside;
    }
    return inside;
}

enum pp_side pp_polygon_ring_side(const double (*xy)[2], int count, double x, double y,
                                  double tolerance)
{
    if (pp_polygon_ring_edge_distance(xy, count, x, y, NULL) <= tolerance)
        return PP_ON_EDGE;
    return ring_encloses(xy, count, x, y) ? PP_INSIDE : PP_OUTSIDE;
}

/* Distance in space from a point to the polygon's edge. */
static double space_edge_distance(const struct pp_polygon *polygon,
                                  struct pp_vec3 point)
{
    double least = INFINITY;
    for (int i = 0; i < polygon->count; i++) {
        struct pp_vec3 p = polygon->vertices[i];
        struct pp_vec3 edge =
            pp_vec_sub(polygon->vertices[(i + 1) % polygon->count], p);
        double length2 = pp_vec_dot(edge, edge);
        double t =
            length2 > 0.0 ? pp_vec_dot(pp_vec_sub(point, p), edge) / length2 : 0.0;
        t = fmin(fmax(t, 0.0), 1.0);
        least = fmin(least, pp_vec_length(pp_vec_sub(point, pp_vec_along(p, t, edge))));
    }
    return least;
}

/* True if the projection of the point, along the axis nearest to the normal, is
 * inside. */
static bool polygon_encloses(const struct pp_polygon *polygon, struct pp_vec3 point)
{
    struct pp_vec3 n = polygon->normal;
    double ax = fabs(n.x), ay = fabs(n.y), az = fabs(n.z);
    int axis = az >= ax && az >= ay ? 2 : ax >= ay ? 0 : 1;
    bool inside = false;
    for (int i = 0; i < polygon->count; i++) {
        struct pp_vec3 ends[2] = {
            pp_vec_sub(polygon->vertices[i], point),
            pp_vec_sub(polygon->vertices[(i + 1) % polygon->count], point)};
        double u[2], v[2];
        for (int k = 0; k < 2; k++) {
            u[k] = axis == 0 ? ends[k].y : ends[k].x;
            v[k] = axis == 2 ? ends[k].y : ends[k].z;
        }
        if ((v[0] > 0.0) == (v[1] > 0.0))
            continue;
        int low = v[0] < v[1] ? 0 : 1, high = 1 - low;
        if (u[low] * (v[high] - v[low]) - v[low] * (u[high] - u[low]) > 0.0)
            inside = !inside;
    }
    return inside;
}

enum pp_side pp_polygon_side(const struct pp_polygon *polygon, struct pp_vec3 point,
                             double tolerance)
{
    double height = pp_polygon_height(polygon, point);
    struct pp_vec3 foot = pp_vec_along(point, -height, polygon->normal);
    if (space_edge_distance(polygon, foot) <= tolerance)
        return PP_ON_EDGE;
    return polygon_encloses(polygon, foot) ? PP_INSIDE : PP_OUTSIDE;
}

double pp_polygon_distance(const struct pp_polygon *polygon, struct pp_vec3 point)
{
    double height = pp_polygon_height(polygon, point);
    if (polygon_encloses(polygon, pp_vec_along(point, -height, polygon->normal)))
        return fabs(height);
    return space_edge_distance(polygon, point);
}
