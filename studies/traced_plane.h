/* traced_plane.h - the traced daylight factor at any place of the working plane, from a
 * number of points that were traced.
 *
 * The points are the middles of squares that cover the plane, half and a quarter as large
 * near openings, where daylight factors are steep. Daylight factors
 * bend where the edge of some sky comes into view, which no fit of so few points follows.
 * So the direct component of `exact`, which is known at every place, is taken off the traced
 * factors at the points and added again at the place: all of its sky component, and as much
 * of its externally reflected one as the traced is most like. The latter has another meaning
 * and need not agree: what is taken off and added is the same.
 *
 * The rest is smooth. Between the points it is a moving least squares fit of a quadratic
 * (moving_fit.h; weights (1 - d²/R²)², R some two and a half squares wide) to the points
 * that are in sight of the place: a wall's corner or a partition at the height of the plane
 * parts what lies on its two sides. The fit's standard error follows from those of the
 * points, and from what they have in common (common_error.h).
 */
#ifndef PP_STUDIES_TRACED_PLANE_H
#define PP_STUDIES_TRACED_PLANE_H

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/results/reading.h"
#include "model/room/world.h"

struct pp_traced_plane;

/* Chooses the points (*points is the caller's to free), and makes the plane that they are
 * of, without values yet. World and light must live as long. */
enum pp_status pp_traced_plane_create(struct pp_traced_plane **plane,
                                      struct pp_receiver **points, int *count,
                                      const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      struct pp_error *err);
void pp_traced_plane_destroy(struct pp_traced_plane *plane); /* NULL is allowed */

/* The daylight factors at the points, in their order, the externally reflected components
 * there, and the share of the factors' variance that points near each other have in common;
 * points without a value are left out. */
enum pp_status pp_traced_plane_fill(struct pp_traced_plane *plane,
                                    const struct pp_reading *factors,
                                    const struct pp_reading *external, double common,
                                    struct pp_error *err);

/* A pp_field_function whose context is the plane: the daylight factor at a place, and
 * its standard error. 0 if no point has a value. */
enum pp_status pp_traced_plane_value(void *plane, double x, double y, double *value,
                                     struct pp_error *err);
enum pp_status pp_traced_plane_error(void *plane, double x, double y, double *value,
                                     struct pp_error *err);

#endif
