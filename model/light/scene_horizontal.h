/* scene_horizontal.h - horizontal irradiance of the open ground from a scene's sky. */
#ifndef PP_MODEL_LIGHT_SCENE_HORIZONTAL_H
#define PP_MODEL_LIGHT_SCENE_HORIZONTAL_H

#include "model/light/scene_description.h"

/* Irradiance, by channel, of an unobstructed horizontal plane from the extended distant
 * sources (sky, not sun); black if there are none. A PP_PATTERN_SKY counts with its
 * factor, without its skylines. Quadrature over the hemisphere: to 1e-6 for smooth
 * skies, 1e-3 for cones that end above the horizon. */
struct pp_rgb pp_scene_horizontal(const struct pp_scene_description *scene);

#endif
