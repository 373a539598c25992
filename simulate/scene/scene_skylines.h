/* scene_skylines.h - a world's skylines as rays meet them: endless vertical faces.
 *
 * Without a distance a skyline hides the directions u with
 *
 *     0 < u.z < tan(angle) (u.o)
 *
 * o the outward horizontal of its wall: the limit of a face ever farther away and
 * higher. With a distance it stands on the ground at that distance from its wall and is
 * met at a point, from either side. What light they give is the environment's
 * (environment.h).
 */
#ifndef PP_SIMULATE_SCENE_SCENE_SKYLINES_H
#define PP_SIMULATE_SCENE_SCENE_SKYLINES_H

#include "model/base/error.h"
#include "model/room/world.h"

struct pp_far_skyline {
    struct pp_vec3 outward; /* horizontal, unit: towards it */
    double slope;           /* tangent of its angle */
    double reflectance;
};

struct pp_near_skyline {
    struct pp_vec3 outward;
    double offset_m; /* outward . x of its points */
    double head_m;   /* z of its upper edge */
    double reflectance;
};

struct pp_scene_skylines {
    double ground_level_m;
    struct pp_far_skyline *far;
    int far_count;
    struct pp_near_skyline *near;
    int near_count;
};

/* Lengths and points are measured from `centre`. */
enum pp_status pp_scene_skylines_init(struct pp_scene_skylines *skylines,
                                      const struct pp_world *world,
                                      struct pp_vec3 centre, struct pp_error *err);
void pp_scene_skylines_clear(struct pp_scene_skylines *skylines);

/* The distance at which the ray from p along u (unit) meets a near skyline: *met, on
 * the side towards its wall (*side 0) or the other (1). INFINITY if it meets none. */
double pp_scene_skylines_near(const struct pp_scene_skylines *skylines,
                              struct pp_vec3 p, struct pp_vec3 u, int *met, int *side);

/* The far skyline that hides the direction u (unit, rising); -1: none. */
int pp_scene_skylines_far(const struct pp_scene_skylines *skylines, struct pp_vec3 u);

#endif
