/* light_hash.h - a hash of a light scene. Files of caches and checkpoints store it to
 * check that they belong to the scene. The light that falls on a world from outside is
 * not included (environment.h).
 */
#ifndef PP_SIMULATE_SCENE_LIGHT_HASH_H
#define PP_SIMULATE_SCENE_LIGHT_HASH_H

#include "simulate/scene/light_scene.h"

/* Sets scene->hash. triangles: those passed to the ray kernels. */
void pp_light_hash_scene(struct pp_light_scene *scene, const float (*triangles)[3][3]);

#endif
