/* own_skylines.h - what stands outside a room as the formulae have it that know one angle
 * of an opening's obstruction: `bre` and its kin, `split-flux`, `sphere`, the average
 * daylight factor.
 *
 * It is an endless skyline before each wall, so far away that its angle is the same from
 * every point, with the reflectance 0.2 that is built into the printed factors. Its angle
 * is the mean of the angles of the wall's openings (methods/reflected/obstruction.h), by
 * their areas; walls that face the same way have one skyline between them, as each would
 * show through the other's openings. What the room's own walls hide of the sky stays
 * where it is, and its share of the light is taken from what the skyline hides.
 *
 * A level opening has no side for a skyline, and glass in a roof needs a wall that faces
 * its way: where one of them has something outside before it, the room's surroundings stay
 * as they are.
 */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_OWN_SKYLINES_H
#define PP_STUDIES_RESEARCH_VALIDATION_OWN_SKYLINES_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/room/building.h"
#include "model/room/world.h"

struct pp_own_skyline {
    const char *wall; /* its name; the world's */
    double angle_rad;
};

struct pp_own_skylines {
    bool
        as_they_are; /* the room's own surroundings are these, or stay in their place */
    struct pp_own_skyline *list; /* of the walls with an angle, unless as_they_are */
    int count;
};

/* bare: the world of the room without obstructions; light: the weight of hidden
 * directions. On success the caller clears *skylines. */
enum pp_status pp_own_skylines_of(struct pp_own_skylines *skylines,
                                  const struct pp_world *world,
                                  const struct pp_world *bare,
                                  const struct pp_outside_light *light,
                                  struct pp_error *err);
void pp_own_skylines_clear(struct pp_own_skylines *skylines);

/* Puts them into a room that has nothing outside. */
enum pp_status pp_own_skylines_put(const struct pp_own_skylines *skylines,
                                   struct pp_room *room, struct pp_error *err);

#endif
