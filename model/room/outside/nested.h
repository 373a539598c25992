/* nested.h - the step that puts a nested room into its coarse model. Inside model/room/
 * only.
 *
 * The coarse model is a room of its own: the atrium, court or street that windows of
 * the nested room face, or a coarse room in the same place. Windows of both are matched
 * by name. The bearings of a matched pair decide:
 *
 *     opposite   the coarse model is the space in front of the window. Its surfaces and
 *                panes are added, except the matched windows
 *     the same   the coarse model is in the place of the nested room. Only the surfaces
 *                outside it are added
 *
 * Both files state the bearing of north, so the coarse model is rotated by the
 * difference, then moved until the matched windows coincide. The ground is that of the
 * coarse model.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_NESTED_H
#define PP_MODEL_ROOM_OUTSIDE_NESTED_H

#include "model/room/build/resolve.h"

/* Adds the coarse model. Reports windows that do not match, and surfaces of the coarse
 * model that are in the room. Comes after all surfaces of the room except meshes. */
enum pp_status pp_build_nested(struct pp_resolver *r, struct pp_error *err);

#endif
