/* occluders.h - what stands in a view, projected on to its plane.
 *
 * Surfaces are cut to the view's pyramid in space first, so that nothing behind the eye
 * or beside the opening is ever projected, and at the opening's plane: what lies
 * nearer is an occluder inside, what lies beyond it an obstruction outside.
 */
#ifndef PP_METHODS_VIEW_OCCLUDERS_H
#define PP_METHODS_VIEW_OCCLUDERS_H

#include <stdbool.h>

#include "model/geometry/projection.h"
#include "model/geometry/region.h"
#include "model/room/world.h"

/* Metres: what stands less than this behind a plane lies in it. */
#define PP_OCCLUDERS_COPLANAR_M 1e-9

/* A convex piece of one surface, or of a skyline, in the view's plane. */
struct pp_occluder {
    int count;
    double (*xy)[2]; /* in either direction */
    /* One over the distance along the ray to (x, y), in units of the vector (x, y,
     * distance_m), is nearness . that vector: of two surfaces the one with the larger
     * value is in front. */
    struct pp_vec3 nearness;
    double reflectance, exitance; /* of the side that is seen */
};

struct pp_occluders {
    int count, room;
    struct pp_occluder *list;
};

/* Where to look. */
struct pp_occluders_scene {
    const struct pp_world *world;
    const struct pp_projection *view;
    int face;                   /* the surface that the view's plane lies in, or -1 */
    bool from_inside;           /* is there an inside, this side of the plane? */
    const double (*outline)[2]; /* corners of what is looked through */
    int outline_count;
    double low[2], high[2]; /* its extent along x and y */
};

/* Adds the pieces of all surfaces. Takes well under a microsecond and allocates nothing
 * where there are none, as in a convex room with nothing outside. */
enum pp_status pp_occluders_collect(struct pp_occluders *inside,
                                    struct pp_occluders *outside,
                                    const struct pp_occluders_scene *scene,
                                    struct pp_error *err);

/* The directions that a skyline hides, as half-spaces through the eye: it hides what is
 * neither above it (above.u > 0) nor under it (below.u > 0). */
struct pp_band {
    struct pp_vec3 above, below;
    struct pp_vec3 nearness; /* in the room's axes, of the vector from the eye */
};

struct pp_band pp_occluders_band(const struct pp_world *world,
                                 const struct pp_skyline *skyline, struct pp_vec3 eye);

/* Adds the piece that a skyline is, where it is in sight. */
enum pp_status pp_occluders_add_skyline(struct pp_occluders *outside,
                                        const struct pp_occluders_scene *scene,
                                        const struct pp_skyline *skyline,
                                        struct pp_error *err);

void pp_occluders_clear(struct pp_occluders *pieces);

#endif
