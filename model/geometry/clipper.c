/* clipper.c - see clipper.h. The one file that includes GEOS.
 *
 * A region goes to GEOS as a multipolygon and comes back from it ring by ring, each
 * outer ring followed by its own holes. What GEOS leaves of lower dimension (points
 * and lines where two figures only touch) is dropped.
 */
#include "model/geometry/clipper.h"

#include <geos_c.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct pp_clipper {
    GEOSContextHandle_t geos;
    double grid;    /* 0: none */
    char said[256]; /* GEOS's own words on the last failure */
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
                   clipper->said[0] ? clipper->said : "no reason given");
}

/* ---- rings and regions to GEOS ---- */

/* A closed ring; NULL on failure. count is at least 3. */
static GEOSGeometry *geos_ring(GEOSContextHandle_t geos, const double (*xy)[2],
                               int count)
{
    GEOSCoordSequence *line = GEOSCoordSeq_create_r(geos, (unsigned)count + 1, 2);
    if (!line)
        return NULL;
    for (int i = 0; i <= count; i++)
        GEOSCoordSeq_setXY_r(geos, line, (unsigned)i, xy[i % count][0],
                             xy[i % count][1]);
    return GEOSGeom_createLinearRing_r(geos, line);
}

/* The rings of `region` are `from` (an outer one) and the holes up to `to`. */
static GEOSGeometry *geos_polygon(GEOSContextHandle_t geos,
                                  const struct pp_region *region, int from, int to)
{
    const struct pp_ring *rings = region->rings;
    int hole_count = to - from - 1;
    GEOSGeometry **holes = NULL;
    GEOSGeometry *shell =
        geos_ring(geos, (const double(*)[2])rings[from].xy, rings[from].count);
    if (!shell)
        return NULL;
    if (hole_count > 0) {
        holes = calloc((size_t)hole_count, sizeof *holes);
        bool whole = holes != NULL;
        for (int i = 0; whole && i < hole_count; i++) {
            const struct pp_ring *ring = &rings[from + 1 + i];
            holes[i] = geos_ring(geos, (const double(*)[2])ring->xy, ring->count);
            whole = holes[i] != NULL;
        }
        if (!whole) {
            for (int i = 0; holes && i < hole_count; i++)
                if (holes[i])
                    GEOSGeom_destroy_r(geos, holes[i]);
            free(holes);
            GEOSGeom_destroy_r(geos, shell);
            return NULL;
        }
    }
    GEOSGeometry *polygon =
        GEOSGeom_createPolygon_r(geos, shell, holes, (unsigned)hole_count);
    free(holes);
    return polygon;
}

/* All of `count` regions as one collection of polygons; NULL on failure. */
static GEOSGeometry *geos_polygons(GEOSContextHandle_t geos,
                                   const struct pp_region *regions, int count)
{
    int rings = 0, polygons = 0;
    for (int i = 0; i < count; i++)
        rings += regions[i].count;
    GEOSGeometry **list = calloc((size_t)rings + 1, sizeof *list);
    if (!list)
        return NULL;
    bool whole = true;
    for (int i = 0; whole && i < count; i++) {
        const struct pp_region *region = &regions[i];
        for (int from = 0, to; whole && from < region->count; from = to) {
            to = from + 1;
            while (to < region->count
                   && pp_region_ring_area((const double(*)[2])region->rings[to].xy,
                                          region->rings[to].count)
                          < 0.0)
                to++;
            list[polygons] = geos_polygon(geos, region, from, to);
            whole = list[polygons] != NULL;
            if (whole)
                polygons++;
        }
    }
    GEOSGeometry *all = NULL;
    if (whole)
        all = GEOSGeom_createCollection_r(geos, GEOS_MULTIPOLYGON, list,
                                          (unsigned)polygons);
    else
        for (int i = 0; i < polygons; i++)
            GEOSGeom_destroy_r(geos, list[i]);
    free(list);
    return all;
}

/* ---- GEOS to regions ---- */

static int ring_count(GEOSContextHandle_t geos, const GEOSGeometry *shape)
{
    int count = 0;
    switch (GEOSGeomTypeId_r(geos, shape)) {
    case GEOS_POLYGON:
        if (!GEOSisEmpty_r(geos, shape))
            count = 1 + GEOSGetNumInteriorRings_r(geos, shape);
        break;
    case GEOS_MULTIPOLYGON:
    case GEOS_GEOMETRYCOLLECTION:
        for (int i = 0; i < GEOSGetNumGeometries_r(geos, shape); i++)
            count += ring_count(geos, GEOSGetGeometryN_r(geos, shape, i));
        break;
    default:
        break;
    }
    return count;
}

