/* room_front.h - the facade of a placed room as it stands before the other rooms of its
 * building: a sheet that gives way to them. Inside model/room/ only.
 *
 * A facade goes on beyond its room by what the file says, over whatever is there. Where
 * another room of the building is there, what the file says of that room holds instead:
 * the sheet ends at the walls that stand in its plane or right behind it and look the
 * same way, at what comes through it of a room before it, and at the facades of these
 * rooms. So it hides none of their windows, and no two sheets lie in one place.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_ROOM_FRONT_H
#define PP_MODEL_ROOM_OUTSIDE_ROOM_FRONT_H

#include "model/geometry/clipper.h"
#include "model/geometry/region_pieces.h"
#include "model/room/room_parts.h"

/* Walls that stand behind a sheet by less are those that it is the outside of (m): more
 * than walls are thick. */
#define PP_ROOM_FRONT_BEHIND_M 1.0

/* A piece of an outside that is smaller is what the clipper's rounding leaves. */
#define PP_ROOM_FRONT_PIECE_M2 1e-9

struct pp_room_front {
    struct pp_vec3 origin, along, up,
        out;                  /* in the building's axes; along x up = out */
    struct pp_bounds2 extent; /* of the facade, openings and all */
    struct pp_region sheet;   /* what there is of it, from origin */
    double reflectance;
    const struct pp_finish *finish;
    int line;
};

/* Is the surface of a facade's sheet, not of a passage through it? */
bool pp_room_front_is_of_sheet(const struct pp_world *world, int surface);

/* The facade of that index of a room's world, which stands at the place. To be cleared
 * in any case. */
enum pp_status pp_room_front_of(struct pp_room_front *front,
                                const struct pp_world *world, int facade,
                                const struct pp_placement *place,
                                struct pp_clipper *clipper, struct pp_error *err);
void pp_room_front_clear(struct pp_room_front *front);

/* Takes out of the sheet what is before a room's faces, or in it; `body` has that room's
 * faces in the building's axes. */
enum pp_status pp_room_front_give_way(struct pp_room_front *front,
                                      const struct pp_world *body,
                                      struct pp_clipper *clipper, struct pp_error *err);

/* Do two facades lie in one plane and overlap? */
bool pp_room_front_overlaps(const struct pp_room_front *a,
                            const struct pp_room_front *b);

/* Takes what the other facade fills out of the sheet. */
enum pp_status pp_room_front_take_out(struct pp_room_front *front,
                                      const struct pp_room_front *other,
                                      struct pp_clipper *clipper, struct pp_error *err);

/* The sheet in outlines, whose normals are turned towards its own room as those of faces
 * are; to be cleared in any case. */
enum pp_status pp_room_front_cut(struct pp_region_pieces *pieces,
                                 const struct pp_room_front *front,
                                 struct pp_clipper *clipper, struct pp_error *err);

/* Properties of each as a part of the building, without its vertices. */
struct pp_surface_part pp_room_front_part(const struct pp_room_front *front);

enum pp_status pp_room_front_copy(struct pp_room_front *copy,
                                  const struct pp_room_front *front,
                                  struct pp_error *err);

#endif
