/* hidden_cones.h - the directions that obstructions hide from a point, as convex cones.
 *
 * A cone is the directions u with n.u >= 0 for each of its half-spaces n; a convex
 * polygon with corners v seen from e hides the cone of
 *
 *     n_i = (v_i - e) x (v_i+1 - e)
 *
 * or of -n_i, depending on the side from which it is seen. A non-convex surface hides
 * the cones of its triangles, a skyline the directions between its foot and its head.
 *
 * Each cone of a polygon lies in the cap of directions about the mean of those to its
 * corners, as wide as the farthest of them: caps of less than a hemisphere are convex.
 * Cones that are far from a path of the sun are recognised by their caps alone, without
 * their half-spaces.
 */
#ifndef PP_METHODS_EXACT_HIDDEN_CONES_H
#define PP_METHODS_EXACT_HIDDEN_CONES_H

#include "model/room/world.h"

/* The widest cap that is used; a cone that needs a wider one has none. */
#define PP_HIDDEN_CONE_COS_WIDEST 0.5

struct pp_hidden_cone {
    int end;             /* the index past its last half-space */
    struct pp_vec3 axis; /* of its cap, unit; of no length where it has none */
    double cos_radius, sin_radius;
};

struct pp_hidden_cones {
    struct pp_vec3 *half_spaces; /* of all cones, one cone behind the other */
    int half_space_count, half_space_capacity;
    struct pp_hidden_cone *list;
    int count, capacity;
};

/* Viewpoint of the open air: a point in the outer plane of a wall. If `opening` is not
 * NULL it is in the inner plane, where the sides of that opening hide the sky as
 * well. */
struct pp_hidden_view {
    struct pp_vec3 eye;
    struct pp_vec3 out; /* unit normal of the plane; directions behind it are hidden */
    int face;           /* that the plane belongs to: it hides nothing itself */
    const struct pp_opening *opening;
};

/* The middle of an opening's outside, as of the vertical sky component. */
struct pp_hidden_view pp_hidden_cones_outside(const struct pp_opening *opening);

/* Fills cones with the hidden directions of the upper hemisphere; on success the caller
 * clears them. Obstructions are those of the vertical sky component
 * (methods/exact/exterior.h). */
enum pp_status pp_hidden_cones_init(struct pp_hidden_cones *cones,
                                    const struct pp_world *world,
                                    const struct pp_hidden_view *view,
                                    struct pp_error *err);
void pp_hidden_cones_clear(struct pp_hidden_cones *cones);

#endif
