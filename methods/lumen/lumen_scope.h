/* lumen_scope.h - the rooms and openings that the lumen method covers. */
#ifndef PP_METHODS_LUMEN_LUMEN_SCOPE_H
#define PP_METHODS_LUMEN_LUMEN_SCOPE_H

#include "model/room/world.h"

/* Reason why the method does not cover a room, as a sentence; NULL if the room is
 * covered. The room must be a box with a horizontal ceiling, without free-standing or
 * self-luminous surfaces, and with a floor reflectance of 0.10 to 0.50 (the tables have
 * 0.30). */
const char *pp_lumen_scope_refuses_room(const struct pp_world *world);

/* Reason why the method does not cover an opening of a covered room, as the end of a
 * sentence that begins with the opening; NULL if the opening is covered. A window must
 * be a vertical rectangle of clear glass without obstructions. Its sill must be within
 * 0.30 m of the working plane, and the depth of its reveal at most a fifth of its
 * height. The window must be at the same height as the other windows of its wall. It
 * must be at most its own height away from the ends of the wall, and at most twice its
 * height away from its neighbours. The windows of a room must be in one wall or two
 * opposite ones. A rooflight must be horizontal, and no point of the plan may be
 * farther from the nearest rooflight than the height of the ceiling above the working
 * plane. */
const char *pp_lumen_scope_refuses_opening(const struct pp_world *world,
                                           const struct pp_opening *opening);

/* True if a covered opening is a rooflight, false for a window. */
bool pp_lumen_scope_is_rooflight(const struct pp_opening *opening);

/* The size of a covered room (m): along the opening's wall and away from that wall. For
 * a rooflight, the two sides of the plan. */
void pp_lumen_scope_room_size(double *width_m, double *depth_m,
                              const struct pp_world *world,
                              const struct pp_opening *opening);

/* Reflectances of a covered room: that of the ceiling, and the mean of the walls
 * without the face `left_out` (index; -1: none is left out). */
double pp_lumen_scope_ceiling_reflectance(const struct pp_world *world);
double pp_lumen_scope_wall_reflectance(const struct pp_world *world, int left_out);

#endif
