/* room_shell.h - a room of a building as seen from the others: a closed body of its
 * walls, floor and roof, and the parts fixed to its outside.
 *
 * Inside model/room/ only. Fixed parts are its facades, shades of its windows, and its
 * own surfaces, blocks and meshes outside it.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_ROOM_SHELL_H
#define PP_MODEL_ROOM_OUTSIDE_ROOM_SHELL_H

#include "model/room/outside/room_front.h"

/* A polygon outside: a fixed part, or a piece of a face with windows. */
struct pp_room_carried {
    struct pp_surface_part part; /* in the building's axes */
    bool is_shade;               /* shade of a window; `at` and `out` are then set */
    struct pp_vec3 at, out;      /* a point of the window's wall, and its outward
                                  * normal */
};

struct pp_room_shell {
    struct pp_placement placement;
    struct pp_world *body; /* the room's faces, in the building's axes; `back` is
                            * their outer reflectance */
    char **walls;          /* names of the walls */
    int wall_count;
    struct pp_room *own; /* the room alone in the state, with its own blocks and meshes;
                          * NULL: no fixed parts */
    bool *is_divided;    /* by face: true if panes and the rest of the face are among
                          * `carried` */
    struct pp_room_carried *carried;
    int carried_count;
    struct pp_room_front *fronts;
    int front_count;
};

/* Makes the shell of a room in the given state. outside: include the parts fixed to it;
 * else the body only. glass_reflectance (used only with outside): if given, faces with
 * windows are divided into panes of this reflectance and the rest of the wall; NAN:
 * windows reflect like walls. Mistakes in the room are not reported here, but when the
 * room itself is resolved; a room with mistakes has no fixed parts or panes, and
 * perhaps no faces. The caller clears the shell in any case. */
enum pp_status pp_room_shell_make(struct pp_room_shell *shell,
                                  const struct pp_room *room, enum pp_site_state state,
                                  bool outside, double glass_reflectance,
                                  struct pp_clipper *clipper, struct pp_error *err);
void pp_room_shell_clear(struct pp_room_shell *shell);

/* True if the room has a wall of that name. */
bool pp_room_shell_has_wall(const struct pp_room_shell *shell, const char *name);

/* True if a wall of the room faces the same way as the wall of the shaded window, and
 * the planes of the two walls are less than PP_ROOM_FRONT_BEHIND_M apart. */
bool pp_room_shell_shares_front(const struct pp_room_shell *shell,
                                const struct pp_room_carried *shade);

#endif
