/* clipper.c - see clipper.h. */
#include "model/geometry/clipper.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/geometry/geos_region.h"
#include "model/geometry/late_geos.h"

struct pp_clipper {
    struct pp_late_geos geos; /* without a context as long as none is needed */
    double grid;              /* 0: none */
    char said[256];           /* GEOS's own words on the last failure */
};

static void keep_message(const char *message, void *clipper)
{
    snprintf(((struct pp_clipper *)clipper)->said,
             sizeof((struct pp_clipper *)clipper)->said, "%s", message);
}

enum pp_status pp_clipper_create(struct pp_clipper **clipper, struct pp_error *err)
{
    *clipper = calloc(1, sizeof **clipper);
    return *clipper ? PP_OK : pp_fail_memory(err);
}

static enum pp_status need_geos(struct pp_clipper *clipper, struct pp_error *err)
{
    return clipper->geos.context
               ? PP_OK
               : pp_late_geos_load(&clipper->geos, keep_message, clipper, err);
}

void pp_clipper_destroy(struct pp_clipper *clipper)
{
    if (!clipper)
        return;
    pp_late_geos_finish(&clipper->geos);
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
                   clipper->said[0] ? clipper->said : "no reason given");
}

/* ---- regions of rings ---- */

/* Does the ring turn one way at every corner, by more than rounding, and round once? */
static bool is_convex(const double (*xy)[2], int count)
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
    const struct pp_late_geos *geos = &clipper->geos;
    *simple = is_convex(xy, count);
    if (*simple || count < 3 || pp_region_ring_area(xy, count) == 0.0)
        return PP_OK;
    enum pp_status status = need_geos(clipper, err);
    if (status != PP_OK)
        return status;
    GEOSGeometry *ring = pp_geos_region_ring(geos, xy, count);
    if (!ring)
        return pp_fail_memory(err);
    GEOSGeometry *polygon =
        geos->call.GEOSGeom_createPolygon_r(geos->context, ring, NULL, 0);
    if (!polygon)
        return pp_fail_memory(err);
    *simple = geos->call.GEOSisValid_r(geos->context, polygon) == 1;
    geos->call.GEOSGeom_destroy_r(geos->context, polygon);
    return PP_OK;
}

/* The figure of a ring that is simple. */
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
        return pp_fail(err, PP_BAD_INPUT, "the outline meets or crosses itself");
    return simple_ring(region, xy, count, err);
}

/* The faces that the closed line divides the plane into; NULL on failure. */
static GEOSGeometry *faces_of(const struct pp_late_geos *geos, const double (*xy)[2],
                              int count)
{
    GEOSGeometry *line = pp_geos_region_ring(geos, xy, count), *faces = NULL;
    GEOSGeometry *pieces =
        line ? geos->call.GEOSUnaryUnion_r(geos->context, line) : NULL;
    if (pieces)
        faces = geos->call.GEOSPolygonize_r(geos->context,
                                            (const GEOSGeometry *const *)&pieces, 1);
    if (pieces)
        geos->call.GEOSGeom_destroy_r(geos->context, pieces);
    if (line)
        geos->call.GEOSGeom_destroy_r(geos->context, line);
    return faces;
}

/* Is the face's inside that of the line, by crossings? */
static bool is_crossed_oddly(const struct pp_late_geos *geos, const GEOSGeometry *face,
                             const struct pp_region *line)
{
    double x, y;
    GEOSGeometry *point = geos->call.GEOSPointOnSurface_r(geos->context, face);
    bool inside = point && geos->call.GEOSGeomGetX_r(geos->context, point, &x) == 1
                  && geos->call.GEOSGeomGetY_r(geos->context, point, &y) == 1
                  && pp_region_contains(line, x, y);
    if (point)
        geos->call.GEOSGeom_destroy_r(geos->context, point);
    return inside;
}

enum pp_status pp_clipper_by_crossings(struct pp_clipper *clipper,
                                       struct pp_region *region, const double (*xy)[2],
                                       int count, struct pp_error *err)
{
    const struct pp_late_geos *geos = &clipper->geos;
    *region = (struct pp_region){0};
    if (count < 3)
        return PP_OK;
    bool simple;
    enum pp_status status = pp_clipper_ring_is_simple(&simple, clipper, xy, count, err);
    if (status == PP_OK && simple)
        return simple_ring(region, xy, count, err);
    if (status == PP_OK)
        status = need_geos(clipper, err);
    if (status != PP_OK)
        return status;
    GEOSGeometry *faces = faces_of(geos, xy, count);
    if (!faces)
        return fail_geos(clipper, "finding the faces of an outline", err);
    int face_count = geos->call.GEOSGetNumGeometries_r(geos->context, faces), found = 0;
    struct pp_region *inside = calloc((size_t)face_count + 1, sizeof *inside);
    struct pp_ring ring = {count, (double(*)[2])xy};
    status = inside ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < face_count && status == PP_OK; i++) {
        const GEOSGeometry *face =
            geos->call.GEOSGetGeometryN_r(geos->context, faces, i);
        if (!is_crossed_oddly(geos, face, &(struct pp_region){1, &ring}))
            continue;
        GEOSGeometry *copy = geos->call.GEOSGeom_clone_r(geos->context, face);
        status =
            copy ? pp_geos_region_from(&inside[found++], geos, copy, clipper->grid, err)
                 : pp_fail_memory(err);
    }
    if (status == PP_OK)
        status = pp_clipper_union(clipper, region, inside, found, err);
    for (int i = 0; i < found; i++)
        pp_region_clear(&inside[i]);
    free(inside);
    geos->call.GEOSGeom_destroy_r(geos->context, faces);
    return status;
}

