/* clipper.c - see clipper.h. */
#include "model/geometry/clipper.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/geometry/geos_region.h"

struct pp_clipper {
    GEOSContextHandle_t geos;
    double grid;    /* 0: none */
    char said[256]; /* message of GEOS for the last failure */
};

static void keep_message(const char *message, void *clipper)
{
    snprintf(((struct pp_clipper *)clipper)->said,
             sizeof((struct pp_clipper *)clipper)->said, "%s", message);
}

enum pp_status pp_clipper_create(struct pp_clipper **clipper, struct pp_error *err)
{
    *clipper = calloc(1, sizeof **clipper);
    if (!*clipper)
        return pp_fail_memory(err);
    (*clipper)->geos = GEOS_init_r();
    if (!(*clipper)->geos) {
        free(*clipper);
        *clipper = NULL;
        return pp_fail_memory(err);
    }
    GEOSContext_setErrorMessageHandler_r((*clipper)->geos, keep_message, *clipper);
    return PP_OK;
}

void pp_clipper_destroy(struct pp_clipper *clipper)
{
    if (!clipper)
        return;
    GEOS_finish_r(clipper->geos);
    free(clipper);
}

void pp_clipper_set_grid(struct pp_clipper *clipper, double grid)
{
    clipper->grid = grid;
}

static enum pp_status fail_geos(struct pp_clipper *clipper, const char *what,
                                struct pp_error *err)
{
    return pp_fail(err, PP_BAD_INPUT, "%s failed: %s", what,
                   clipper->said[0] ? clipper->said : "the cause is unknown");
}

/* ---- regions of rings ---- */

/* True if the ring turns the same way at every corner, by more than rounding, and makes
 * one full turn. */
static bool ring_is_convex(const double (*xy)[2], int count)
{
    int left = 0, right = 0, over = 0;
    for (int i = 0; i < count; i++) {
        const double *a = xy[i], *b = xy[(i + 1) % count], *c = xy[(i + 2) % count];
        double in[2] = {b[0] - a[0], b[1] - a[1]}, out[2] = {c[0] - b[0], c[1] - b[1]};
        double turn = in[0] * out[1] - in[1] * out[0];
        double least = 1e-12 * hypot(in[0], in[1]) * hypot(out[0], out[1]);
        left += turn > least;
        right += turn < -least;
        over += (in[0] > 0.0) != (out[0] > 0.0);
    }
    return (left == count || right == count) && over == 2;
}

enum pp_status pp_clipper_ring_is_simple(bool *simple, struct pp_clipper *clipper,
                                         const double (*xy)[2], int count,
                                         struct pp_error *err)
{
    GEOSContextHandle_t geos = clipper->geos;
    *simple = ring_is_convex(xy, count);
    if (*simple || count < 3 || pp_region_ring_area(xy, count) == 0.0)
        return PP_OK;
    GEOSGeometry *ring = pp_geos_region_ring(geos, xy, count);
    if (!ring)
        return pp_fail_memory(err);
    GEOSGeometry *polygon = GEOSGeom_createPolygon_r(geos, ring, NULL, 0);
    if (!polygon)
        return pp_fail_memory(err);
    *simple = GEOSisValid_r(geos, polygon) == 1;
    GEOSGeom_destroy_r(geos, polygon);
    return PP_OK;
}

/* Makes the region enclosed by a simple ring. */
static enum pp_status simple_ring(struct pp_region *region, const double (*xy)[2],
                                  int count, struct pp_error *err)
{
    double area = pp_region_ring_area(xy, count);
    region->rings = calloc(1, sizeof *region->rings);
    double(*points)[2] = malloc((size_t)count * sizeof *points);
    if (!region->rings || !points) {
        free(points);
        pp_region_clear(region);
        return pp_fail_memory(err);
    }
    for (int i = 0; i < count; i++)
        memcpy(points[i], xy[area > 0.0 ? i : count - 1 - i], sizeof *points);
    region->rings[0] = (struct pp_ring){count, points};
    region->count = 1;
    return PP_OK;
}

enum pp_status pp_clipper_of_ring(struct pp_clipper *clipper, struct pp_region *region,
                                  const double (*xy)[2], int count,
                                  struct pp_error *err)
{
    *region = (struct pp_region){0};
    if (count < 3 || pp_region_ring_area(xy, count) == 0.0)
        return PP_OK;
    bool simple;
    enum pp_status status = pp_clipper_ring_is_simple(&simple, clipper, xy, count, err);
    if (status != PP_OK)
        return status;
    if (!simple)
        return pp_fail(err, PP_BAD_INPUT, "the outline touches or crosses itself");
    return simple_ring(region, xy, count, err);
}

