/* hidden_cones.h - the directions that obstructions hide from a point, as convex cones.
 *
 * A cone is the directions u with n.u >= 0 for each of its half-spaces n; a convex
 * polygon with corners v seen from e hides the cone of
 *
 *     n_i = (v_i - e) x (v_i+1 - e)
 *
 * or of -n_i, depending on the side from which the polygon is seen. A non-convex
 * surface hides the cones of its triangles, a skyline the directions between its foot
 * and its head.
 *
 * Each cone of a polygon has a circular cap about the mean direction to the polygon's
 * corners, as wide as the farthest corner. A cap of less than a hemisphere is convex
 * and therefore contains the cone. If a cap is clear of a path of the sun, the
 * half-spaces of its cone need no test.
 */
#ifndef PP_METHODS_EXACT_HIDDEN_CONES_H
#define PP_METHODS_EXACT_HIDDEN_CONES_H

#include "model/room/world.h"

/* Cosine of the radius of the widest cap; a cone that needs a wider one has no cap. */
#define PP_HIDDEN_CONE_COS_WIDEST 0.5

struct pp_hidden_cone {
    int end;             /* index past the cone's last half-space, in half_spaces */
    struct pp_vec3 axis; /* unit axis of the cap; zero vector: no cap */
    double cos_radius, sin_radius;
};

struct pp_hidden_cones {
    struct pp_vec3 *half_spaces; /* half-spaces of all cones, cone after cone */
    int half_space_count, half_space_capacity;
    struct pp_hidden_cone *list;
    int count, capacity;
};

/* Viewpoint from which the sky is seen: a point in the outer plane of a wall or, if
 * `opening` is not NULL, in the inner plane, where the sides of that opening also hide
 * sky. */
struct pp_hidden_view {
    struct pp_vec3 eye;
    struct pp_vec3 out; /* unit normal of the plane; directions behind it are hidden */
    int face;           /* index of the face in whose plane the viewpoint lies; this
                         * face hides nothing */
    const struct pp_opening *opening;
};

/* The viewpoint at the centre of an opening's outside, as for the vertical sky
 * component. */
struct pp_hidden_view pp_hidden_cones_outside(const struct pp_opening *opening);

/* Fills cones with the hidden directions of the upper hemisphere; on success the caller
 * clears them. Obstructions are those of the vertical sky component
 * (methods/exact/exterior.h). */
enum pp_status pp_hidden_cones_init(struct pp_hidden_cones *cones,
                                    const struct pp_world *world,
                                    const struct pp_hidden_view *view,
                                    struct pp_error *err);

/* Also hides the directions u with n.u >= 0. */
enum pp_status pp_hidden_cones_add_half_space(struct pp_hidden_cones *cones,
                                              struct pp_vec3 n, struct pp_error *err);
void pp_hidden_cones_clear(struct pp_hidden_cones *cones);

/* True if a direction of the upper hemisphere (room's axes) is hidden. */
bool pp_hidden_cones_hide(const struct pp_hidden_cones *cones, struct pp_vec3 u);

#endif
