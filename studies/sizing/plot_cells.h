/* plot_cells.h - divides the plot of a block into cells, each with a separate height.
 *
 * The cells are nearly square, in rows along the longest side of the plot's outline.
 * They are 1 m wide, or 1/12 of the extent of the plot if that is more. Only cells that
 * are completely inside the outline can be built on.
 */
#ifndef PP_STUDIES_SIZING_PLOT_CELLS_H
#define PP_STUDIES_SIZING_PLOT_CELLS_H

#include "model/base/error.h"
#include "model/room/building.h"

struct pp_plot_cells {
    struct pp_building_cell *list; /* row by row; rows run along the longest side */
    int count;
    int columns, rows;         /* size of the plot's bounding rectangle, in cells */
    int *columns_of, *rows_of; /* column and row of each cell, from 0 */
};

/* Divides the plot into cells with heights of 0. PP_BAD_INPUT if no cell is completely
 * inside the plot. The caller clears *cells, also after a failure. */
enum pp_status pp_plot_cells_lay(struct pp_plot_cells *cells,
                                 const struct pp_building *building, const char *block,
                                 struct pp_error *err);

/* Corner k (0 to 3) of the base of a cell, counter-clockwise. */
struct pp_vec3 pp_plot_cells_corner(const struct pp_building_cell *cell, int k);

void pp_plot_cells_clear(struct pp_plot_cells *cells);

#endif
