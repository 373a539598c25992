/* laid_grid.h - the points of the largest grid of EN 17037, laid out here. */
#ifndef PP_TESTS_LIB_LAID_GRID_H
#define PP_TESTS_LIB_LAID_GRID_H

#include <math.h>

#include "model/room/world.h"

/* Lists the points of the grid of EN 17037: centres of the cells within the plan's
 * extent less 0.5 m. Returns their number; `list` has space for them. */
static inline int lay_out_largest_grid(struct pp_receiver *list,
                                       const struct pp_world *world)
{
    int count = 0;
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    const struct pp_ring *ring = &world->plane.rings[0];
    for (int i = 0; i < ring->count; i++)
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], ring->xy[i][k] + 0.5);
            high[k] = fmax(high[k], ring->xy[i][k] - 0.5);
        }
    double w = high[0] - low[0], d = high[1] - low[1];
    double across = fmax(w, d) < 2.0 * fmin(w, d) ? fmax(w, d) : fmin(w, d);
    double p = 0.5 * pow(across, 0.69897000433601880479); /* log10 5 */
    int nx = (int)ceil(w / p - 1e-9), ny = (int)ceil(d / p - 1e-9);
    for (int j = 0; j < ny; j++)
        for (int i = 0; i < nx; i++) {
            double x = low[0] + (i + 0.5) * w / nx, y = low[1] + (j + 0.5) * d / ny;
            bool clear = pp_region_contains(&world->plane, x, y);
            for (int k = 0; k < ring->count; k++) {
                const double *a = ring->xy[k], *b = ring->xy[(k + 1) % ring->count];
                double ux = b[0] - a[0], uy = b[1] - a[1];
                double t = ((x - a[0]) * ux + (y - a[1]) * uy) / (ux * ux + uy * uy);
                t = fmin(fmax(t, 0.0), 1.0);
                clear &= hypot(x - a[0] - t * ux, y - a[1] - t * uy) > 0.5 - 1e-6;
            }
            if (clear)
                list[count++] = (struct pp_receiver){
                    {x, y, world->working_plane_m}, {0, 0, 1}, 0, 0.0};
        }
    return count;
}

#endif
