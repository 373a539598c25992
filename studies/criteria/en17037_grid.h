/* en17037_grid.h - how densely EN 17037 wants the reference plane to be covered. */
#ifndef PP_STUDIES_CRITERIA_EN17037_GRID_H
#define PP_STUDIES_CRITERIA_EN17037_GRID_H

#include "model/base/error.h"
#include "model/room/world.h"

/* Largest distance of neighbouring points (m), after [EN17037] annex B:
 *
 *     p = 0.5 * 5^(log10 d),   at most 10 m
 *
 * d is the longer side of the plane, or the shorter one where the longer is twice as
 * long or more (m, both greater than 0). */
double pp_en17037_grid_spacing(double width_m, double depth_m);

/* en17037_grid.h - the points at which EN 17037 wants daylight factors.
 */

/* The margin along the walls that the standard leaves out (m). */
#define PP_EN17037_GRID_MARGIN_M 0.5

enum { PP_EN17037_GRID_MOST = 20000 };

/* Points of the working plane, facing up, in equal cells no larger than
 * pp_en17037_grid_spacing of its extent less the margin, at their centres; those that lie
 * within the plane, not nearer to its edge than the margin, and where one can measure.
 * None in a room too small or too large (more than PP_EN17037_GRID_MOST cells) for it.
 * *receivers is the caller's to free. */
enum pp_status pp_en17037_grid(struct pp_receiver **receivers, int *count,
                               const struct pp_world *world, struct pp_error *err);

#endif
