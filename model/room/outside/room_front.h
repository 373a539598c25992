/* room_front.h - the facade of a placed room as seen from the other rooms of its
 * building: a sheet that is trimmed where it meets them. Inside model/room/ only.
 *
 * The file lets a facade extend beyond its room. Other rooms of the building have
 * precedence there. The sheet ends at walls that face the same way, in its plane or
 * less than 1 m behind it; at sections of rooms that cross it; and at facades of
 * earlier rooms. So the sheet hides none of their windows, and no two sheets overlap.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_ROOM_FRONT_H
#define PP_MODEL_ROOM_OUTSIDE_ROOM_FRONT_H

#include "model/geometry/clipper.h"
#include "model/geometry/region_pieces.h"
#include "model/room/room_parts.h"

/* A wall less than this (m) behind a sheet counts as directly behind the sheet; more
 * than any wall thickness. */
#define PP_ROOM_FRONT_BEHIND_M 1.0

/* Smallest area of a piece of a sheet; smaller pieces are rounding errors of the
 * clipper. */
#define PP_ROOM_FRONT_PIECE_M2 1e-9

struct pp_room_front {
    struct pp_vec3 origin, along, up,
        out; /* axes of the sheet, in those of the building; along x up = out */
    struct pp_bounds2 extent; /* extent of the facade, including openings */
    struct pp_region sheet;   /* present outline, relative to origin */
    double reflectance;
    const struct pp_finish *finish;
    int line;
};

/* True if the surface belongs to a facade's sheet, and not to a rim of a hole in it. */
bool pp_room_front_is_of_sheet(const struct pp_world *world, int surface);

/* Makes the front of facade `facade` of a room's world that has that placement. The
 * caller clears it in any case. */
enum pp_status pp_room_front_of(struct pp_room_front *front,
                                const struct pp_world *world, int facade,
                                const struct pp_placement *place,
                                struct pp_clipper *clipper, struct pp_error *err);
void pp_room_front_clear(struct pp_room_front *front);

/* Removes the parts of the sheet that are in front of a room's faces, or inside the
 * room. body: faces of that room, in the building's axes. */
enum pp_status pp_room_front_give_way(struct pp_room_front *front,
                                      const struct pp_world *body,
                                      struct pp_clipper *clipper, struct pp_error *err);

/* True if two facades lie in one plane and their extents overlap. */
bool pp_room_front_overlaps(const struct pp_room_front *a,
                            const struct pp_room_front *b);

/* Removes the extent of the other facade from the sheet. */
enum pp_status pp_room_front_take_out(struct pp_room_front *front,
                                      const struct pp_room_front *other,
                                      struct pp_clipper *clipper, struct pp_error *err);

/* Divides the sheet into outlines with normals towards the sheet's own room, like those
 * of faces. The caller clears *pieces in any case. */
enum pp_status pp_room_front_cut(struct pp_region_pieces *pieces,
                                 const struct pp_room_front *front,
                                 struct pp_clipper *clipper, struct pp_error *err);

/* Properties of the pieces as parts of the building, without vertices. */
struct pp_surface_part pp_room_front_part(const struct pp_room_front *front);

enum pp_status pp_room_front_copy(struct pp_room_front *copy,
                                  const struct pp_room_front *front,
                                  struct pp_error *err);

#endif
