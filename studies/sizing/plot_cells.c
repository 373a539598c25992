/* plot_cells.c - see plot_cells.h. */
#include "studies/sizing/plot_cells.h"

#include <math.h>
#include <stdlib.h>

#include "model/room/placement.h"

static const double least_cell_m = 1.0;
static const double most_cells = 12.0; /* number of cells along the longer extent of the
                                        * plot */
static const double inside_m = 1e-9;   /* distance inside a cell beyond which an edge
                                        * cuts the cell */

/* Outline of a plot, in axes along and across its longest side. */
struct plot {
    struct pp_vec3 *corners;
    int count;
    double rotate_rad;
    double low[2], high[2]; /* extent */
};

static double longest_side(const struct plot *plot)
{
    double most = 0.0, rotate_rad = 0.0;
    for (int i = 0; i < plot->count; i++) {
        struct pp_vec3 side =
            pp_vec_sub(plot->corners[(i + 1) % plot->count], plot->corners[i]);
        double length = hypot(side.x, side.y);
        if (length > most * (1.0 + 1e-9)) {
            most = length;
            rotate_rad = atan2(side.y, side.x);
        }
    }
    return rotate_rad;
}

static void turn_plot(struct plot *plot)
{
    plot->rotate_rad = longest_side(plot);
    for (int a = 0; a < 2; a++) {
        plot->low[a] = INFINITY;
        plot->high[a] = -INFINITY;
    }
    for (int i = 0; i < plot->count; i++) {
        struct pp_vec3 *p = &plot->corners[i];
        *p = pp_placement_turn(*p, -plot->rotate_rad);
        double xy[2] = {p->x, p->y};
        for (int a = 0; a < 2; a++) {
            plot->low[a] = fmin(plot->low[a], xy[a]);
            plot->high[a] = fmax(plot->high[a], xy[a]);
        }
    }
}

/* True if a side of the outline passes through the rectangle (Liang and Barsky). */
static bool is_cut(struct pp_vec3 a, struct pp_vec3 b, const double low[2],
                   const double high[2])
{
    double from[2] = {a.x, a.y}, way[2] = {b.x - a.x, b.y - a.y}, enter = 0.0,
           leave = 1.0;
    for (int k = 0; k < 2; k++) {
        double first = low[k] + inside_m - from[k], last = high[k] - inside_m - from[k];
        if (way[k] == 0.0) {
            if (first >= 0.0 || last <= 0.0)
                return false;
            continue;
        }
        double u = first / way[k], v = last / way[k];
        enter = fmax(enter, fmin(u, v));
        leave = fmin(leave, fmax(u, v));
    }
    return enter < leave;
}

/* True if the point is inside the outline. Counts the sides crossed by a ray along
 * x. */
static bool contains(const struct plot *plot, double x, double y)
{
    bool inside = false;
    for (int i = 0; i < plot->count; i++) {
        struct pp_vec3 a = plot->corners[i], b = plot->corners[(i + 1) % plot->count];
        if ((a.y > y) != (b.y > y) && x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

static bool is_on_plot(const struct plot *plot, const double low[2],
                       const double high[2])
{
    for (int i = 0; i < plot->count; i++)
        if (is_cut(plot->corners[i], plot->corners[(i + 1) % plot->count], low, high))
            return false;
    return contains(plot, 0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]));
}

static void lay_cells(struct pp_plot_cells *cells, const struct plot *plot)
{
    double width_m = (plot->high[0] - plot->low[0]) / cells->columns,
           depth_m = (plot->high[1] - plot->low[1]) / cells->rows;
    for (int row = 0; row < cells->rows; row++)
        for (int column = 0; column < cells->columns; column++) {
            double low[2] = {plot->low[0] + column * width_m,
                             plot->low[1] + row * depth_m};
            double high[2] = {low[0] + width_m, low[1] + depth_m};
            if (!is_on_plot(plot, low, high))
                continue;
            struct pp_vec3 corner = pp_vec(low[0], low[1], plot->corners[0].z);
            cells->columns_of[cells->count] = column;
            cells->rows_of[cells->count] = row;
            cells->list[cells->count++] = (struct pp_building_cell){
                .corner = pp_placement_turn(corner, plot->rotate_rad),
                .width_m = width_m,
                .depth_m = depth_m,
                .rotate_rad = plot->rotate_rad};
        }
}

enum pp_status pp_plot_cells_lay(struct pp_plot_cells *cells,
                                 const struct pp_building *building, const char *block,
                                 struct pp_error *err)
{
    struct plot plot = {0};
    *cells = (struct pp_plot_cells){0};
    enum pp_status status =
        pp_building_block_footprint(&plot.corners, &plot.count, building, block, err);
    if (status != PP_OK)
        return status;
    turn_plot(&plot);
    double width_m = plot.high[0] - plot.low[0], depth_m = plot.high[1] - plot.low[1];
    double cell_m = fmax(least_cell_m, fmax(width_m, depth_m) / most_cells);
    cells->columns = (int)fmax(1.0, round(width_m / cell_m));
    cells->rows = (int)fmax(1.0, round(depth_m / cell_m));
    size_t all = (size_t)cells->columns * (size_t)cells->rows;
    cells->list = calloc(all, sizeof *cells->list);
    cells->columns_of = calloc(all, sizeof *cells->columns_of);
    cells->rows_of = calloc(all, sizeof *cells->rows_of);
    if (!cells->list || !cells->columns_of || !cells->rows_of)
        status = pp_fail_memory(err);
    else
        lay_cells(cells, &plot);
    free(plot.corners);
    if (status == PP_OK && cells->count == 0)
        status = pp_fail(err, PP_BAD_INPUT,
                         "the plot of \"%.60s\" is too narrow for cells of %.2f m",
                         block, cell_m);
    return status;
}

struct pp_vec3 pp_plot_cells_corner(const struct pp_building_cell *cell, int k)
{
    struct pp_vec3 by = pp_vec(k == 1 || k == 2 ? cell->width_m : 0.0,
                               k >= 2 ? cell->depth_m : 0.0, 0.0);
    return pp_vec_add(cell->corner, pp_placement_turn(by, cell->rotate_rad));
}

void pp_plot_cells_clear(struct pp_plot_cells *cells)
{
    free(cells->list);
    free(cells->columns_of);
    free(cells->rows_of);
    *cells = (struct pp_plot_cells){0};
}