/* ---- union, intersection, difference ---- */

enum pp_status pp_clipper_union(struct pp_clipper *clipper, struct pp_region *result,
                                const struct pp_region *parts, int count,
                                struct pp_error *err)
{
    const struct pp_late_geos *geos = &clipper->geos;
    *result = (struct pp_region){0};
    enum pp_status status = need_geos(clipper, err);
    if (status != PP_OK)
        return status;
    GEOSGeometry *all = pp_geos_region_polygons(geos, parts, count);
    if (!all)
        return pp_fail_memory(err);
    GEOSGeometry *one =
        clipper->grid > 0.0
            ? geos->call.GEOSUnaryUnionPrec_r(geos->context, all, clipper->grid)
            : geos->call.GEOSUnaryUnion_r(geos->context, all);
    geos->call.GEOSGeom_destroy_r(geos->context, all);
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
                              overlay_function **how, grid_function **how_on_grid,
                              const char *what, struct pp_error *err)
{
    const struct pp_late_geos *geos = &clipper->geos;
    *result = (struct pp_region){0};
    enum pp_status status = need_geos(clipper, err);
    if (status != PP_OK)
        return status;
    GEOSGeometry *one = pp_geos_region_polygons(geos, a, 1);
    GEOSGeometry *other = pp_geos_region_polygons(geos, b, 1);
    GEOSGeometry *shape = NULL;
    bool whole = one && other;
    if (whole)
        shape = clipper->grid > 0.0
                    ? (*how_on_grid)(geos->context, one, other, clipper->grid)
                    : (*how)(geos->context, one, other);
    if (one)
        geos->call.GEOSGeom_destroy_r(geos->context, one);
    if (other)
        geos->call.GEOSGeom_destroy_r(geos->context, other);
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
    return overlay(clipper, result, a, b, &clipper->geos.call.GEOSIntersection_r,
                   &clipper->geos.call.GEOSIntersectionPrec_r,
                   "the intersection of outlines", err);
}

enum pp_status pp_clipper_difference(struct pp_clipper *clipper,
                                     struct pp_region *result,
                                     const struct pp_region *a,
                                     const struct pp_region *minus,
                                     struct pp_error *err)
{
    return overlay(clipper, result, a, minus, &clipper->geos.call.GEOSDifference_r,
                   &clipper->geos.call.GEOSDifferencePrec_r,
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

enum pp_status pp_clipper_inset(struct pp_clipper *clipper, struct pp_region *result,
                                const struct pp_region *region, double distance,
                                struct pp_error *err)
{
    enum { ARC_POINTS = 8 };             /* of a quarter circle: there is none */
    static const double LONGEST = 100.0; /* of a corner, over the distance */
    const struct pp_late_geos *geos = &clipper->geos;
    *result = (struct pp_region){0};
    enum pp_status status = need_geos(clipper, err);
    if (status != PP_OK)
        return status;
    GEOSGeometry *whole = pp_geos_region_polygons(geos, region, 1);
    if (!whole)
        return pp_fail_memory(err);
    GEOSGeometry *inside =
        geos->call.GEOSBufferWithStyle_r(geos->context, whole, -distance, ARC_POINTS,
                                         GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE, LONGEST);
    geos->call.GEOSGeom_destroy_r(geos->context, whole);
    if (!inside)
        return fail_geos(clipper, "the inside of an outline", err);
    return pp_geos_region_from(result, geos, inside, clipper->grid, err);
}

/* Delaunay: the diagonal 0-2 is taken unless the circle through corners 0, 1 and 2 holds
 * corner 3 by more than rounding. Corners run counter-clockwise. */
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

/* The same of a convex ring of three or four corners, without GEOS, which takes longer to
 * load than most rooms need it. */
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

enum pp_status pp_clipper_triangulate(struct pp_clipper *clipper,
                                      double (**triangles)[3][2], int *count,
                                      const struct pp_region *region,
                                      struct pp_error *err)
{
    const struct pp_late_geos *geos = &clipper->geos;
    *triangles = NULL;
    *count = 0;
    if (region->count == 0)
        return PP_OK;
    const struct pp_ring *first = &region->rings[0];
    if (region->count == 1 && first->count <= 4 && !(clipper->grid > 0.0)
        && is_convex((const double(*)[2])first->xy, first->count))
        return cut_convex(triangles, count, first, err);
    enum pp_status status = need_geos(clipper, err);
    if (status != PP_OK)
        return status;
    GEOSGeometry *shape = pp_geos_region_polygons(geos, region, 1);
    if (!shape)
        return pp_fail_memory(err);
    GEOSGeometry *mesh =
        geos->call.GEOSConstrainedDelaunayTriangulation_r(geos->context, shape);
    geos->call.GEOSGeom_destroy_r(geos->context, shape);
    if (!mesh)
        return fail_geos(clipper, "the triangulation of an outline", err);
    struct pp_region rings;
    status = pp_geos_region_from(&rings, geos, mesh, clipper->grid, err);
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
