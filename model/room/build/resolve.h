/* resolve.h - the shared state of the steps that turn a room as described by its file
 * into a world.
 *
 * Inside model/room/ only. A step is a file of build/ or outside/, or a small function of world.c,
 * which has their order. Every
 * step reports mistakes and continues with the valid parts; a step fails only on errors
 * of the system. The reader has already reported the mistake of a part that contains
 * NAN; such a part, and whatever depends on it, is skipped silently.
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
    struct pp_world *world;     /* in the making; not owned */
    struct pp_mistakes *mistakes;
    struct pp_clipper *clipper;
    char **walls;    /* the names that a window may be in */
    int *wall_faces; /* their surfaces; -1: could not be made */
    int wall_count;
    int *corners; /* numbers of the envelope's points, the same for all faces that meet
                   * in one; face after face in the order of their vertices */
    bool faces_missing; /* faces that were too wrong to be made */
    bool watertight;    /* the envelope is closed: inside and outside are known */
    int unknown_walls;  /* number of names that match no wall */
    int surface_space;  /* how many surfaces there is memory for */
    bool keeps_places;  /* surfaces flush with the envelope are not moved off it */
};

/* True if there are few enough faces, openings and surfaces to compare with each other.
 * Faces are compared with all nearby parts, corner by corner: a room with more pairs
 * would take many seconds; 40,000 windows in one wall took minutes. */
bool pp_resolve_is_comparable(const struct pp_room *room);

/* The index of the wall so named among r->walls; where there is none, notes a mistake
 * that names those there are and gives -1. `what` begins the sentence: "window". */
int pp_resolve_wall_index(struct pp_resolver *r, const char *name, const char *what,
                          int line);

/* The same, but the wall's surface; -1 also where it could not be made. */
int pp_resolve_wall(struct pp_resolver *r, const char *name, const char *what,
                    int line);

/* The same of a window, which may stand in a sloping face of the roof, too. */
int pp_resolve_window_face(struct pp_resolver *r, const char *name, int line);

/* Puts the surface at the end of the world's, which then owns its outline and a copy
 * of its name; on failure the outline is cleared. */
enum pp_status pp_resolve_add_surface(struct pp_resolver *r, struct pp_surface *surface,
                                      struct pp_error *err);

/* Adds a face with an outline of these vertices. */
enum pp_status pp_resolve_add_face(struct pp_resolver *r, struct pp_surface surface,
                                   const struct pp_vec3 *vertices, int count,
                                   struct pp_error *err);

#endif
