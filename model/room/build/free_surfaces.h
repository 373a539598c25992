/* free_surfaces.h - the step that adds opaque polygons inside the room or outside
 * it, but not through its envelope. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_FREE_SURFACES_H
#define PP_MODEL_ROOM_BUILD_FREE_SURFACES_H

#include "model/room/build/resolve.h"

enum pp_status pp_build_free_surfaces(struct pp_resolver *r, struct pp_error *err);

/* Adds a free surface as if the file had it. what: the element's name in messages;
 * static. */
enum pp_status pp_build_free_surfaces_add(struct pp_resolver *r,
                                          const struct pp_surface_part *part,
                                          const char *what, struct pp_error *err);

#endif
