/* resolve.h - shared state of the steps that turn a room, as described by its file,
 * into a world.
 *
 * Inside model/room/ only. A step is a file of build/ or outside/, or a small function
 * of world.c, which calls the steps in order. Every step reports mistakes and continues
 * with the valid parts; it fails only on system errors. A part that contains NAN was
 * reported by the reader; this part, and whatever depends on it, is skipped without a
 * message.
 */
#ifndef PP_MODEL_ROOM_BUILD_RESOLVE_H
#define PP_MODEL_ROOM_BUILD_RESOLVE_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/base/mistakes.h"
#include "model/geometry/clipper.h"
#include "model/geometry/polygon.h"
#include "model/room/building.h"
#include "model/room/room_parts.h"

struct pp_resolver {
    const struct pp_room *room; /* not owned */
    struct pp_world *world;     /* under construction; not owned */
    struct pp_mistakes *mistakes;
    struct pp_clipper *clipper;
    char **walls;    /* names of walls, for windows */
    int *wall_faces; /* surface index by wall; -1: invalid wall */
    int wall_count;
    int *corners;       /* number of the merged corner, for each vertex of each face in
                   * order (corners.h) */
    bool faces_missing; /* some faces have faults and were not made */
    bool watertight;    /* true if the envelope is closed, so that inside and outside
                         * are defined */
    int unknown_walls;  /* number of references to unknown walls */
    int surface_space;  /* allocated length of world->surfaces */
    bool keeps_places;  /* surfaces in a face of the envelope are not offset */
};

/* True if the room has few enough faces, openings and surfaces to compare all pairs.
 * Faces are compared with all nearby parts, corner by corner; a room with more pairs
 * would take many seconds. */
bool pp_resolve_is_comparable(const struct pp_room *room);

/* Index in r->walls of the wall with that name. If there is none, reports the valid
 * names and returns -1. `what` begins the message: "window". */
int pp_resolve_wall_index(struct pp_resolver *r, const char *name, const char *what,
                          int line);

/* Surface index of the wall with that name; -1 if there is none (reported) or it is
 * invalid. */
int pp_resolve_wall(struct pp_resolver *r, const char *name, const char *what,
                    int line);

/* Surface index for a window: a wall, or a sloping face of the roof; -1 as above. */
int pp_resolve_window_face(struct pp_resolver *r, const char *name, int line);

/* Appends the surface to the world, which then owns its outline and a copy of its name.
 * On failure the outline is freed. */
enum pp_status pp_resolve_add_surface(struct pp_resolver *r, struct pp_surface *surface,
                                      struct pp_error *err);

/* Appends a surface with an outline of these vertices. */
enum pp_status pp_resolve_add_face(struct pp_resolver *r, struct pp_surface surface,
                                   const struct pp_vec3 *vertices, int count,
                                   struct pp_error *err);

#endif
