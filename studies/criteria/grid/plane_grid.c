/* plane_grid.c - see plane_grid.h. */
#include "studies/criteria/grid/plane_grid.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "model/geometry/bounds.h"
#include "model/geometry/cell_areas.h"
#include "model/geometry/tolerance.h"
#include "model/room/position.h"

static const double default_spacing_m = 0.3;

/* Greatest number of points at the default spacing; larger planes have a larger
 * spacing. */
static const double default_points = 1000.0;

double pp_plane_grid_largest_spacing(double width_m, double depth_m)
{
    double longer = fmax(width_m, depth_m), shorter = fmin(width_m, depth_m);
    double d = longer >= 2.0 * shorter ? shorter : longer;
    return fmin(0.5 * pow(5.0, log10(d)), 10.0);
}

/* True if a receiver can be placed at this point, outside the margin along the
 * walls. */
static bool is_grid_point(const struct pp_world *world, double margin_m, double x,
                          double y)
{
    return pp_region_contains(&world->plane, x, y)
           && pp_region_edge_distance(&world->plane, x, y) >= margin_m - PP_ROUNDING_M
           && !pp_position_receiver_fault(world, pp_vec(x, y, world->working_plane_m),
                                          pp_vec(0.0, 0.0, 1.0));
}

/* Spacing, before any halving, for a rectangle of that extent; sets grid->origin, the
 * source of the spacing. */
static double first_spacing(struct pp_plane_grid *grid, const double extent[2],
                            const struct pp_room *room,
                            const struct pp_grid_choice *choice)
{
    double of_file = room ? pp_room_grid_spacing(room) : NAN;
    if (choice && choice->largest) {
        grid->origin = PP_GRID_LARGEST;
        return pp_plane_grid_largest_spacing(extent[0], extent[1]);
    }
    if (choice && choice->spacing_m > 0.0) {
        grid->origin = PP_GRID_CHOSEN;
        return choice->spacing_m;
    }
    if (isfinite(of_file)) {
        grid->origin = PP_GRID_OF_FILE;
        return of_file;
    }
    grid->origin = PP_GRID_DEFAULT;
    return fmax(default_spacing_m, sqrt(extent[0] * extent[1] / default_points));
}

static enum pp_status add_points(struct pp_plane_grid *grid,
                                 const struct pp_world *world, const double low[2],
                                 struct pp_error *err)
{
    size_t most = (size_t)grid->columns * (size_t)grid->rows;
    const struct pp_cell_grid cells = {{low[0], low[1]},
                                       {grid->cell_m[0], grid->cell_m[1]},
                                       grid->columns,
                                       grid->rows,
                                       grid->margin_m};
    bool *is_point = calloc(most, sizeof *is_point);
    double *areas = calloc(most, sizeof *areas);
    grid->receivers = calloc(most, sizeof *grid->receivers);
    grid->cells = calloc(most, sizeof *grid->cells);
    bool enough = is_point && areas && grid->receivers && grid->cells;
    for (int cell = 0; enough && cell < (int)most; cell++) {
        int i = cell % grid->columns, j = cell / grid->columns;
        double x = low[0] + (i + 0.5) * grid->cell_m[0];
        double y = low[1] + (j + 0.5) * grid->cell_m[1];
        is_point[cell] = is_grid_point(world, grid->margin_m, x, y);
        if (!is_point[cell])
            continue;
        grid->cells[grid->count][0] = i;
        grid->cells[grid->count][1] = j;
        grid->receivers[grid->count++] =
            (struct pp_receiver){.position = pp_vec(x, y, world->working_plane_m),
                                 .normal = pp_vec(0.0, 0.0, 1.0)};
    }
    if (enough)
        pp_cell_areas_find(areas, is_point, &world->plane, &cells);
    for (int k = 0; k < grid->count; k++)
        grid->receivers[k].area_m2 =
            areas[grid->cells[k][1] * grid->columns + grid->cells[k][0]];
    free(areas);
    free(is_point);
    return enough ? PP_OK : pp_fail_memory(err);
}

enum pp_status pp_plane_grid_make(struct pp_plane_grid *grid,
                                  const struct pp_world *world,
                                  const struct pp_room *room,
                                  const struct pp_grid_choice *choice, int halvings,
                                  struct pp_error *err)
{
    const struct pp_bounds2 bounds = pp_region_bounds(&world->plane);
    bool chosen = choice && choice->spacing_m > 0.0 && !choice->largest;
    *grid = (struct pp_plane_grid){.halvings = halvings,
                                   .margin_m = chosen ? choice->margin_m
                                                      : PP_PLANE_GRID_MARGIN_M};
    if (world->plane.count == 0)
        return PP_OK;
    double low[2], extent[2], cells[2];
    for (int k = 0; k < 2; k++) {
        low[k] = bounds.low[k] + grid->margin_m;
        extent[k] = bounds.high[k] - (low[k] + grid->margin_m);
    }
    if (!(extent[0] > PP_ROUNDING_M && extent[1] > PP_ROUNDING_M))
        return PP_OK;
    grid->spacing_m = ldexp(first_spacing(grid, extent, room, choice), -halvings);
    for (int k = 0; k < 2; k++) {
        /* A millionth of a cell is due to rounding: 3.0000001 cells are three. */
        cells[k] = fmax(ceil(extent[k] / grid->spacing_m - 1e-6), 1.0);
        grid->cell_m[k] = extent[k] / cells[k];
    }
    grid->is_too_fine = cells[0] * cells[1] > PP_PLANE_GRID_MOST;
    if (grid->is_too_fine)
        return PP_OK;
    grid->columns = (int)cells[0];
    grid->rows = (int)cells[1];
    return add_points(grid, world, low, err);
}

enum pp_status pp_plane_grid_at_most(struct pp_plane_grid *grid,
                                     const struct pp_world *world, double spacing_m,
                                     double margin_m, int most_cells,
                                     struct pp_error *err)
{
    struct pp_grid_choice choice = {.spacing_m = spacing_m, .margin_m = margin_m};
    for (;;) {
        enum pp_status status = pp_plane_grid_make(grid, world, NULL, &choice, 0, err);
        long cells = (long)grid->columns * grid->rows;
        if (status != PP_OK || cells <= most_cells)
            return status;
        pp_plane_grid_clear(grid);
        choice.spacing_m *= sqrt((double)cells / most_cells) * 1.01;
    }
}

void pp_plane_grid_clear(struct pp_plane_grid *grid)
{
    free(grid->receivers);
    free(grid->cells);
    *grid = (struct pp_plane_grid){0};
}

enum pp_status pp_plane_grid_largest(struct pp_receiver **receivers, int *count,
                                     const struct pp_world *world, struct pp_error *err)
{
    struct pp_plane_grid grid;
    const struct pp_grid_choice largest = {.largest = true};
    enum pp_status status = pp_plane_grid_make(&grid, world, NULL, &largest, 0, err);
    *receivers = grid.receivers;
    *count = grid.count;
    free(grid.cells);
    return status;
}

void pp_plane_grid_words(char words[PP_PLANE_GRID_WORDS],
                         const struct pp_plane_grid *grid)
{
    snprintf(words, PP_PLANE_GRID_WORDS,
             "a grid of %.2f x %.2f m (%d point%s, %g m from the walls%s)",
             grid->cell_m[0], grid->cell_m[1], grid->count, grid->count == 1 ? "" : "s",
             grid->margin_m,
             grid->origin == PP_GRID_LARGEST ? ", the largest permitted" : "");
}
