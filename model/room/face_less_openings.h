/* face_less_openings.h - a polygon less its openings, in coordinates of its own plane,
 * for the clipper; and the exact conversion back to points of the room. */
#ifndef PP_MODEL_ROOM_FACE_LESS_OPENINGS_H
#define PP_MODEL_ROOM_FACE_LESS_OPENINGS_H

#include "model/base/error.h"
#include "model/geometry/clipper.h"
#include "model/geometry/region.h"
#include "model/room/world.h"

/* Axes in the plane: unit vectors a and b from a corner. */
struct pp_face_axes {
    struct pp_vec3 origin, a, b;
};

/* Axes of a polygon, from its first corner. */
struct pp_face_axes pp_face_less_openings_axes(const struct pp_polygon *polygon);

/* Makes the region of the polygon (pp_clipper_by_crossings) less the world's openings
 * in `face`. face -1: no openings; the world may then be NULL. The caller clears the
 * region in any case. */
enum pp_status pp_face_less_openings(struct pp_region *region,
                                     struct pp_clipper *clipper,
                                     const struct pp_face_axes *axes,
                                     const struct pp_polygon *polygon,
                                     const struct pp_world *world, int face,
                                     struct pp_error *err);

/* Converts xy to a point of the room. If a corner of the polygon, or of one of its
 * openings, is within 0.1 um (the rounding of the clipper), returns exactly that
 * corner. */
struct pp_vec3 pp_face_less_openings_corner(const struct pp_face_axes *axes,
                                            const double xy[2],
                                            const struct pp_polygon *polygon,
                                            const struct pp_world *world, int face);

#endif
