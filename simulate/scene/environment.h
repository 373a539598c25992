/* environment.h - the light of a ray that leaves the scene: sky, ground, skylines.
 *
 * Light is given as pi times luminance over the horizontal illuminance Eh of the open
 * sky, so that the mean over a cosine lobe is an illuminance over Eh.
 *
 * The ground is an endless diffuse plane under the open sky, never shadowed: rho below
 * the horizon. A skyline is an endless vertical face that gives off
 *
 *     rho (Ev + rho_ground / 2)
 *
 * where Ev is the open sky's illuminance on it. Without a distance it hides the
 * directions u with
 *
 *     0 < u.z < tan(angle) (u.o)
 *
 * o the outward horizontal of its wall: the limit of a face ever farther away and
 * higher. With a distance it stands on the ground at that distance from its wall and is
 * met at a point, from either side. Its light is the same by convention: the room's own
 * building does not shadow it.
 */
#ifndef PP_SIMULATE_SCENE_ENVIRONMENT_H
#define PP_SIMULATE_SCENE_ENVIRONMENT_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/room/world.h"

struct pp_far_skyline {
    struct pp_vec3 outward; /* horizontal, unit: towards it */
    double slope;           /* tangent of its angle */
    double exitance;
};

struct pp_near_skyline {
    struct pp_vec3 outward;
    double offset_m;    /* outward . x of its points */
    double head_m;      /* z of its upper edge */
    double exitance[2]; /* of the side towards its wall, and the other */
};

struct pp_environment {
    struct pp_sky sky;
    double ground_reflectance;
    double ground_level_m;
    struct pp_far_skyline *far_skylines;
    int far_count;
    struct pp_near_skyline *near_skylines;
    int near_count;
};

/* Lengths and points are measured from `centre`. */
enum pp_status pp_environment_init(struct pp_environment *environment,
                                   const struct pp_world *world, struct pp_vec3 centre,
                                   struct pp_error *err);
void pp_environment_clear(struct pp_environment *environment);

/* The distance at which the ray from p along u (unit) meets a near skyline, with its
 * exitance; INFINITY if it meets none. */
double pp_environment_near_skyline(const struct pp_environment *environment,
                                   struct pp_vec3 p, struct pp_vec3 u,
                                   double *exitance);

/* The light from direction u (unit) where no surface and no near skyline is met. */
double pp_environment_light(const struct pp_environment *environment, struct pp_vec3 u,
                            bool *is_sky);

#endif