/* Faces into which the closed line divides the plane; NULL on failure. */
static GEOSGeometry *faces_of(GEOSContextHandle_t geos, const double (*xy)[2],
                              int count)
{
    GEOSGeometry *line = pp_geos_region_ring(geos, xy, count), *faces = NULL;
    GEOSGeometry *pieces = line ? GEOSUnaryUnion_r(geos, line) : NULL;
    if (pieces)
        faces = GEOSPolygonize_r(geos, (const GEOSGeometry *const *)&pieces, 1);
    if (pieces)
        GEOSGeom_destroy_r(geos, pieces);
    if (line)
        GEOSGeom_destroy_r(geos, line);
    return faces;
}

/* True if the interior of the face is inside the line, by the even-odd rule. */
static bool is_crossed_oddly(GEOSContextHandle_t geos, const GEOSGeometry *face,
                             const struct pp_region *line)
{
    double x, y;
    GEOSGeometry *point = GEOSPointOnSurface_r(geos, face);
    bool inside = point && GEOSGeomGetX_r(geos, point, &x) == 1
                  && GEOSGeomGetY_r(geos, point, &y) == 1
                  && pp_region_contains(line, x, y);
    if (point)
        GEOSGeom_destroy_r(geos, point);
    return inside;
}

enum pp_status pp_clipper_by_crossings(struct pp_clipper *clipper,
                                       struct pp_region *region, const double (*xy)[2],
                                       int count, struct pp_error *err)
{
    GEOSContextHandle_t geos = clipper->geos;
    *region = (struct pp_region){0};
    if (count < 3)
        return PP_OK;
    bool simple;
    enum pp_status status = pp_clipper_ring_is_simple(&simple, clipper, xy, count, err);
    if (status == PP_OK && simple)
        return simple_ring(region, xy, count, err);
    if (status != PP_OK)
        return status;
    GEOSGeometry *faces = faces_of(geos, xy, count);
    if (!faces)
        return fail_geos(clipper, "the search for the faces of an outline", err);
    int face_count = GEOSGetNumGeometries_r(geos, faces), found = 0;
    struct pp_region *inside = calloc((size_t)face_count + 1, sizeof *inside);
    struct pp_ring ring = {count, (double(*)[2])xy};
    status = inside ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < face_count && status == PP_OK; i++) {
        const GEOSGeometry *face = GEOSGetGeometryN_r(geos, faces, i);
        if (!is_crossed_oddly(geos, face, &(struct pp_region){1, &ring}))
            continue;
        GEOSGeometry *copy = GEOSGeom_clone_r(geos, face);
        status =
            copy ? pp_geos_region_from(&inside[found++], geos, copy, clipper->grid, err)
                 : pp_fail_memory(err);
    }
    if (status == PP_OK)
        status = pp_clipper_union(clipper, region, inside, found, err);
    for (int i = 0; i < found; i++)
        pp_region_clear(&inside[i]);
    free(inside);
    GEOSGeom_destroy_r(geos, faces);
    return status;
}

/* ---- union, intersection, difference ---- */

enum pp_status pp_clipper_union(struct pp_clipper *clipper, struct pp_region *result,
                                const struct pp_region *parts, int count,
                                struct pp_error *err)
{
    GEOSContextHandle_t geos = clipper->geos;
    *result = (struct pp_region){0};
    GEOSGeometry *all = pp_geos_region_polygons(geos, parts, count);
    if (!all)
        return pp_fail_memory(err);
    GEOSGeometry *one = clipper->grid > 0.0
                            ? GEOSUnaryUnionPrec_r(geos, all, clipper->grid)
                            : GEOSUnaryUnion_r(geos, all);
    GEOSGeom_destroy_r(geos, all);
    if (!one)
        return fail_geos(clipper, "the union of outlines", err);
    return pp_geos_region_from(result, geos, one, clipper->grid, err);
}

typedef GEOSGeometry *overlay_function(GEOSContextHandle_t geos, const GEOSGeometry *a,
                                       const GEOSGeometry *b);
typedef GEOSGeometry *grid_function(GEOSContextHandle_t geos, const GEOSGeometry *a,
                                    const GEOSGeometry *b, double grid);

static enum pp_status overlay(struct pp_clipper *clipper, struct pp_region *result,
                              const struct pp_region *a, const struct pp_region *b,
                              overlay_function *how, grid_function *how_on_grid,
                              const char *what, struct pp_error *err)
{
    GEOSContextHandle_t geos = clipper->geos;
    *result = (struct pp_region){0};
    GEOSGeometry *one = pp_geos_region_polygons(geos, a, 1);
    GEOSGeometry *other = pp_geos_region_polygons(geos, b, 1);
    GEOSGeometry *shape = NULL;
    bool whole = one && other;
    if (whole)
        shape = clipper->grid > 0.0 ? how_on_grid(geos, one, other, clipper->grid)
                                    : how(geos, one, other);
    if (one)
        GEOSGeom_destroy_r(geos, one);
    if (other)
        GEOSGeom_destroy_r(geos, other);
    if (!whole)
        return pp_fail_memory(err);
    if (!shape)
        return fail_geos(clipper, what, err);
    return pp_geos_region_from(result, geos, shape, clipper->grid, err);
}

