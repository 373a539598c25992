/* scene_skylines.h - skylines without a distance, as met by rays. (A skyline with a
 * distance is a surface.)
 *
 * Such a skyline hides the directions u with
 *
 *     0 < u.z < tan(angle) (u.o)
 *
 * where o is the horizontal outward normal of the skyline's wall. This is the limit of
 * an infinitely wide vertical face at increasing distance and height. Its light is part
 * of the environment (environment.h).
 */
#ifndef PP_SIMULATE_SCENE_SCENE_SKYLINES_H
#define PP_SIMULATE_SCENE_SCENE_SKYLINES_H

#include "model/base/error.h"
#include "model/room/world.h"

struct pp_far_skyline {
    struct pp_vec3 outward; /* horizontal unit vector towards the skyline */
    double slope;           /* tangent of the skyline's angle */
    double reflectance;
};

struct pp_scene_skylines {
    struct pp_far_skyline *far;
    int far_count;
};

enum pp_status pp_scene_skylines_init(struct pp_scene_skylines *skylines,
                                      const struct pp_world *world,
                                      struct pp_error *err);
void pp_scene_skylines_clear(struct pp_scene_skylines *skylines);

/* The skyline that hides the direction u (unit, above the horizon); -1: none. */
int pp_scene_skylines_far(const struct pp_scene_skylines *skylines, struct pp_vec3 u);

#endif
