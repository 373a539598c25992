/* plane_wedges.c - cuts convex pieces of the plane into wedges, along the lines from
 * the apex of each opening through their corners. */
#include "methods/average/plane_wedges.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/geometry/clipper.h"

/* Limits of the parts of a wedge: square roots of the fraction of the distance from its
 * near edge to its far edge. */
static const double cuts[] = {0.0, 0.45, 1.0};
enum { CUTS = 2 };

/* Corners and angles nearer than this count as equal (m, radians). */
static const double same = 1e-9;

/* Sine of the slope (0.06 degrees) above which an opening counts as sloping. In plan, a
 * sloping opening lights both sides of its own line. */
static const double upright = 1e-3;

/* ---- where light spreads from ---- */

static void extent_along(double extent[2], const struct pp_polygon *outline,
                         struct pp_vec3 along)
{
    extent[0] = INFINITY;
    extent[1] = -INFINITY;
    for (int i = 0; i < outline->count; i++) {
        double x = pp_vec_dot(outline->vertices[i], along);
        extent[0] = fmin(extent[0], x);
        extent[1] = fmax(extent[1], x);
    }
}

struct pp_plane_centre pp_plane_centre_of(const struct pp_opening *opening)
{
    struct pp_plane_centre centre = {.tan_aside = INFINITY};
    const struct pp_polygon *inner = &opening->inner;
    for (int i = 0; i < inner->count; i++) {
        centre.at[0] += inner->vertices[i].x / inner->count;
        centre.at[1] += inner->vertices[i].y / inner->count;
    }
    memcpy(centre.apex, centre.at, sizeof centre.apex);
    double across = hypot(inner->normal.x, inner->normal.y);
    if (inner->normal.z < -upright || !(across > upright))
        return centre;
    centre.facing[0] = inner->normal.x / across;
    centre.facing[1] = inner->normal.y / across;
    double within[2], without[2], half = 0.5 * opening->width_m, back = half;
    if (opening->reveal_m > 0.0) {
        extent_along(within, inner, opening->along);
        extent_along(without, &opening->outer, opening->along);
        /* In plan, the reveal of a sloping opening is shorter. */
        centre.tan_aside = fmax(within[1] - without[0], without[1] - within[0])
                           / (opening->reveal_m * across);
        back = half / fmin(centre.tan_aside, 1.0);
    }
    for (int axis = 0; axis < 2; axis++)
        centre.apex[axis] -= back * centre.facing[axis];
    return centre;
}

/* ---- convex pieces ---- */

/* A convex polygon; counter-clockwise. */
struct convex {
    int count;
    double (*xy)[2];
};

/* Keeps the part of a convex polygon with normal . p >= offset. Returns its number of
 * corners: at most one more than the input has, for which `out` needs space. */
static int keep_side(double (*out)[2], const double (*xy)[2], int count,
                     const double normal[2], double offset)
{
    int kept = 0;
    for (int i = 0; i < count; i++) {
        const double *p = xy[i], *q = xy[(i + 1) % count];
        double a = normal[0] * p[0] + normal[1] * p[1] - offset;
        double b = normal[0] * q[0] + normal[1] * q[1] - offset;
        if (a >= 0.0)
            memcpy(out[kept++], p, sizeof *out);
        if ((a < 0.0) != (b < 0.0)) {
            double t = a / (a - b);
            out[kept][0] = p[0] + t * (q[0] - p[0]);
            out[kept++][1] = p[1] + t * (q[1] - p[1]);
        }
    }
    return kept;
}

static bool region_is_convex(const struct pp_region *region)
{
    if (region->count != 1)
        return false;
    const struct pp_ring *ring = &region->rings[0];
    for (int i = 0; i < ring->count; i++)
        if (pp_region_turn(ring->xy[i], ring->xy[(i + 1) % ring->count],
                           ring->xy[(i + 2) % ring->count])
            < 0.0)
            return false;
    return true;
}

/* ---- the wedges of one piece ---- */

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/* Distance from the apex, in direction u, to the line through two points. */
static double distance_to(const double edge[2][2], const double apex[2],
                          const double u[2])
{
    double along[2] = {edge[1][0] - edge[0][0], edge[1][1] - edge[0][1]};
    double off[2] = {edge[0][0] - apex[0], edge[0][1] - apex[1]};
    return cross(off, along) / cross(u, along);
}

