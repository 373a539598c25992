/* traced_plane.h - simulated daylight factor at any position on the working plane,
 * interpolated between simulated points.
 *
 * The points are the centres of squares that cover the plane. Squares near openings,
 * where daylight factors are steep, have a half or a quarter of the side length.
 * Daylight factors have kinks where the edge of a visible part of the sky appears,
 * which a fit of so few points cannot follow. Therefore the direct component of
 * `exact`, known at every place, is subtracted from the simulated factors at the points
 * and added again at the place: the sky component, and the externally reflected
 * component times the factor that fits the simulation best. The latter need not be
 * accurate, since the same amount is subtracted and added. Nothing is subtracted if
 * `exact` does not cover the room: light that blinds scatter has no kinks.
 *
 * The remainder is smooth. It is interpolated by a moving least squares fit of a
 * quadratic (moving_fit.h) to the points that are visible from the position, with
 * weights (1 - d²/R²)² and R at least 2.6 times the side of a square. Points behind the
 * corner of a wall, or behind a partition at the height of the plane, are not visible.
 * The standard error of the fit follows from the errors of the points and from their
 * correlation (common_error.h).
 */
#ifndef PP_STUDIES_TRACED_PLANE_H
#define PP_STUDIES_TRACED_PLANE_H

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/results/reading.h"
#include "model/room/world.h"

struct pp_traced_plane;

/* Chooses the points (the caller frees *points), and makes the plane for them, without
 * values. World and light must exist as long as the plane. */
enum pp_status pp_traced_plane_create(struct pp_traced_plane **plane,
                                      struct pp_receiver **points, int *count,
                                      const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      struct pp_error *err);
void pp_traced_plane_destroy(struct pp_traced_plane *plane); /* NULL is allowed */

/* Sets the daylight factors at the points in their order, the externally reflected
 * components at the points, and the common fraction of the variance of neighbouring
 * points. Points without a value are ignored. */
enum pp_status pp_traced_plane_fill(struct pp_traced_plane *plane,
                                    const struct pp_reading *factors,
                                    const struct pp_reading *external, double common,
                                    struct pp_error *err);

/* Functions of type pp_field_function whose context is the plane: the daylight factor
 * at a position, and its standard error. Both are 0 if no point has a value. */
enum pp_status pp_traced_plane_value(void *plane, double x, double y, double *value,
                                     struct pp_error *err);
enum pp_status pp_traced_plane_error(void *plane, double x, double y, double *value,
                                     struct pp_error *err);

#endif
