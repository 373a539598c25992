/* light_scene_of_description.h - a light scene made from a description (an import). */
#ifndef PP_SIMULATE_SCENE_LIGHT_SCENE_OF_DESCRIPTION_H
#define PP_SIMULATE_SCENE_LIGHT_SCENE_OF_DESCRIPTION_H

#include "model/light/scene_description.h"
#include "simulate/scene/light_scene.h"

/* Copies the needed data; the description may be cleared afterwards. */
enum pp_status pp_light_scene_of_description(struct pp_light_scene **scene,
                                             const struct pp_scene_description *from,
                                             struct pp_error *err);

#endif
