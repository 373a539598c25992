/* meshes.h - the step that adds the triangles of mesh files, which must be outside the
 * room. Inside model/room/ only.
 *
 * This is the last step that adds surfaces. Triangles beyond the room's bounds are not
 * compared with its faces; the others are added like free-standing surfaces.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_MESHES_H
#define PP_MODEL_ROOM_OUTSIDE_MESHES_H

#include "model/room/build/resolve.h"

enum pp_status pp_build_meshes(struct pp_resolver *r, struct pp_error *err);

#endif
