/* keyhole.h - a wall less its windows as outlines without holes: each hole is joined to
 * the rim by a bridge, along which the outline runs there and back, as Radiance's
 * polygons have them. */
#ifndef PP_MODEL_ROOM_KEYHOLE_H
#define PP_MODEL_ROOM_KEYHOLE_H

#include "model/base/error.h"
#include "model/room/world.h"

/* Outlines of a face of the room without its openings: one, or several where openings
 * part it. Corners are the face's and the openings' own to the bit. */
struct pp_keyhole_outlines {
    int count;
    struct pp_ring_3d {
        int count;
        struct pp_vec3 *corners; /* counter-clockwise seen against the normal */
    } * outlines;
};

enum pp_status pp_keyhole_outlines_init(struct pp_keyhole_outlines *cut,
                                        const struct pp_world *world, int face,
                                        struct pp_error *err);
void pp_keyhole_outlines_clear(struct pp_keyhole_outlines *cut);

#endif
