/* en17037_grid.c - the grid of [EN17037] annex B over a working plane of any form. */
#include "studies/criteria/en17037_grid.h"

#include <math.h>
#include <stdlib.h>

#include "model/geometry/bounds.h"
#include "model/geometry/tolerance.h"
#include "model/room/position.h"

double pp_en17037_grid_spacing(double width_m, double depth_m)
{
    double longer = fmax(width_m, depth_m), shorter = fmin(width_m, depth_m);
    double d = longer >= 2.0 * shorter ? shorter : longer;
    return fmin(0.5 * pow(5.0, log10(d)), 10.0);
}

/* Can a receiver stand there, and is it within the margin? */
static bool is_grid_point(const struct pp_world *world, double x, double y)
{
    return pp_region_contains(&world->plane, x, y)
           && pp_region_edge_distance(&world->plane, x, y)
                  >= PP_EN17037_GRID_MARGIN_M - PP_ROUNDING_M
           && !pp_position_receiver_fault(world, pp_vec(x, y, world->working_plane_m),
                                          pp_vec(0.0, 0.0, 1.0));
}

enum pp_status pp_en17037_grid(struct pp_receiver **receivers, int *count,
                               const struct pp_world *world, struct pp_error *err)
{
    struct pp_bounds2 bounds = pp_bounds2_empty();
    for (int r = 0; r < world->plane.count; r++)
        for (int i = 0; i < world->plane.rings[r].count; i++)
            pp_bounds2_add(&bounds, world->plane.rings[r].xy[i][0],
                           world->plane.rings[r].xy[i][1]);
    double low[2], extent[2];
    for (int k = 0; k < 2; k++) {
        low[k] = bounds.low[k] + PP_EN17037_GRID_MARGIN_M;
        extent[k] = bounds.high[k] - (low[k] + PP_EN17037_GRID_MARGIN_M);
    }
    *receivers = NULL;
    *count = 0;
    if (!(extent[0] > PP_ROUNDING_M && extent[1] > PP_ROUNDING_M))
        return PP_OK;

    /* A millionth of a cell is rounding: 3.0000001 cells are three. */
    double spacing = pp_en17037_grid_spacing(extent[0], extent[1]), cells[2];
    for (int k = 0; k < 2; k++)
        cells[k] = fmax(ceil(extent[k] / spacing - 1e-6), 1.0);
    if (cells[0] * cells[1] > PP_EN17037_GRID_MOST)
        return PP_OK;
    struct pp_receiver *list = calloc((size_t)(cells[0] * cells[1]), sizeof *list);
    if (!list)
        return pp_fail_memory(err);
    for (int j = 0; j < cells[1]; j++)
        for (int i = 0; i < cells[0]; i++) {
            double x = low[0] + (i + 0.5) * extent[0] / cells[0];
            double y = low[1] + (j + 0.5) * extent[1] / cells[1];
            if (is_grid_point(world, x, y))
                list[(*count)++] = (struct pp_receiver){
                    .position = pp_vec(x, y, world->working_plane_m),
                    .normal = pp_vec(0.0, 0.0, 1.0)};
        }
    *receivers = list;
    return PP_OK;
}