/* The edges of a piece that a ray from the apex meets, the nearer one first; returns
 * their number, 0 to 2. */
static int edges_met(double edges[2][2][2], const struct convex *piece,
                     const double apex[2], const double u[2])
{
    int met = 0;
    double distances[2] = {0.0};
    for (int i = 0; i < piece->count && met < 2; i++) {
        double edge[2][2], off[2][2];
        for (int end = 0; end < 2; end++)
            for (int axis = 0; axis < 2; axis++) {
                edge[end][axis] = piece->xy[(i + end) % piece->count][axis];
                off[end][axis] = edge[end][axis] - apex[axis];
            }
        if ((cross(u, off[0]) > 0.0) == (cross(u, off[1]) > 0.0))
            continue;
        double distance = distance_to((const double(*)[2])edge, apex, u);
        if (!(distance > same))
            continue;
        int place = met > 0 && distance < distances[0] ? 0 : met;
        if (place < met) {
            memcpy(edges[1], edges[0], sizeof edges[1]);
            distances[1] = distances[0];
        }
        memcpy(edges[place], edge, sizeof edge);
        distances[place] = distance;
        met++;
    }
    return met;
}

static enum pp_status add_wedge(struct pp_plane_wedges *wedges, int centre,
                                const struct convex *piece, const double apex[2],
                                double low_rad, double high_rad, struct pp_error *err)
{
    double middle = 0.5 * (low_rad + high_rad), edges[2][2][2];
    const double u[2] = {cos(middle), sin(middle)};
    int met = high_rad - low_rad > same ? edges_met(edges, piece, apex, u) : 0;
    enum pp_status status = PP_OK;
    for (int i = 0; met > 0 && i < CUTS && status == PP_OK; i++) {
        struct pp_plane_wedge wedge = {.centre = centre,
                                       .apex = {apex[0], apex[1]},
                                       .low_rad = low_rad,
                                       .wide_rad = high_rad - low_rad,
                                       .from_apex = met == 1,
                                       .low = cuts[i],
                                       .wide = cuts[i + 1] - cuts[i]};
        memcpy(wedge.near, edges[0], sizeof wedge.near);
        memcpy(wedge.far, edges[met - 1], sizeof wedge.far);
        status =
            pp_array_append(&wedges->list, wedges->count, sizeof *wedges->list, err);
        if (status == PP_OK)
            wedges->list[wedges->count++] = wedge;
    }
    return status;
}

