/* room_shell.h - a room of a building as seen from the others: a closed body of its
 * walls, floor and roof, and the parts fixed to its outside.
 *
 * Inside model/room/ only. Fixed outside are its facades, shades of its windows, and
 * its own surfaces, blocks and meshes that are outside it.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_ROOM_SHELL_H
#define PP_MODEL_ROOM_OUTSIDE_ROOM_SHELL_H

#include "model/room/outside/room_front.h"

/* A polygon outside: fixed there, or a piece of a face with windows. */
struct pp_room_carried {
    struct pp_surface_part part; /* in the building's axes */
    bool is_shade;               /* of a window in a wall that */
    struct pp_vec3 at, out;      /* goes through `at`, and looks this way */
};

struct pp_room_shell {
    struct pp_placement placement;
    struct pp_world *body; /* faces of the room, in the building's axes; `back` is their
                            * outer reflectance */
    char **walls;          /* their names */
    int wall_count;
    struct pp_room *own; /* the room alone in the state, whose blocks and meshes are
                          * outside; NULL: nothing is fixed outside */
    bool *is_divided;    /* of each face: it is among the carried, by its windows */
    struct pp_room_carried *carried;
    int carried_count;
    struct pp_room_front *fronts;
    int front_count;
};

/* Makes the body of a room as seen from outside. glass_reflectance: reflectance of the
 * windows, which then divide the faces; NAN: windows reflect like walls. Without
 * `outside` the shell is the body alone. Errors in the room's file are reported where
 * the room itself is resolved; here such a room has an empty shell. The caller clears
 * the shell in any case. */
enum pp_status pp_room_shell_make(struct pp_room_shell *shell,
                                  const struct pp_room *room, enum pp_site_state state,
                                  bool outside, double glass_reflectance,
                                  struct pp_clipper *clipper, struct pp_error *err);
void pp_room_shell_clear(struct pp_room_shell *shell);

/* True if there is a wall of that name. */
bool pp_room_shell_has_wall(const struct pp_room_shell *shell, const char *name);

/* True if a wall of the room faces the same way as the shaded window's, in one front
 * with it. */
bool pp_room_shell_shares_front(const struct pp_room_shell *shell,
                                const struct pp_room_carried *shade);

#endif
