/* environment.h - the light of a ray that leaves the scene: sky, ground, skylines.
 *
 * An environment is a light from outside (model/light/outside_light.h) prepared for one
 * scene. It is an argument of all integrators. A second environment for the same scene
 * takes a few microseconds, and the scene is not rebuilt.
 *
 * Light is given as pi times luminance over the horizontal illuminance Eh of the open
 * sky, so that the mean over a cosine lobe is an illuminance over Eh.
 *
 * A ground that is not a surface of the scene (scene_ground.h) is an infinite diffuse
 * plane under the open sky. Its light is rho in all directions below the horizon. A
 * skyline without a distance (scene_skylines.h) has the exitance
 *
 *     rho (Ev + rho_ground / 2)
 *
 * where Ev is the illuminance of the skyline from the open sky. By convention, the
 * building shades neither the skyline nor the ground in front of it.
 */
#ifndef PP_SIMULATE_SCENE_ENVIRONMENT_H
#define PP_SIMULATE_SCENE_ENVIRONMENT_H

#include <stdbool.h>
#include <stdint.h>

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "simulate/sampling/sample_polygon.h"
#include "simulate/scene/scene_skylines.h"

struct pp_environment {
    struct pp_outside_light light;
    const struct pp_scene_skylines *skylines; /* owned by the scene */
    double *far_exitance;
    struct pp_brightness brightness; /* estimated brightness outside the openings */
    struct pp_sky_bright *bright; /* bright parts of a photographed sky; NULL: none */
};

/* skylines: of the scene that the light falls on; must outlive *environment. */
enum pp_status pp_environment_create(struct pp_environment **environment,
                                     const struct pp_scene_skylines *skylines,
                                     const struct pp_outside_light *light,
                                     struct pp_error *err);
void pp_environment_destroy(struct pp_environment *environment); /* NULL is allowed */

/* Hash of the light alone; caches store it to check that they belong to the same
 * light. */
uint64_t pp_environment_hash(const struct pp_environment *environment);

/* The light from direction u (unit) in which no surface is met. */
double pp_environment_light(const struct pp_environment *environment, struct pp_vec3 u,
                            bool *is_sky);

#endif
