/* rad_room.h - a room's world and its light as a scene that Radiance's formats can say.
 *
 * Faces less their openings, panes, reveals, free-standing surfaces and blocks as they
 * are, each of two materials where its sides differ. The sky is a distant glow, in units
 * of which `horizontal` falls on the open level ground, and another below the horizon is
 * the ground, or, where that lies in shadow, what there is of it beyond a disc
 * (rad_room.c). Skylines without a distance are part of the sky's pattern; those with
 * one are walls among the surfaces.
 *
 * Finishes are matt and grey, as the daylight factors of rooms are worked out, or with
 * their colour and gloss.
 *
 * Rooms that Radiance can't describe are refused with a reason: surfaces that give off light
 * by themselves, more than 16 skylines without a distance.
 */
#ifndef PP_FORMATS_RADIANCE_WRITE_RAD_ROOM_H
#define PP_FORMATS_RADIANCE_WRITE_RAD_ROOM_H

#include <stdbool.h>

#include "model/light/outside_light.h"
#include "model/light/scene_description.h"
#include "model/room/world.h"

enum pp_rad_group {
    PP_RAD_ROOM,    /* the room: envelope, reveals, surfaces within */
    PP_RAD_GLAZING, /* panes */
    PP_RAD_OUTSIDE, /* blocks, surfaces, walls of skylines, ground in shadow */
    PP_RAD_SKY,     /* sky, and ground as a glow */
    PP_RAD_GROUPS
};

struct pp_rad_room {
    struct pp_scene_description scene;
    int first[PP_RAD_GROUPS + 1]; /* shapes of group g: first[g] to first[g + 1] - 1 */
};

/* horizontal: irradiance of the open level ground, above 0. PP_BAD_INPUT, beginning
 * with the line where the file has one, for what can't be said. */
enum pp_status pp_rad_room_init(struct pp_rad_room *room, const struct pp_world *world,
                                const struct pp_outside_light *light, double horizontal,
                                bool gloss, struct pp_error *err);
/* True if any of its finishes has a colour or a gloss. */
bool pp_rad_room_has_gloss(const struct pp_world *world);

void pp_rad_room_clear(struct pp_rad_room *room);

#endif
