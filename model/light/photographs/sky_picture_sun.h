/* sky_picture_sun.h - adds a measured sun to a photographed sky. */
#ifndef PP_MODEL_LIGHT_PHOTOGRAPHS_SKY_PICTURE_SUN_H
#define PP_MODEL_LIGHT_PHOTOGRAPHS_SKY_PICTURE_SUN_H

#include "model/light/photographs/sky_picture.h"

/* Adds the light of the sun (`sun`, `sun_lx`) to the pixels that show its disc, so that
 * the sum of their luminances times solid angles grows by sun_lx; a disc smaller than a
 * pixel becomes as large as the pixel. Updates cells and horizontal_lx. PP_BAD_INPUT if
 * the sun is outside the pictures or below their horizon. */
enum pp_status pp_sky_picture_sun_add(struct pp_sky_picture *picture,
                                      struct pp_error *err);

#endif
