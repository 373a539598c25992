/* cell_areas.c - see cell_areas.h. Cells that an edge may cut are divided into 16 x 16
 * parts, whose centres are tested. */
#include "model/geometry/cell_areas.h"

#include <math.h>

#include "model/geometry/tolerance.h"

enum { PARTS = 16 };

static bool is_clear_of_edge(const struct pp_region *region, double margin, double x,
                             double y)
{
    return pp_region_contains(region, x, y)
           && pp_region_edge_distance(region, x, y) >= margin - PP_ROUNDING_M;
}

/* Index of the cell with is_point, in column i and row j or next to it, whose centre is
 * nearest to the point (x, y), given in columns and rows; -1: none. */
static int nearest_point(const bool *is_point, const struct pp_cell_grid *grid, int i,
                         int j, double x, double y)
{
    double least = INFINITY;
    int nearest = -1;
    for (int n = j - 1; n <= j + 1; n++)
        for (int m = i - 1; m <= i + 1; m++) {
            int cell = n * grid->columns + m;
            if (m < 0 || n < 0 || m >= grid->columns || n >= grid->rows
                || !is_point[cell])
                continue;
            double distance =
                hypot((m + 0.5 - x) * grid->step[0], (n + 0.5 - y) * grid->step[1]);
            if (distance < least - PP_ROUNDING_M) {
                least = distance;
                nearest = cell;
            }
        }
    return nearest;
}

/* True if the region is a rectangle along x and y: then no edge cuts a cell. */
static bool has_whole_cells(const struct pp_region *region)
{
    struct pp_bounds2 bounds = pp_region_bounds(region);
    const struct pp_ring *ring = region->rings;
    return region->count == 1
           && pp_region_ring_is_upright((const double(*)[2])ring->xy, ring->count,
                                        &bounds);
}

void pp_cell_areas_find(double *areas, const bool *is_point,
                        const struct pp_region *region, const struct pp_cell_grid *grid)
{
    double part = grid->step[0] * grid->step[1] / (PARTS * PARTS);
    double radius = 0.5 * hypot(grid->step[0], grid->step[1]);
    if (has_whole_cells(region)) {
        for (int cell = 0; cell < grid->columns * grid->rows; cell++)
            areas[cell] = is_point[cell] ? grid->step[0] * grid->step[1] : 0.0;
        return;
    }
    for (int cell = 0; cell < grid->columns * grid->rows; cell++)
        areas[cell] = 0.0; /* first the number of parts */
    for (int j = 0; j < grid->rows; j++)
        for (int i = 0; i < grid->columns; i++) {
            int cell = j * grid->columns + i;
            double x = grid->low[0] + (i + 0.5) * grid->step[0];
            double y = grid->low[1] + (j + 0.5) * grid->step[1];
            bool centre = is_clear_of_edge(region, grid->margin, x, y);
            if (centre && is_clear_of_edge(region, grid->margin + radius, x, y)) {
                areas[cell] += is_point[cell] ? PARTS * PARTS : 0.0;
                continue;
            }
            if (centre && !is_point[cell])
                continue;
            for (int k = 0; k < PARTS * PARTS; k++) {
                double u = i + (k % PARTS + 0.5) / PARTS;
                double v = j + (k / PARTS + 0.5) / PARTS;
                if (!is_clear_of_edge(region, grid->margin,
                                      grid->low[0] + u * grid->step[0],
                                      grid->low[1] + v * grid->step[1]))
                    continue;
                int nearest = nearest_point(is_point, grid, i, j, u, v);
                if (nearest >= 0)
                    areas[nearest] += 1.0;
            }
        }
    for (int cell = 0; cell < grid->columns * grid->rows; cell++)
        areas[cell] *= part;
}
