/* face_less_openings.h - a polygon in coordinates of its own plane, less the openings
 * in it, for the clipper; and the way back into the room, to the bit. */
#ifndef PP_MODEL_ROOM_FACE_LESS_OPENINGS_H
#define PP_MODEL_ROOM_FACE_LESS_OPENINGS_H

#include "model/base/error.h"
#include "model/geometry/clipper.h"
#include "model/geometry/region.h"
#include "model/room/world.h"

/* The coordinates: along a and b (unit, in the plane) from a corner. */
struct pp_face_axes {
    struct pp_vec3 origin, a, b;
};

/* The polygon as a region, by crossings (region.h), without the world's openings in
 * `face` (-1: none are cut, and the world may be NULL). Whatever is returned, the
 * region is the caller's to clear. */
enum pp_status pp_face_less_openings(struct pp_region *region,
                                     struct pp_clipper *clipper,
                                     const struct pp_face_axes *axes,
                                     const struct pp_polygon *polygon,
                                     const struct pp_world *world, int face,
                                     struct pp_error *err);

/* Point at xy: a corner of the polygon or of one of those openings if it is within 0.1
 * um, the clipper's rounding. */
struct pp_vec3 pp_face_less_openings_corner(const struct pp_face_axes *axes,
                                            const double xy[2],
                                            const struct pp_polygon *polygon,
                                            const struct pp_world *world, int face);

#endif
