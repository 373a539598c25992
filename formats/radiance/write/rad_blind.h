/* rad_blind.h - the slats of a blind, written out as polygons of a Radiance scene. */
#ifndef PP_FORMATS_RADIANCE_WRITE_RAD_BLIND_H
#define PP_FORMATS_RADIANCE_WRITE_RAD_BLIND_H

#include "model/light/scene_description.h"
#include "model/room/world.h"

/* Adds the slats of the opening's blind, 1 mm from the glass; a curved slat becomes six
 * polygons. PP_BAD_INPUT for openings that are not rectangular, and for blinds between
 * panes (a scene represents all panes by one surface). */
enum pp_status pp_rad_blind_add(struct pp_scene_description *scene,
                                const struct pp_opening *opening, struct pp_error *err);

#endif
