/* keyhole.h - a wall less its windows as outlines without holes: each hole is joined to
 * the rim by a seam, along which the outline runs there and back, as Radiance's
 * polygons have them.
 */
#ifndef PP_MODEL_SEAM_H
#define PP_MODEL_SEAM_H

#include "model/base/error.h"
#include "model/room/world.h"

/* What is left of a face of the room without its openings: one outline, or several
 * where openings part it. Corners are the face's and the openings' own to the bit. */
struct pp_cut_face {
    int count;
    struct pp_ring_3d {
        int count;
        struct pp_vec3 *corners; /* counter-clockwise seen against the normal */
    } * outlines;
};

enum pp_status pp_cut_face_create(struct pp_cut_face *cut, const struct pp_world *world,
                                  int face, struct pp_error *err);
void pp_cut_face_clear(struct pp_cut_face *cut);

#endif
