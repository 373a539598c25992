/* sky_cells.h - divides a sky into cells that contribute equally to the horizontal
 * illuminance.
 *
 * Cells lie in rings between two altitudes, from the zenith downwards. They are as
 * nearly square as a whole number of equal cells allows; within a ring they are
 * separated by bearings. Each cell contributes 1/count, to 1e-6.
 */
#ifndef PP_MODEL_LIGHT_SKY_CELLS_H
#define PP_MODEL_LIGHT_SKY_CELLS_H

#include "model/light/sky.h"

/* Angles in rad: altitudes 0 to pi/2, bearings clockwise from +y, 0 to 2 pi. A cell at
 * the zenith has all bearings. */
struct pp_sky_cell {
    double low, high;         /* altitudes */
    double from, to;          /* bearings */
    double altitude, bearing; /* centre: half of the light is above, and half to the
                               * left */
};

/* Divides the sky into count cells, 1 to 10000; the caller frees *cells. */
enum pp_status pp_sky_cells(struct pp_sky_cell **cells, const struct pp_sky *sky,
                            int count, struct pp_error *err);

#endif
