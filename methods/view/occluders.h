/* occluders.h - the surfaces in a view, cut to the view and projected on to its plane.
 *
 * Surfaces are cut in space to the view's pyramid, so that no part behind the eye or
 * outside the pyramid is projected. Surfaces are also cut at the opening's plane: the
 * part on the near side is an occluder inside, the part on the far side an obstruction
 * outside.
 */
#ifndef PP_METHODS_VIEW_OCCLUDERS_H
#define PP_METHODS_VIEW_OCCLUDERS_H

#include <stdbool.h>

#include "model/geometry/projection.h"
#include "model/geometry/region.h"
#include "model/room/world.h"

/* A point nearer to a plane than this (m) counts as lying in the plane. */
#define PP_OCCLUDERS_COPLANAR_M 1e-9

/* A convex piece of one surface, or of a skyline, projected on to the view's plane. */
struct pp_occluder {
    int count;
    double (*xy)[2]; /* corners, clockwise or counter-clockwise */
    /* nearness . (x, y, distance_m) is one over the distance along the ray to (x, y),
     * in units of that vector: of two surfaces the one with the larger value is in
     * front. */
    struct pp_vec3 nearness;
    double reflectance, exitance; /* properties of the visible side */
};

struct pp_occluders {
    int count, capacity;
    struct pp_occluder *list;
};

/* A view of a world. */
struct pp_occluders_scene {
    const struct pp_world *world;
    const struct pp_projection *view;
    int face;                   /* index of the surface in the view's plane; -1: none */
    bool from_inside;           /* true: the near side of the plane is inside the
                                 * room */
    const double (*outline)[2]; /* corners of the outline that the view looks through */
    int outline_count;
    double low[2], high[2]; /* the outline's extent along x and y */
};

/* Adds the pieces of all surfaces. A convex room without obstructions has none; the
 * call then takes well under a microsecond and allocates nothing. */
enum pp_status pp_occluders_collect(struct pp_occluders *inside,
                                    struct pp_occluders *outside,
                                    const struct pp_occluders_scene *scene,
                                    struct pp_error *err);

/* Directions hidden by a skyline without a distance: neither above the skyline (above.u
 * > 0) nor below the horizon (below.u > 0). */
struct pp_band {
    struct pp_vec3 above, below;
};

struct pp_band pp_occluders_band(const struct pp_world *world,
                                 const struct pp_skyline *skyline);

/* Adds the visible part of a skyline without a distance as a piece behind all
 * others. */
enum pp_status pp_occluders_add_skyline(struct pp_occluders *outside,
                                        const struct pp_occluders_scene *scene,
                                        const struct pp_skyline *skyline,
                                        struct pp_error *err);

void pp_occluders_clear(struct pp_occluders *pieces);

#endif
