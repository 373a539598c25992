/* sky_cells.h - a sky divided into cells that give a level plane equally much light.
 *
 * Cells lie in rings between two altitudes, from the zenith down, as near to square as
 * whole numbers of equal cells let them be; in a ring they lie between bearings. Of the
 * whole, each cell gives 1/count, to 1e-6.
 */
#ifndef PP_MODEL_LIGHT_SKY_CELLS_H
#define PP_MODEL_LIGHT_SKY_CELLS_H

#include "model/light/sky.h"

/* Radians: altitudes 0 to pi/2, bearings clockwise from +y, 0 to 2 pi; a cell over the
 * zenith goes all round. */
struct pp_sky_cell {
    double low, high;         /* altitudes */
    double from, to;          /* bearings */
    double altitude, bearing; /* of its middle: half of the light lies above and below,
                               * left and right */
};

/* count cells of the sky, 1 to 10000; *cells is the caller's to free. */
enum pp_status pp_sky_cells(struct pp_sky_cell **cells, const struct pp_sky *sky,
                            int count, struct pp_error *err);

#endif
