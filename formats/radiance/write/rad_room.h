/* rad_room.h - converts a room's world and its light to a scene that Radiance can read.
 *
 * The scene has the faces without their openings, the panes, slats of blinds, reveals,
 * free-standing surfaces and blocks. Each of these surfaces has two materials if its
 * sides differ. The sky is a distant glow with the horizontal irradiance `horizontal`.
 * The ground is a second glow, below the horizon. Shaded ground is a disc instead, with
 * the glow beyond the edge of the disc (rad_room.c). Skylines without a distance are
 * part of the sky's pattern; skylines with a distance are walls among the surfaces.
 *
 * Finishes are diffuse and grey, as in the calculation of daylight factors, or have
 * their colour and gloss.
 *
 * Rejected with a reason: surfaces that emit light; more than 16 skylines without a
 * distance; blinds between panes or in openings that are not rectangular; a coarse
 * model with blinds; a photographed sky.
 */
#ifndef PP_FORMATS_RADIANCE_WRITE_RAD_ROOM_H
#define PP_FORMATS_RADIANCE_WRITE_RAD_ROOM_H

#include <stdbool.h>

#include "model/light/outside_light.h"
#include "model/light/scene_description.h"
#include "model/room/world.h"

enum pp_rad_group {
    PP_RAD_ROOM,    /* envelope, reveals, surfaces inside */
    PP_RAD_GLAZING, /* panes, slats of blinds */
    PP_RAD_OUTSIDE, /* blocks, surfaces, walls of skylines, shaded ground */
    PP_RAD_SKY,     /* sky, sun, and the ground as a glow */
    PP_RAD_GROUPS
};

struct pp_rad_room {
    struct pp_scene_description scene;
    int first[PP_RAD_GROUPS + 1]; /* shapes of group g: first[g] to first[g + 1] - 1 */
};

/* Makes the scene. horizontal: irradiance on the open horizontal ground by the sky,
 * without the sun; above 0. gloss: finishes have their colour and gloss. PP_BAD_INPUT
 * for a room that Radiance cannot describe; the message begins with the line of the
 * room file, if there is one. */
enum pp_status pp_rad_room_init(struct pp_rad_room *room, const struct pp_world *world,
                                const struct pp_outside_light *light, double horizontal,
                                bool gloss, struct pp_error *err);
/* True if any finish of the room has a colour or a gloss. */
bool pp_rad_room_has_gloss(const struct pp_world *world);

void pp_rad_room_clear(struct pp_rad_room *room);

#endif
