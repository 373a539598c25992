/* region.c - area, contained points and edge distance, by sums over the rings of a
 * region. */
#include "model/geometry/region.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/geometry/tolerance.h"

double pp_region_ring_area(const double (*xy)[2], int count)
{
    /* Coordinates are relative to the first point, so that a small ring far from the
     * origin keeps its accuracy. */
    double twice = 0.0;
    for (int i = 1; i + 1 < count; i++)
        twice += (xy[i][0] - xy[0][0]) * (xy[i + 1][1] - xy[0][1])
                 - (xy[i + 1][0] - xy[0][0]) * (xy[i][1] - xy[0][1]);
    return twice / 2.0;
}

enum pp_status pp_region_copy(struct pp_region *copy, const struct pp_region *region,
                              struct pp_error *err)
{
    *copy = (struct pp_region){0};
    if (region->count == 0)
        return PP_OK;
    copy->rings = calloc((size_t)region->count, sizeof *copy->rings);
    if (!copy->rings)
        return pp_fail_memory(err);
    for (int i = 0; i < region->count; i++) {
        size_t size = (size_t)region->rings[i].count * sizeof *region->rings[i].xy;
        double(*xy)[2] = malloc(size);
        if (!xy) {
            pp_region_clear(copy);
            return pp_fail_memory(err);
        }
        memcpy(xy, region->rings[i].xy, size);
        copy->rings[copy->count++] = (struct pp_ring){region->rings[i].count, xy};
    }
    return PP_OK;
}

void pp_region_clear(struct pp_region *region)
{
    for (int i = 0; i < region->count; i++)
        free(region->rings[i].xy);
    free(region->rings);
    *region = (struct pp_region){0};
}

double pp_region_area(const struct pp_region *region)
{
    double area = 0.0;
    for (int i = 0; i < region->count; i++)
        area += pp_region_ring_area((const double(*)[2])region->rings[i].xy,
                                    region->rings[i].count);
    return area;
}

struct pp_bounds2 pp_region_bounds(const struct pp_region *region)
{
    struct pp_bounds2 bounds = pp_bounds2_empty();
    for (int r = 0; r < region->count; r++)
        for (int i = 0; i < region->rings[r].count; i++)
            pp_bounds2_add(&bounds, region->rings[r].xy[i][0],
                           region->rings[r].xy[i][1]);
    return bounds;
}

bool pp_region_ring_is_upright(const double (*xy)[2], int count,
                               const struct pp_bounds2 *bounds)
{
    if (count != 4)
        return false;
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 2; k++)
            if (fmin(fabs(xy[i][k] - bounds->low[k]), fabs(xy[i][k] - bounds->high[k]))
                > PP_ROUNDING_M)
                return false;
    return true;
}

bool pp_region_contains(const struct pp_region *region, double x, double y)
{
    /* Even-odd rule: counts edges crossed by the ray towards +x. */
    bool inside = false;
    for (int r = 0; r < region->count; r++) {
        const struct pp_ring *ring = &region->rings[r];
        for (int i = 0, k = ring->count - 1; i < ring->count; k = i++) {
            const double *a = ring->xy[k], *b = ring->xy[i];
            if ((a[1] > y) != (b[1] > y)
                && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
                inside = !inside;
        }
    }
    return inside;
}

int pp_region_count_inside(const struct pp_region *region, double (*points)[2],
                           int count)
{
    const struct pp_bounds2 box = pp_region_bounds(region);
    int inside = 0;
    for (int i = 0; i < count; i++) {
        double x = points[i][0], y = points[i][1];
        bool near =
            x >= box.low[0] && x <= box.high[0] && y >= box.low[1] && y <= box.high[1];
        inside += near && pp_region_contains(region, x, y);
    }
    return inside;
}

double pp_region_edge_distance(const struct pp_region *region, double x, double y)
{
    double nearest = INFINITY;
    for (int r = 0; r < region->count; r++) {
        const struct pp_ring *ring = &region->rings[r];
        for (int i = 0, k = ring->count - 1; i < ring->count; k = i++) {
            double ex = ring->xy[i][0] - ring->xy[k][0];
            double ey = ring->xy[i][1] - ring->xy[k][1];
            double px = x - ring->xy[k][0], py = y - ring->xy[k][1];
            double length2 = ex * ex + ey * ey;
            double t = length2 > 0.0 ? (px * ex + py * ey) / length2 : 0.0;
            t = fmin(fmax(t, 0.0), 1.0);
            nearest = fmin(nearest, hypot(px - t * ex, py - t * ey));
        }
    }
    return nearest;
}
