/* light_hash.h - a light scene as one number, by which files of caches and checkpoints
 * know theirs again. The light that falls on a world from outside is no part of it
 * (environment.h).
 */
#ifndef PP_SIMULATE_SCENE_LIGHT_HASH_H
#define PP_SIMULATE_SCENE_LIGHT_HASH_H

#include "simulate/scene/light_scene.h"

/* Sets scene->hash from all that the scene is made of; triangles: those given to the
 * ray kernels. */
void pp_light_hash_scene(struct pp_light_scene *scene, const float (*triangles)[3][3]);

#endif