static double perimeter(const double (*xy)[2], int count)
{
    double sum = 0.0;
    for (int i = 0, k = count - 1; i < count; k = i++)
        sum += hypot(xy[i][0] - xy[k][0], xy[i][1] - xy[k][1]);
    return sum;
}

/* Appends one ring, turned the way `outer` asks for; one that is less than two steps of
 * the grid wide is rounding and left out. */
static bool append_ring(const struct pp_clipper *clipper, struct pp_region *region,
                        const GEOSGeometry *line, bool outer)
{
    GEOSContextHandle_t geos = clipper->geos;
    const GEOSCoordSequence *points = GEOSGeom_getCoordSeq_r(geos, line);
    unsigned size = 0;
    if (!points || !GEOSCoordSeq_getSize_r(geos, points, &size))
        return false;
    if (size < 4)
        return true;
    int count = (int)size - 1;
    double(*xy)[2] = malloc((size_t)count * sizeof *xy);
    if (!xy)
        return false;
    for (int i = 0; i < count; i++)
        GEOSCoordSeq_getXY_r(geos, points, (unsigned)i, &xy[i][0], &xy[i][1]);
    double area = pp_region_ring_area((const double(*)[2])xy, count);
    if (fabs(area) <= clipper->grid * perimeter((const double(*)[2])xy, count)) {
        free(xy);
        return true;
    }
    if ((area > 0.0) != outer)
        for (int i = 0, k = count - 1; i < k; i++, k--)
            for (int axis = 0; axis < 2; axis++) {
                double swap = xy[i][axis];
                xy[i][axis] = xy[k][axis];
                xy[k][axis] = swap;
            }
    region->rings[region->count++] = (struct pp_ring){count, xy};
    return true;
}

static bool append_shape(const struct pp_clipper *clipper, struct pp_region *region,
                         const GEOSGeometry *shape)
{
    GEOSContextHandle_t geos = clipper->geos;
    bool whole = true;
    int known = region->count;
    switch (GEOSGeomTypeId_r(geos, shape)) {
    case GEOS_POLYGON:
        if (GEOSisEmpty_r(geos, shape))
            break;
        whole = append_ring(clipper, region, GEOSGetExteriorRing_r(geos, shape), true);
        for (int i = 0; whole && region->count > known
                        && i < GEOSGetNumInteriorRings_r(geos, shape);
             i++)
            whole = append_ring(clipper, region, GEOSGetInteriorRingN_r(geos, shape, i),
                                false);
        break;
    case GEOS_MULTIPOLYGON:
    case GEOS_GEOMETRYCOLLECTION:
        for (int i = 0; whole && i < GEOSGetNumGeometries_r(geos, shape); i++)
            whole = append_shape(clipper, region, GEOSGetGeometryN_r(geos, shape, i));
        break;
    default:
        break; /* points and lines have no area */
    }
    return whole;
}

/* Turns shape into *region and destroys it. */
static enum pp_status region_from(struct pp_clipper *clipper, struct pp_region *region,
                                  GEOSGeometry *shape, struct pp_error *err)
{
    *region = (struct pp_region){0};
    int count = ring_count(clipper->geos, shape);
    bool whole = true;
    if (count > 0) {
        region->rings = calloc((size_t)count, sizeof *region->rings);
        whole = region->rings && append_shape(clipper, region, shape);
    }
    GEOSGeom_destroy_r(clipper->geos, shape);
    if (!whole) {
        pp_region_clear(region);
        return pp_fail_memory(err);
    }
    return PP_OK;
}

/* ---- regions of rings ---- */

bool pp_clipper_ring_is_simple(struct pp_clipper *clipper, const double (*xy)[2],
                               int count)
{
    if (count < 3 || pp_region_ring_area(xy, count) == 0.0)
        return false;
    GEOSGeometry *ring = geos_ring(clipper->geos, xy, count);
    if (!ring)
        return false;
    GEOSGeometry *polygon = GEOSGeom_createPolygon_r(clipper->geos, ring, NULL, 0);
    bool simple = polygon && GEOSisValid_r(clipper->geos, polygon) == 1;
    if (polygon)
        GEOSGeom_destroy_r(clipper->geos, polygon);
    return simple;
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
    if (!pp_clipper_ring_is_simple(clipper, xy, count))
        return pp_fail(err, PP_BAD_INPUT, "the outline meets or crosses itself");
    return simple_ring(region, xy, count, err);
}

