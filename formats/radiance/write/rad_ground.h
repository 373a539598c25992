/* rad_ground.h - the ground outside as a surface of a scene: a disc.
 *
 * It is diffuse and lies at the level of ground.h, about the middle of the room, a fifth
 * of a millimetre lower, so that floors and surfaces on the ground stand out. Its radius
 * is 100 times the way to what is farthest of all that stands there: what lies beyond is
 * seen within 0.6 degrees below the horizon, and less than a thousandth of its sky is
 * hidden. Where the room reaches below it, it has a hole of the room's section.
 */
#ifndef PP_FORMATS_RADIANCE_WRITE_RAD_GROUND_H
#define PP_FORMATS_RADIANCE_WRITE_RAD_GROUND_H

#include "model/light/scene_description.h"
#include "model/room/world.h"

enum pp_status pp_rad_ground_add(struct pp_scene_description *scene,
                                 const struct pp_world *world, double reflectance,
                                 struct pp_error *err);

#endif
