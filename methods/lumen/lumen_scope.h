/* lumen_scope.h - which rooms and openings the lumen method is made for.
 */
#ifndef PP_METHODS_LUMEN_LUMEN_SCOPE_H
#define PP_METHODS_LUMEN_LUMEN_SCOPE_H

#include "model/room/world.h"

/* Why the method says nothing of a room, as a sentence, or NULL: it is no box with a
 * level ceiling, has things standing in it or surfaces that give off light, or its
 * floor is far from the tables' (reflectance 0.10 to 0.50; theirs is 0.30). */
const char *pp_lumen_scope_refuses_room(const struct pp_world *world);

/* Why it does not cover an opening of a room that it does cover, as the end of a
 * sentence that begins with the opening, or NULL. A window is an upright rectangle of
 * clear glass with nothing before it, its sill within 0.30 m of the working plane, its
 * reveal no deeper than a fifth of its height, level with the others in its wall, no
 * more than its height from the wall's ends and twice that from its neighbours; the
 * windows of a room are in one wall or two opposite ones. A rooflight is level; from no
 * point of the plan is the nearest one farther off than it is high above the working
 * plane. */
const char *pp_lumen_scope_refuses_opening(const struct pp_world *world,
                                           const struct pp_opening *opening);

/* Is it a rooflight, and no window? Of a covered opening. */
bool pp_lumen_scope_is_rooflight(const struct pp_opening *opening);

/* A covered room's size as the table wants it (m): along the opening's wall and away
 * from it; of a rooflight the plan's two sides. */
void pp_lumen_scope_room_size(double *width_m, double *depth_m,
                              const struct pp_world *world,
                              const struct pp_opening *opening);

/* A covered room's reflectances: the ceiling's; the mean of the walls but `left_out`, a
 * face's index or -1. */
double pp_lumen_scope_ceiling_reflectance(const struct pp_world *world);
double pp_lumen_scope_wall_reflectance(const struct pp_world *world, int left_out);

#endif
