/* hidden_cones.h - the directions that what stands outside hides from a point, as convex
 * cones.
 *
 * A cone is the directions u with n.u >= 0 for each of its half-spaces n; a convex
 * polygon with corners v seen from e hides the one of
 *
 *     n_i = (v_i - e) x (v_i+1 - e)
 *
 * or of -n_i, by the side from which it is seen. A surface that is not convex hides the
 * cones of its triangles, a skyline what lies between its foot and its head.
 */
#ifndef PP_METHODS_EXACT_HIDDEN_CONES_H
#define PP_METHODS_EXACT_HIDDEN_CONES_H

#include "model/room/world.h"

struct pp_hidden_cones {
    struct pp_vec3 *half_spaces; /* of all cones, one cone behind the other */
    int half_space_count, half_space_capacity;
    int *ends; /* for each cone the index past its last half-space */
    int count, capacity;
};

/* Where the open air is looked at from: a point in the plane of a wall's outside or, as
 * `opening` is not NULL, of its inside, where the sides of that opening hide as well. */
struct pp_hidden_view {
    struct pp_vec3 eye;
    struct pp_vec3 out; /* unit, square to the plane; what lies behind it is hidden */
    int face;           /* that the plane belongs to: it hides nothing itself */
    const struct pp_opening *opening;
};

/* The middle of an opening's outside, as of the vertical sky component. */
struct pp_hidden_view pp_hidden_cones_outside(const struct pp_opening *opening);

/* Fills cones with what hides the upper half of the sky's directions: on success to be
 * cleared. Obstructions are those of the vertical sky component (methods/exact/exterior.h). */
enum pp_status pp_hidden_cones_init(struct pp_hidden_cones *cones,
                                    const struct pp_world *world,
                                    const struct pp_hidden_view *view,
                                    struct pp_error *err);
void pp_hidden_cones_clear(struct pp_hidden_cones *cones);

#endif
