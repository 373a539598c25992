/* rad_blind.h - the slats of a blind, written out as polygons of a Radiance scene. */
#ifndef PP_FORMATS_RADIANCE_WRITE_RAD_BLIND_H
#define PP_FORMATS_RADIANCE_WRITE_RAD_BLIND_H

#include "model/light/scene_description.h"
#include "model/room/world.h"

/* Adds the slats of the opening's blind, 1 mm from its glass; a curved slat is six
 * polygons. PP_BAD_INPUT for blinds between panes, which a scene has as one surface, and
 * for openings that are not rectangular. */
enum pp_status pp_rad_blind_add(struct pp_scene_description *scene,
                                const struct pp_opening *opening, struct pp_error *err);

#endif
