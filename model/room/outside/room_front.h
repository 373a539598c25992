/* room_front.h - the facade of a placed room as seen from the other rooms of its
 * building: a sheet that is trimmed where it meets them. Inside model/room/ only.
 *
 * A facade extends beyond its room as given in the file. Another room of the building
 * has precedence there: the sheet ends at walls that are in its plane or just behind it
 * and face the same way, at the parts of a room in front that cross it, and at the
 * facades of these rooms. So it hides none of their windows, and no two sheets overlap.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_ROOM_FRONT_H
#define PP_MODEL_ROOM_OUTSIDE_ROOM_FRONT_H

#include "model/geometry/clipper.h"
#include "model/geometry/region_pieces.h"
#include "model/room/room_parts.h"

/* Walls that stand behind a sheet by less are those that it is the outside of (m): more
 * than walls are thick. */
#define PP_ROOM_FRONT_BEHIND_M 1.0

/* Smallest area of a piece of an outside; smaller ones are the clipper's rounding. */
#define PP_ROOM_FRONT_PIECE_M2 1e-9

struct pp_room_front {
    struct pp_vec3 origin, along, up,
        out;                  /* in the building's axes; along x up = out */
    struct pp_bounds2 extent; /* of the facade, openings and all */
    struct pp_region sheet;   /* its present shape, from origin */
    double reflectance;
    const struct pp_finish *finish;
    int line;
};

/* True if the surface belongs to a facade's sheet, not to a passage through it. */
bool pp_room_front_is_of_sheet(const struct pp_world *world, int surface);

/* The facade of that index of a room's world, which stands at the place. To be cleared
 * in any case. */
enum pp_status pp_room_front_of(struct pp_room_front *front,
                                const struct pp_world *world, int facade,
                                const struct pp_placement *place,
                                struct pp_clipper *clipper, struct pp_error *err);
void pp_room_front_clear(struct pp_room_front *front);

/* Removes the parts of the sheet that are in front of a room's faces, or in them;
 * `body` has that room's faces in the building's axes. */
enum pp_status pp_room_front_give_way(struct pp_room_front *front,
                                      const struct pp_world *body,
                                      struct pp_clipper *clipper, struct pp_error *err);

/* True if two facades lie in one plane and overlap. */
bool pp_room_front_overlaps(const struct pp_room_front *a,
                            const struct pp_room_front *b);

/* Removes the area of the other facade from the sheet. */
enum pp_status pp_room_front_take_out(struct pp_room_front *front,
                                      const struct pp_room_front *other,
                                      struct pp_clipper *clipper, struct pp_error *err);

/* Divides the sheet into outlines, whose normals are turned towards its own room as
 * those of faces are. The caller clears *pieces in any case. */
enum pp_status pp_room_front_cut(struct pp_region_pieces *pieces,
                                 const struct pp_room_front *front,
                                 struct pp_clipper *clipper, struct pp_error *err);

/* Properties of each as a part of the building, without its vertices. */
struct pp_surface_part pp_room_front_part(const struct pp_room_front *front);

enum pp_status pp_room_front_copy(struct pp_room_front *copy,
                                  const struct pp_room_front *front,
                                  struct pp_error *err);

#endif
