/* mirror_image.h - a building mirrored at the boundary of its site: the alternative
 * target of BR 209 for a new building opposite. Inside model/room/ only.
 *
 * Mirror image of a point in plan, at the line through P with unit direction d:
 *
 *     p' = P + 2 (d . (p - P)) d - (p - P)          z is unchanged
 *
 * The faces of each placed room and its facades are mirrored. Shades of its windows,
 * blocks and surfaces are not.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_MIRROR_IMAGE_H
#define PP_MODEL_ROOM_OUTSIDE_MIRROR_IMAGE_H

#include "model/room/outside/room_shell.h"

/* Extent of the room to the left and to the right of the line (m, 0 or more), looking
 * along it. */
void pp_mirror_image_sides(double sides_m[2], const struct pp_room_shell *shell,
                           const struct pp_mirror_line *line);

/* Makes the mirrored shell; its facades are among the fixed parts. The caller clears it
 * in any case. */
enum pp_status pp_mirror_image_make(struct pp_room_shell *image,
                                    const struct pp_room_shell *shell,
                                    const struct pp_mirror_line *line,
                                    struct pp_clipper *clipper, struct pp_error *err);

#endif
