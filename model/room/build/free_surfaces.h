/* free_surfaces.h - the step that adds opaque polygons inside or outside the room; they
 * must not cross the envelope. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_FREE_SURFACES_H
#define PP_MODEL_ROOM_BUILD_FREE_SURFACES_H

#include "model/room/build/resolve.h"

enum pp_status pp_build_free_surfaces(struct pp_resolver *r, struct pp_error *err);

/* Adds one surface: an element <surface>, or a side of another element. what: name of
 * its element in messages. */
enum pp_status pp_build_free_surfaces_add(struct pp_resolver *r,
                                          const struct pp_surface_part *part,
                                          const char *what, struct pp_error *err);

#endif
