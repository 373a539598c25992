/* resolve.h - from the room as its file describes it to the world: the steps, and what
 * they share. Inside model/room/ only.
 *
 * Every step notes mistakes and goes on with what is left; a step fails only where the
 * machine does. A part with NAN in it has had its mistake noted by the reader and is
 * passed over in silence, and so is what depends on it.
 */
#ifndef PP_MODEL_ROOM_BUILD_RESOLVE_H
#define PP_MODEL_ROOM_BUILD_RESOLVE_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/base/mistakes.h"
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
    bool closed;        /* the envelope is whole: inside and outside are known */
    int unknown_walls;  /* how often one was asked for that there is not */
    int surface_space;  /* how many surfaces there is memory for */
};

/* envelope.c: the plan or the envelope becomes the world's first surfaces, with the
 * finishes' reflectances. */
enum pp_status pp_build_envelope(struct pp_resolver *r, struct pp_error *err);

/* corners.c: makes the envelope's vertices one that are meant to be one, and fills
 * r->corners. */
enum pp_status pp_build_corners(struct pp_resolver *r, struct pp_error *err);

/* watertight.c: do the envelope's surfaces close the room? Sets r->closed; turns faces
 * round that turn the wrong way. */
enum pp_status pp_build_watertight(struct pp_resolver *r, struct pp_error *err);

/* place_openings.c, reveals.c */
enum pp_status pp_build_place_openings(struct pp_resolver *r, struct pp_error *err);
enum pp_status pp_build_reveals(struct pp_resolver *r, struct pp_error *err);

/* blocks.c, skylines.c, free_surfaces.c: what stands round the room, and loose in it. */
enum pp_status pp_build_blocks(struct pp_resolver *r, struct pp_error *err);
enum pp_status pp_build_skylines(struct pp_resolver *r, struct pp_error *err);
enum pp_status pp_build_free_surfaces(struct pp_resolver *r, struct pp_error *err);

/* working_plane.c, receivers.c */
enum pp_status pp_build_working_plane(struct pp_resolver *r, struct pp_error *err);
enum pp_status pp_build_receivers(struct pp_resolver *r, struct pp_error *err);

/* What the steps share: resolve.c. */

/* The index of the wall so named among r->walls; where there is none, notes a mistake
 * that names those there are and gives -1. `what` begins the sentence: "window". */
int pp_resolve_wall_index(struct pp_resolver *r, const char *name, const char *what,
                          int line);

/* The same, but the wall's surface; -1 also where it could not be made. */
int pp_resolve_wall(struct pp_resolver *r, const char *name, const char *what,
                    int line);

/* Puts the surface at the end of the world's, which then owns its outline and a copy
 * of its name; on failure the outline is cleared. */
enum pp_status pp_resolve_add_surface(struct pp_resolver *r, struct pp_surface *surface,
                                      struct pp_error *err);

/* The same with an outline of these vertices. */
enum pp_status pp_resolve_add_face(struct pp_resolver *r, struct pp_surface surface,
                                   const struct pp_vec3 *vertices, int count,
                                   struct pp_error *err);

/* Notes what is wrong with an outline by itself: a coordinate that could not be read
 * (in silence), too few vertices, repeated ones, no area, not plane, crossing itself.
 * `what` begins the sentence. True if nothing is. */
bool pp_build_outline_is_good(struct pp_resolver *r, const char *what, int line,
                              const struct pp_vertices *vertices);

#endif
