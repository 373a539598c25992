/* geos_region.c - see geos_region.h. */
#include "model/geometry/geos_region.h"

#include <math.h>
#include <stdlib.h>

/* ---- from rings and regions to GEOS ---- */

GEOSGeometry *pp_geos_region_ring(GEOSContextHandle_t geos, const double (*xy)[2],
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

/* Makes a polygon of the outer ring `from` and its holes: the rings after it, up to but
 * not including ring `to`. */
static GEOSGeometry *geos_polygon(GEOSContextHandle_t geos,
                                  const struct pp_region *region, int from, int to)
{
    const struct pp_ring *rings = region->rings;
    int hole_count = to - from - 1;
    GEOSGeometry **holes = NULL;
    GEOSGeometry *shell = pp_geos_region_ring(geos, (const double(*)[2])rings[from].xy,
                                              rings[from].count);
    if (!shell)
        return NULL;
    if (hole_count > 0) {
        holes = calloc((size_t)hole_count, sizeof *holes);
        bool whole = holes != NULL;
        for (int i = 0; whole && i < hole_count; i++) {
            const struct pp_ring *ring = &rings[from + 1 + i];
            holes[i] =
                pp_geos_region_ring(geos, (const double(*)[2])ring->xy, ring->count);
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

GEOSGeometry *pp_geos_region_polygons(GEOSContextHandle_t geos,
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

/* ---- from GEOS to regions ---- */

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

/* Appends a ring, counter-clockwise if `outer`, else clockwise. A ring narrower than
 * two grid steps is due to rounding and is left out. */
static bool append_ring(struct pp_region *region, GEOSContextHandle_t geos,
                        const GEOSGeometry *line, bool outer, double grid)
{
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
    if (fabs(area) <= grid * perimeter((const double(*)[2])xy, count)) {
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

static bool append_shape(struct pp_region *region, GEOSContextHandle_t geos,
                         const GEOSGeometry *shape, double grid)
{
    bool whole = true;
    int known = region->count;
    switch (GEOSGeomTypeId_r(geos, shape)) {
    case GEOS_POLYGON:
        if (GEOSisEmpty_r(geos, shape))
            break;
        whole =
            append_ring(region, geos, GEOSGetExteriorRing_r(geos, shape), true, grid);
        for (int i = 0; whole && region->count > known
                        && i < GEOSGetNumInteriorRings_r(geos, shape);
             i++)
            whole = append_ring(region, geos, GEOSGetInteriorRingN_r(geos, shape, i),
                                false, grid);
        break;
    case GEOS_MULTIPOLYGON:
    case GEOS_GEOMETRYCOLLECTION:
        for (int i = 0; whole && i < GEOSGetNumGeometries_r(geos, shape); i++)
            whole =
                append_shape(region, geos, GEOSGetGeometryN_r(geos, shape, i), grid);
        break;
    default:
        break; /* points and lines have no area */
    }
    return whole;
}

enum pp_status pp_geos_region_from(struct pp_region *region, GEOSContextHandle_t geos,
                                   GEOSGeometry *shape, double grid,
                                   struct pp_error *err)
{
    *region = (struct pp_region){0};
    int count = ring_count(geos, shape);
    bool whole = true;
    if (count > 0) {
        region->rings = calloc((size_t)count, sizeof *region->rings);
        whole = region->rings && append_shape(region, geos, shape, grid);
    }
    GEOSGeom_destroy_r(geos, shape);
    if (!whole) {
        pp_region_clear(region);
        return pp_fail_memory(err);
    }
    return PP_OK;
}
