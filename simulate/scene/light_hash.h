/* light_hash.h - a hash of a light scene, by which files of caches and checkpoints are
 * matched to it. The light that falls on a world from outside is not included
 * (environment.h).
 */
#ifndef PP_SIMULATE_SCENE_LIGHT_HASH_H
#define PP_SIMULATE_SCENE_LIGHT_HASH_H

#include "simulate/scene/light_scene.h"

/* Sets scene->hash from all that the scene is made of; triangles: those given to the
 * ray kernels. */
void pp_light_hash_scene(struct pp_light_scene *scene, const float (*triangles)[3][3]);

#endif
