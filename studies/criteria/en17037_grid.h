/* en17037_grid.h - the grid of points for daylight factors required by [EN17037]. */
#ifndef PP_STUDIES_CRITERIA_EN17037_GRID_H
#define PP_STUDIES_CRITERIA_EN17037_GRID_H

#include "model/base/error.h"
#include "model/room/world.h"

/* The margin along the walls that the standard leaves out (m). */
#define PP_EN17037_GRID_MARGIN_M 0.5

/* Most cells of a room's grid; with more there is none. */
enum { PP_EN17037_GRID_MOST = 20000 };

/* Largest distance of neighbouring points (m), after [EN17037] annex B:
 *
 *     p = 0.5 * 5^(log10 d),   at most 10 m
 *
 * d is the longer side of the plane, or the shorter one where the longer is twice as
 * long or more (m, both greater than 0). */
double pp_en17037_grid_spacing(double width_m, double depth_m);

/* Points of the working plane, facing up. The plane's bounding rectangle, less the
 * margin, is divided into equal cells no larger than pp_en17037_grid_spacing; points are
 * the centres of cells that lie within the plane, not nearer to its edge than the
 * margin, and where a receiver can stand (pp_position_receiver_fault). *count is 0 in a
 * room too small for the margin or too large (PP_EN17037_GRID_MOST). *receivers is the
 * caller's to free. */
enum pp_status pp_en17037_grid(struct pp_receiver **receivers, int *count,
                               const struct pp_world *world, struct pp_error *err);

#endif
