/* outside_parts.h - adds parts given in a building's axes to a room, in the room's
 * axes.
 *
 * Inside model/room/ only. Every part is copied, and converted from the building's
 * axes. A skyline is not converted, since it refers to a wall by name.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_OUTSIDE_PARTS_H
#define PP_MODEL_ROOM_OUTSIDE_OUTSIDE_PARTS_H

#include "model/room/room_parts.h"

enum pp_status pp_outside_parts_add_block(struct pp_room *room,
                                          const struct pp_block *block,
                                          struct pp_error *err);

/* Adds the part with the given vertices instead of its own. */
enum pp_status pp_outside_parts_add_surface(struct pp_room *room,
                                            const struct pp_surface_part *part,
                                            const struct pp_vec3 *vertices, int count,
                                            struct pp_error *err);
enum pp_status pp_outside_parts_add_mesh(struct pp_room *room,
                                         const struct pp_mesh_part *part,
                                         struct pp_error *err);
enum pp_status pp_outside_parts_add_tree(struct pp_room *room,
                                         const struct pp_tree_part *part,
                                         struct pp_error *err);
enum pp_status pp_outside_parts_add_garden(struct pp_room *room,
                                           const struct pp_garden_part *part,
                                           struct pp_error *err);
enum pp_status pp_outside_parts_add_skyline(struct pp_room *room,
                                            const struct pp_skyline_part *part,
                                            struct pp_error *err);

/* True if the room already has the same box, or the same polygon, to 1 mm. */
bool pp_outside_parts_has_block(const struct pp_room *room,
                                const struct pp_block *block);
bool pp_outside_parts_has_surface(const struct pp_room *room,
                                  const struct pp_surface_part *part);

#endif
