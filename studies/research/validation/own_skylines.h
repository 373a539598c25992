/* own_skylines.h - the obstructions that formulae assume if they use one obstruction
 * angle of an opening: `bre` and its variants, `split-flux`, `sphere`, the average
 * daylight factor.
 *
 * These methods assume an infinitely long skyline in front of each wall. The skyline is
 * so far away that its angle is the same from every point. Its reflectance is 0.2, the
 * value contained in the printed factors. The angle is the mean of the angles of the
 * wall's openings (methods/reflected/obstruction.h), weighted by area. Walls that face
 * the same direction share one skyline, since the skyline of each wall would also be
 * visible through the openings of the others. Sky hidden by the room's own walls stays
 * hidden. The skyline hides as much light as the obstructions hide in addition to these
 * walls.
 *
 * There is no skyline for a horizontal opening; for a roof window, there is one only if
 * a wall faces the same direction. If an opening without a skyline has an obstruction,
 * the room's real surroundings are kept.
 */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_OWN_SKYLINES_H
#define PP_STUDIES_RESEARCH_VALIDATION_OWN_SKYLINES_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/room/building.h"
#include "model/room/world.h"

struct pp_own_skyline {
    const char *wall; /* name of the wall; owned by the world */
    double angle_rad;
};

struct pp_own_skylines {
    bool
        as_they_are; /* the room's own surroundings are already of this form, or must be
                      * kept */
    struct pp_own_skyline *list; /* one for each wall whose openings have an
                                  * obstruction, unless as_they_are */
    int count;
};

/* Finds the skylines. bare: the world of the room without obstructions. light: weights
 * the hidden directions. On success the caller clears *skylines. */
enum pp_status pp_own_skylines_of(struct pp_own_skylines *skylines,
                                  const struct pp_world *world,
                                  const struct pp_world *bare,
                                  const struct pp_outside_light *light,
                                  struct pp_error *err);
void pp_own_skylines_clear(struct pp_own_skylines *skylines);

/* Adds the skylines to a room without surroundings. */
enum pp_status pp_own_skylines_put(const struct pp_own_skylines *skylines,
                                   struct pp_room *room, struct pp_error *err);

#endif
