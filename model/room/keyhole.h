/* keyhole.h - a wall less its windows, as outlines without holes. Each hole is joined
 * to the outer ring by a bridge that the outline traverses in both directions, as in
 * Radiance's polygons. */
#ifndef PP_MODEL_ROOM_KEYHOLE_H
#define PP_MODEL_ROOM_KEYHOLE_H

#include "model/base/error.h"
#include "model/room/world.h"

/* Outlines of a face of the room without its openings: one outline, or several if
 * openings divide the face. Corners equal exactly those of the face and the
 * openings. */
struct pp_keyhole_outlines {
    int count;
    struct pp_ring_3d {
        int count;
        struct pp_vec3 *corners; /* counter-clockwise as seen by a viewer whom the
                                  * normal points at */
    } * outlines;
};

enum pp_status pp_keyhole_outlines_init(struct pp_keyhole_outlines *cut,
                                        const struct pp_world *world, int face,
                                        struct pp_error *err);
void pp_keyhole_outlines_clear(struct pp_keyhole_outlines *cut);

#endif
