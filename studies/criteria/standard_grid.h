/* standard_grid.h - the points at which EN 17037 wants daylight factors.
 */
#ifndef PP_DESIGN_STANDARD_GRID_H
#define PP_DESIGN_STANDARD_GRID_H

#include "model/base/error.h"
#include "model/room/world.h"

/* The margin along the walls that the standard leaves out (m). */
#define PP_STANDARD_MARGIN_M 0.5

enum { PP_STANDARD_POINTS = 20000 };

/* Points of the working plane, facing up, in equal cells no larger than
 * pp_en17037_spacing of its extent less the margin, at their centres; those that lie
 * within the plane, not nearer to its edge than the margin, and where one can measure.
 * None in a room too small or too large (more than PP_STANDARD_POINTS cells) for it.
 * *receivers is the caller's to free. */
enum pp_status pp_standard_grid(struct pp_receiver **receivers, int *count,
                                const struct pp_world *world, struct pp_error *err);

#endif