enum pp_status pp_clipper_intersection(struct pp_clipper *clipper,
                                       struct pp_region *result,
                                       const struct pp_region *a,
                                       const struct pp_region *b, struct pp_error *err)
{
    return overlay(clipper, result, a, b, GEOSIntersection_r, GEOSIntersectionPrec_r,
                   "the intersection of outlines", err);
}

enum pp_status pp_clipper_difference(struct pp_clipper *clipper,
                                     struct pp_region *result,
                                     const struct pp_region *a,
                                     const struct pp_region *minus,
                                     struct pp_error *err)
{
    return overlay(clipper, result, a, minus, GEOSDifference_r, GEOSDifferencePrec_r,
                   "the difference of outlines", err);
}

enum pp_status pp_clipper_take_away(struct pp_clipper *clipper,
                                    struct pp_region *region,
                                    const struct pp_region *minus, struct pp_error *err)
{
    struct pp_region rest = {0};
    enum pp_status status = pp_clipper_difference(clipper, &rest, region, minus, err);
    if (status == PP_OK) {
        pp_region_clear(region);
        *region = rest;
    }
    return status;
}

/* Offsets the outline of a region outwards by a distance, or inwards if negative;
 * corners stay sharp. NULL on failure. */
static GEOSGeometry *widen_figure(GEOSContextHandle_t geos, const GEOSGeometry *figure,
                                  double distance)
{
    enum { ARC_POINTS = 8 };             /* per quarter circle; unused with mitres */
    static const double LONGEST = 100.0; /* mitre limit: length of a sharp corner
                                          * divided by the distance */
    return GEOSBufferWithStyle_r(geos, figure, distance, ARC_POINTS, GEOSBUF_CAP_FLAT,
                                 GEOSBUF_JOIN_MITRE, LONGEST);
}

enum pp_status pp_clipper_inset(struct pp_clipper *clipper, struct pp_region *result,
                                const struct pp_region *region, double distance,
                                struct pp_error *err)
{
    GEOSContextHandle_t geos = clipper->geos;
    *result = (struct pp_region){0};
    GEOSGeometry *whole = pp_geos_region_polygons(geos, region, 1);
    if (!whole)
        return pp_fail_memory(err);
    GEOSGeometry *inside = widen_figure(geos, whole, -distance);
    GEOSGeom_destroy_r(geos, whole);
    if (!inside)
        return fail_geos(clipper, "the inward offset of an outline", err);
    return pp_geos_region_from(result, geos, inside, clipper->grid, err);
}

enum pp_status pp_clipper_close_gaps(struct pp_clipper *clipper,
                                     struct pp_region *result,
                                     const struct pp_region *region, double width,
                                     struct pp_error *err)
{
    GEOSContextHandle_t geos = clipper->geos;
    *result = (struct pp_region){0};
    GEOSGeometry *whole = pp_geos_region_polygons(geos, region, 1);
    if (!whole)
        return pp_fail_memory(err);
    GEOSGeometry *wide = widen_figure(geos, whole, 0.5 * width);
    GEOSGeom_destroy_r(geos, whole);
    GEOSGeometry *closed = wide ? widen_figure(geos, wide, -0.5 * width) : NULL;
    if (wide)
        GEOSGeom_destroy_r(geos, wide);
    if (!closed)
        return fail_geos(clipper, "the closing of gaps", err);
    return pp_geos_region_from(result, geos, closed, clipper->grid, err);
}

/* Delaunay criterion: true for the diagonal 0-2, unless corner 3 is inside the circle
 * through corners 0, 1 and 2 by more than rounding. Corners are counter-clockwise. */
static bool takes_first_diagonal(const double *const p[4])
{
    double x[3], y[3], square[3], scale = 0.0;
    for (int i = 0; i < 3; i++) {
        x[i] = p[i][0] - p[3][0];
        y[i] = p[i][1] - p[3][1];
        square[i] = x[i] * x[i] + y[i] * y[i];
        scale = fmax(scale, square[i]);
    }
    double held = square[0] * (x[1] * y[2] - x[2] * y[1])
                  - square[1] * (x[0] * y[2] - x[2] * y[0])
                  + square[2] * (x[0] * y[1] - x[1] * y[0]);
    return !(held > 1e-12 * scale * scale);
}