/* The faces that the closed line divides the plane into; NULL on failure. */
static GEOSGeometry *faces_of(GEOSContextHandle_t geos, const double (*xy)[2],
                              int count)
{
    GEOSGeometry *line = geos_ring(geos, xy, count), *faces = NULL;
    GEOSGeometry *pieces = line ? GEOSUnaryUnion_r(geos, line) : NULL;
    if (pieces)
        faces = GEOSPolygonize_r(geos, (const GEOSGeometry *const *)&pieces, 1);
    if (pieces)
        GEOSGeom_destroy_r(geos, pieces);
    if (line)
        GEOSGeom_destroy_r(geos, line);
    return faces;
}

/* Is the face's inside that of the line, by crossings? */
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
    if (pp_clipper_ring_is_simple(clipper, xy, count))
        return simple_ring(region, xy, count, err);
    GEOSGeometry *faces = faces_of(geos, xy, count);
    if (!faces)
        return fail_geos(clipper, "finding the faces of an outline", err);
    int face_count = GEOSGetNumGeometries_r(geos, faces), found = 0;
    struct pp_region *inside = calloc((size_t)face_count + 1, sizeof *inside);
    struct pp_ring ring = {count, (double(*)[2])xy};
    enum pp_status status = inside ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < face_count && status == PP_OK; i++) {
        const GEOSGeometry *face = GEOSGetGeometryN_r(geos, faces, i);
        if (!is_crossed_oddly(geos, face, &(struct pp_region){1, &ring}))
            continue;
        GEOSGeometry *copy = GEOSGeom_clone_r(geos, face);
        status = copy ? region_from(clipper, &inside[found++], copy, err)
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
    *result = (struct pp_region){0};
    GEOSGeometry *all = geos_polygons(clipper->geos, parts, count);
    if (!all)
        return pp_fail_memory(err);
    GEOSGeometry *one = clipper->grid > 0.0
                            ? GEOSUnaryUnionPrec_r(clipper->geos, all, clipper->grid)
                            : GEOSUnaryUnion_r(clipper->geos, all);
    GEOSGeom_destroy_r(clipper->geos, all);
    if (!one)
        return fail_geos(clipper, "the union of outlines", err);
    return region_from(clipper, result, one, err);
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
    *result = (struct pp_region){0};
    GEOSGeometry *one = geos_polygons(clipper->geos, a, 1);
    GEOSGeometry *other = geos_polygons(clipper->geos, b, 1);
    GEOSGeometry *shape = NULL;
    bool whole = one && other;
    if (whole)
        shape = clipper->grid > 0.0
                    ? how_on_grid(clipper->geos, one, other, clipper->grid)
                    : how(clipper->geos, one, other);
    if (one)
        GEOSGeom_destroy_r(clipper->geos, one);
    if (other)
        GEOSGeom_destroy_r(clipper->geos, other);
    if (!whole)
        return pp_fail_memory(err);
    if (!shape)
        return fail_geos(clipper, what, err);
    return region_from(clipper, result, shape, err);
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

enum pp_status pp_clipper_inset(struct pp_clipper *clipper, struct pp_region *result,
                                const struct pp_region *region, double distance,
                                struct pp_error *err)
{
    enum { ARC_POINTS = 8 };             /* of a quarter circle: there is none */
    static const double LONGEST = 100.0; /* of a corner, over the distance */
    *result = (struct pp_region){0};
    GEOSGeometry *whole = geos_polygons(clipper->geos, region, 1);
    if (!whole)
        return pp_fail_memory(err);
    GEOSGeometry *inside =
        GEOSBufferWithStyle_r(clipper->geos, whole, -distance, ARC_POINTS,
                              GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE, LONGEST);
    GEOSGeom_destroy_r(clipper->geos, whole);
    if (!inside)
        return fail_geos(clipper, "the inside of an outline", err);
    return region_from(clipper, result, inside, err);
}

enum pp_status pp_clipper_triangulate(struct pp_clipper *clipper,
                                      double (**triangles)[3][2], int *count,
                                      const struct pp_region *region,
                                      struct pp_error *err)
{
    GEOSContextHandle_t geos = clipper->geos;
    *triangles = NULL;
    *count = 0;
    if (region->count == 0)
        return PP_OK;
    GEOSGeometry *shape = geos_polygons(geos, region, 1);
    if (!shape)
        return pp_fail_memory(err);
    GEOSGeometry *mesh = GEOSConstrainedDelaunayTriangulation_r(geos, shape);
    GEOSGeom_destroy_r(geos, shape);
    if (!mesh)
        return fail_geos(clipper, "the triangulation of an outline", err);
    struct pp_region rings;
    enum pp_status status = region_from(clipper, &rings, mesh, err);
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
