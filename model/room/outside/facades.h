/* facades.h - the step that makes the outside of a wall and of its continuation beyond
 * the room. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_OUTSIDE_FACADES_H
#define PP_MODEL_ROOM_OUTSIDE_FACADES_H

#include "model/room/build/resolve.h"

/* Adds the facades and their surfaces (see facades.c), sets `facade` and `recess_m` of
 * the openings, and reports impossible facades. Comes after the reveals. */
enum pp_status pp_build_facades(struct pp_resolver *r, struct pp_error *err);

#endif
