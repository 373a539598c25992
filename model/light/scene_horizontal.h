/* scene_horizontal.h - horizontal irradiance of the open ground by a scene's sky. */
#ifndef PP_MODEL_LIGHT_SCENE_HORIZONTAL_H
#define PP_MODEL_LIGHT_SCENE_HORIZONTAL_H

#include "model/light/scene_description.h"

/* Irradiance of a level plane that faces up with nothing about it but the extended
 * distant sources (sky, not sun), each channel; black where there are none. A
 * PP_PATTERN_SKY counts with its own factor, without its skylines. By quadrature over
 * the hemisphere: to 1e-6 for skies without edges, 1e-3 for cones that end above the
 * horizon. */
struct pp_rgb pp_scene_horizontal(const struct pp_scene_description *scene);

#endif
