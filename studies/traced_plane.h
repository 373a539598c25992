/* traced_plane.h - simulated daylight factor at any place of the working plane,
 * interpolated between a number of simulated points.
 *
 * The points are the centres of squares that cover the plane. Squares near openings,
 * where daylight factors are steep, are a half or a quarter as large. Daylight factors
 * have kinks where the edge of a visible part of the sky appears, which a fit of so few
 * points cannot follow. Therefore the direct component of `exact`, known at every
 * place, is subtracted from the simulated factors at the points and added again at the
 * place: the sky component, and the externally reflected component times the factor
 * that fits the simulation best. The latter need not be accurate, since the same amount
 * is subtracted and added. Nothing is subtracted if `exact` does not cover the room: light
 * that blinds scatter has no kinks.
 *
 * The remainder is smooth. Between the points it is a moving least squares fit of a
 * quadratic (moving_fit.h; weights (1 - d²/R²)², R about two and a half squares wide)
 * to the points that are visible from the place: a wall's corner or a partition at the
 * height of the plane separates its two sides. The fit's standard error follows from
 * those of the points, and from their common part (common_error.h).
 */
#ifndef PP_STUDIES_TRACED_PLANE_H
#define PP_STUDIES_TRACED_PLANE_H

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/results/reading.h"
#include "model/room/world.h"

struct pp_traced_plane;

/* Chooses the points (the caller frees *points), and makes the plane for them, without
 * values yet. World and light must outlive it. */
enum pp_status pp_traced_plane_create(struct pp_traced_plane **plane,
                                      struct pp_receiver **points, int *count,
                                      const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      struct pp_error *err);
void pp_traced_plane_destroy(struct pp_traced_plane *plane); /* NULL is allowed */

/* Sets the daylight factors at the points, in their order, the externally reflected
 * components there, and the common share of the variance of neighbouring points; points
 * without a value are left out. */
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