/* Triangulates a convex ring of three or four corners, the usual case, without GEOS. */
static enum pp_status cut_convex(double (**triangles)[3][2], int *count,
                                 const struct pp_ring *ring, struct pp_error *err)
{
    static const int cut[2][2][3] = {{{2, 3, 0}, {0, 1, 2}}, {{3, 0, 1}, {1, 2, 3}}};
    int corners = ring->count;
    bool left = pp_region_ring_area((const double(*)[2])ring->xy, corners) > 0.0;
    const double *p[4];
    for (int i = 0; i < corners; i++)
        p[i] = ring->xy[left ? i : corners - 1 - i];
    *triangles = malloc(2 * sizeof **triangles);
    if (!*triangles)
        return pp_fail_memory(err);
    *count = corners - 2;
    const int(*of)[3] = cut[0] + 1;
    if (corners == 4)
        of = cut[takes_first_diagonal(p) ? 0 : 1];
    for (int i = 0; i < *count; i++)
        for (int k = 0; k < 3; k++)
            memcpy((*triangles)[i][k], p[of[i][k]], sizeof(double[2]));
    return PP_OK;
}

/* The vertex of `region` whose counterpart in `turned` is nearest to a corner. */
static const double *vertex_at(const struct pp_region *region,
                               const struct pp_region *turned, const double corner[2])
{
    const double *nearest = NULL;
    double least = INFINITY;
    for (int i = 0; i < turned->count; i++)
        for (int k = 0; k < turned->rings[i].count; k++) {
            const double *at = turned->rings[i].xy[k];
            double distance = hypot(at[0] - corner[0], at[1] - corner[1]);
            if (distance < least) {
                least = distance;
                nearest = region->rings[i].xy[k];
            }
        }
    return nearest;
}

/* Triangulates the region turned by an angle; the triangles have the vertices of the
 * region itself. */
static enum pp_status triangulate_turned(struct pp_clipper *clipper,
                                         struct pp_region *triangles,
                                         const struct pp_region *region,
                                         double turn_rad, struct pp_error *err)
{
    GEOSContextHandle_t geos = clipper->geos;
    double c = cos(turn_rad), s = sin(turn_rad);
    struct pp_region turned;
    enum pp_status status = pp_region_copy(&turned, region, err);
    if (status != PP_OK)
        return status;
    for (int i = 0; i < turned.count; i++)
        for (int k = 0; k < turned.rings[i].count; k++) {
            double *at = turned.rings[i].xy[k], x = at[0], y = at[1];
            at[0] = c * x - s * y;
            at[1] = s * x + c * y;
        }
    GEOSGeometry *shape = pp_geos_region_polygons(geos, &turned, 1);
    GEOSGeometry *mesh =
        shape ? GEOSConstrainedDelaunayTriangulation_r(geos, shape) : NULL;
    if (mesh)
        status = pp_geos_region_from(triangles, geos, mesh, clipper->grid, err);
    else if (shape)
        status = fail_geos(clipper, "the triangulation of an outline", err);
    else
        status = pp_fail_memory(err);
    if (shape)
        GEOSGeom_destroy_r(geos, shape);
    for (int i = 0; status == PP_OK && turn_rad != 0.0 && i < triangles->count; i++)
        for (int k = 0; k < triangles->rings[i].count; k++) {
            double *corner = triangles->rings[i].xy[k];
            memcpy(corner, vertex_at(region, &turned, corner), sizeof(double[2]));
        }
    pp_region_clear(&turned);
    return status;
}

enum pp_status pp_clipper_triangulate(struct pp_clipper *clipper,
                                      double (**triangles)[3][2], int *count,
                                      const struct pp_region *region,
                                      struct pp_error *err)
{
    /* GEOS 3.11 cannot connect some holes to an outline that has corners at the same
     * coordinate; turned by another angle it can. */
    static const double turns_rad[] = {0.0, 0.3, 0.7, 1.1};
    enum { TURNS = sizeof turns_rad / sizeof *turns_rad };
    *triangles = NULL;
    *count = 0;
    if (region->count == 0)
        return PP_OK;
    const struct pp_ring *first = &region->rings[0];
    if (region->count == 1 && first->count <= 4 && !(clipper->grid > 0.0)
        && ring_is_convex((const double(*)[2])first->xy, first->count))
        return cut_convex(triangles, count, first, err);
    struct pp_region rings;
    enum pp_status status = PP_BAD_INPUT;
    for (int i = 0; i < TURNS && status == PP_BAD_INPUT; i++)
        status = triangulate_turned(clipper, &rings, region, turns_rad[i], err);
    if (status != PP_OK)
        return status;
    double(*list)[3][2] = malloc((size_t)rings.count * sizeof *list + 1);
    if (!list)
        status = pp_fail_memory(err);
    for (int i = 0; list && i < rings.count; i++)
        memcpy(list[(*count)++], rings.rings[i].xy, sizeof *list);
    *triangles = list;
    pp_region_clear(&rings);
    return status;
}
