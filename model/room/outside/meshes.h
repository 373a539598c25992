/* meshes.h - the step that adds the triangles of files, which stand outside the room. Inside
 * model/room/ only.
 *
 * It is the last that adds surfaces. Triangles beyond the room's own bounds are not
 * compared with its faces; the others are added as free-standing surfaces are.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_MESHES_H
#define PP_MODEL_ROOM_OUTSIDE_MESHES_H

#include "model/room/build/resolve.h"

enum pp_status pp_build_meshes(struct pp_resolver *r, struct pp_error *err);

#endif
