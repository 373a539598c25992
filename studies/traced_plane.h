/* traced_plane.h - the traced daylight factor at any place of the working plane, from a
 * number of points that were traced.
 *
 * The points are the middles of squares that cover the plane, half and a quarter as large
 * near openings, where daylight factors are steep. Between them the logarithm of the factor
 * is a moving least squares fit of a quadratic (weights (1 - d²/R²)², R some two and a half
 * squares wide) to the points that are in sight of the place: a wall's corner or a partition
 * at the height of the plane parts what lies on its two sides. The fit's standard error
 * follows from those of the points, and from what they have in common (common_error.h).
 */
#ifndef PP_STUDIES_TRACED_PLANE_H
#define PP_STUDIES_TRACED_PLANE_H

#include "model/base/error.h"
#include "model/results/reading.h"
#include "model/room/world.h"

struct pp_traced_plane;

/* Chooses the points (*points is the caller's to free), and makes the plane that they are
 * of, without values yet. */
enum pp_status pp_traced_plane_create(struct pp_traced_plane **plane,
                                      struct pp_receiver **points, int *count,
                                      const struct pp_world *world,
                                      struct pp_error *err);
void pp_traced_plane_destroy(struct pp_traced_plane *plane); /* NULL is allowed */

/* The readings at the points, in their order, and the share of their variance that is
 * common; those without a value are left out. */
void pp_traced_plane_fill(struct pp_traced_plane *plane,
                          const struct pp_reading *readings, double common);

/* As pp_field_function has it (the context is the plane): the daylight factor at a place,
 * and its standard error. 0 where no point has a value. */
enum pp_status pp_traced_plane_value(void *plane, double x, double y, double *value,
                                     struct pp_error *err);
enum pp_status pp_traced_plane_error(void *plane, double x, double y, double *value,
                                     struct pp_error *err);

#endif
