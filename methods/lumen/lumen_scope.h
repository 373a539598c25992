/* lumen_scope.h - which rooms and openings the lumen method is made for.
 */
#ifndef PP_METHODS_LUMEN_LUMEN_SCOPE_H
#define PP_METHODS_LUMEN_LUMEN_SCOPE_H

#include "model/room/world.h"

/* Why the method does not apply to a room, as a sentence, or NULL: the room is no box
 * with a level ceiling, has free-standing or self-luminous surfaces, or its floor
 * reflectance is not 0.10 to 0.50 (the tables have 0.30). */
const char *pp_lumen_scope_refuses_room(const struct pp_world *world);

/* Reason why the method does not cover an opening of a covered room, as the end of a
 * sentence that begins with the opening, or NULL. A window must be a vertical rectangle
 * of clear glass without obstructions. Its sill must be within 0.30 m of the working
 * plane, and its reveal at most a fifth of its height deep. It must be level with the
 * other windows of its wall, at most its height from the wall's ends and twice that
 * from its neighbours. The windows of a room must be in one wall or two opposite ones.
 * A rooflight must be level, and no point of the plan farther from the nearest
 * rooflight than the ceiling is high above the working plane. */
const char *pp_lumen_scope_refuses_opening(const struct pp_world *world,
                                           const struct pp_opening *opening);

/* True if a covered opening is a rooflight, false for a window. */
bool pp_lumen_scope_is_rooflight(const struct pp_opening *opening);

/* The size of a covered room (m): along the opening's wall and away from that wall; for
 * a rooflight the two sides of the plan. */
void pp_lumen_scope_room_size(double *width_m, double *depth_m,
                              const struct pp_world *world,
                              const struct pp_opening *opening);

/* Reflectances of a covered room: of the ceiling, and the mean of the walls without the
 * face `left_out` (its index, or -1). */
double pp_lumen_scope_ceiling_reflectance(const struct pp_world *world);
double pp_lumen_scope_wall_reflectance(const struct pp_world *world, int left_out);

#endif
