/* cell_areas.h - parts of a region that the centres of grid cells represent.
 *
 * The cells of a rectangular grid do not fit an L-shaped plan: an edge cuts through
 * some of them. The centres then represent unequal areas.
 */
#ifndef PP_MODEL_GEOMETRY_CELL_AREAS_H
#define PP_MODEL_GEOMETRY_CELL_AREAS_H

#include "model/geometry/region.h"

/* Cells over the bounding rectangle of a region, less a margin. */
struct pp_cell_grid {
    double low[2];  /* corner of the first cell */
    double step[2]; /* sides of a cell */
    int columns, rows;
    double margin; /* a strip of this width along the edges of the region is left out */
};

/* Sets areas[row * columns + column] of cells with is_point to the area of the region,
 * less the margin, that is nearer to the centre of this cell than to those of
 * neighbouring cells with is_point; the others have 0. A cell with is_point that lies
 * within the region counts with its whole area, exactly. Along an edge that cuts
 * through cells the boundary is accurate to 1/32 of a cell. Cells whose centre is
 * within the region, but without is_point, are occupied by an object; their area is
 * left out. */
void pp_cell_areas_find(double *areas, const bool *is_point,
                        const struct pp_region *region,
                        const struct pp_cell_grid *grid);

#endif