static int compare_angles(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static bool holds(const struct convex *piece, const double point[2])
{
    for (int i = 0; i < piece->count; i++)
        if (pp_region_turn(piece->xy[i], piece->xy[(i + 1) % piece->count], point)
            <= 0.0)
            return false;
    return true;
}

/* Adds the wedges of a piece. angles: space for one more value than the piece has
 * corners. */
static enum pp_status add_wedges(struct pp_plane_wedges *wedges, int centre,
                                 const struct convex *piece, const double apex[2],
                                 double *angles, struct pp_error *err)
{
    double middle[2] = {0.0, 0.0};
    for (int i = 0; i < piece->count; i++)
        for (int axis = 0; axis < 2; axis++)
            middle[axis] += piece->xy[i][axis] / piece->count;
    /* From an apex outside the piece all corners are within about 90 degrees of its
     * middle. */
    double straight = atan2(middle[1] - apex[1], middle[0] - apex[0]);
    int count = 0;
    for (int i = 0; i < piece->count; i++) {
        double dx = piece->xy[i][0] - apex[0], dy = piece->xy[i][1] - apex[1];
        if (hypot(dx, dy) > same)
            angles[count++] =
                straight + remainder(atan2(dy, dx) - straight, 2.0 * PP_PI);
    }
    qsort(angles, (size_t)count, sizeof *angles, compare_angles);
    if (count > 0 && holds(piece, apex)) {
        angles[count] = angles[0] + 2.0 * PP_PI;
        count++;
    }
    enum pp_status status = PP_OK;
    for (int i = 0; i + 1 < count && status == PP_OK; i++)
        status = add_wedge(wedges, centre, piece, apex, angles[i], angles[i + 1], err);
    return status;
}

/* The part of a piece that an opening lights. buffers: two arrays, each with space for
 * five corners more than the piece has. */
static struct convex lit_part(const struct convex *piece,
                              const struct pp_plane_centre *centre,
                              double (*buffers[2])[2])
{
    const double *n = centre->facing, *apex = centre->apex;
    if (n[0] == 0.0 && n[1] == 0.0)
        return *piece;
    struct convex lit = {keep_side(buffers[0], (const double(*)[2])piece->xy,
                                   piece->count, n,
                                   n[0] * centre->at[0] + n[1] * centre->at[1]),
                         buffers[0]};
    for (int side = -1; side <= 1 && isfinite(centre->tan_aside); side += 2) {
        /* side * aside <= tan_aside * ahead, seen from the apex */
        const double inward[2] = {centre->tan_aside * n[0] - side * n[1],
                                  centre->tan_aside * n[1] + side * n[0]};
        double(*out)[2] = lit.xy == buffers[0] ? buffers[1] : buffers[0];
        lit.count = keep_side(out, (const double(*)[2])lit.xy, lit.count, inward,
                              inward[0] * apex[0] + inward[1] * apex[1]);
        lit.xy = out;
    }
    return lit;
}

static enum pp_status add_wedge_piece(struct pp_plane_wedges *wedges,
                                      const struct convex *piece,
                                      const struct pp_plane_centre *centres, int count,
                                      struct pp_error *err)
{
    size_t most = (size_t)piece->count + 5;
    double(*buffers[2])[2] = {malloc(most * sizeof **buffers),
                              malloc(most * sizeof **buffers)};
    double *angles = malloc(most * sizeof *angles);
    enum pp_status status =
        buffers[0] && buffers[1] && angles ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < count && status == PP_OK; i++) {
        struct convex lit = lit_part(piece, &centres[i], buffers);
        if (lit.count >= 3)
            status = add_wedges(wedges, i, &lit, centres[i].apex, angles, err);
    }
    free(buffers[0]);
    free(buffers[1]);
    free(angles);
    return status;
}

enum pp_status pp_plane_wedges_find(struct pp_plane_wedges *wedges,
                                    const struct pp_region *plane,
                                    const struct pp_plane_centre *centres, int count,
                                    struct pp_error *err)
{
    *wedges = (struct pp_plane_wedges){0};
    if (region_is_convex(plane)) {
        const struct convex whole = {plane->rings[0].count, plane->rings[0].xy};
        return add_wedge_piece(wedges, &whole, centres, count, err);
    }
    struct pp_clipper *clipper = NULL;
    double(*triangles)[3][2] = NULL;
    int triangle_count = 0;
    enum pp_status status = pp_clipper_create(&clipper, err);
    if (status == PP_OK)
        status =
            pp_clipper_triangulate(clipper, &triangles, &triangle_count, plane, err);
    pp_clipper_destroy(clipper);
    for (int i = 0; i < triangle_count && status == PP_OK; i++) {
        double(*t)[2] = triangles[i];
        if (pp_region_turn(t[0], t[1], t[2]) < 0.0) {
            double swap[2] = {t[1][0], t[1][1]};
            memcpy(t[1], t[2], sizeof swap);
            memcpy(t[2], swap, sizeof swap);
        }
        const struct convex triangle = {3, t};
        status = add_wedge_piece(wedges, &triangle, centres, count, err);
    }
    free(triangles);
    return status;
}

double pp_plane_wedge_point(const struct pp_plane_wedge *wedge, const double square[2],
                            double xy[2])
{
    double angle = wedge->low_rad + square[0] * wedge->wide_rad;
    double root = wedge->low + square[1] * wedge->wide;
    const double u[2] = {cos(angle), sin(angle)};
    double far = distance_to(wedge->far, wedge->apex, u);
    double near = wedge->from_apex ? 0.0 : distance_to(wedge->near, wedge->apex, u);
    double r = near + (far - near) * root * root;
    xy[0] = wedge->apex[0] + r * u[0];
    xy[1] = wedge->apex[1] + r * u[1];
    return r * wedge->wide_rad * 2.0 * root * (far - near) * wedge->wide;
}
