/* daylight_curves.h - contours of the daylight factor and the no-sky line, as curves.
 *
 * The direct component is that of `exact` at the working plane, facing up; a constant
 * may be added for the internally reflected component, as in A+B for a formula that
 * gives an average only. The no-sky line bounds the part of the working plane from
 * which no sky is seen directly, whatever the sky's luminance and the glass.
 *
 * Curves are accurate to a millimetre, or to 1/5000 of the plane's diagonal where that
 * is more; they begin and end on the plane's edge or are closed. Nearer to a wall than
 * 20 mm or 1/500 of that diagonal, the daylight factor is taken as at that distance.
 * The daylight factor is evaluated by fixed rules, to a relative error of 1e-5, or some
 * 1e-4 close to a pane, where the gradient is so steep that this moves the curve by
 * less than a millimetre.
 */
#ifndef PP_METHODS_DAYLIGHT_CURVES_H
#define PP_METHODS_DAYLIGHT_CURVES_H

#include "model/results/daylight_plan.h"
#include "model/base/error.h"
#include "model/room/world.h"

/* Fills plan (to be cleared by the caller; empty on failure).
 *
 * irc: internally reflected component added everywhere, a fraction, and irc_name the
 * name of its method ("bre"); irc_name NULL: nothing is added, and the name is "exact".
 * levels: daylight factors to contour, fractions, ascending; level_count 0: about seven
 * round ones (0.5, 1, 2, 3, 5, 10 per cent ...) within the room's own range. */
enum pp_status pp_daylight_curves(struct pp_daylight_plan *plan,
                                  const struct pp_world *world, double irc,
                                  const char *irc_name, const double *levels,
                                  int level_count, struct pp_error *err);

/* The no-sky line alone: no_sky, dark and sky_share of the plan, which is to be cleared
 * by the caller; empty on failure. */
enum pp_status pp_daylight_curves_no_sky(struct pp_daylight_plan *plan,
                                         const struct pp_world *world,
                                         struct pp_error *err);

/* The accuracy (m) of curves over a plane. */
double pp_daylight_curves_tolerance(const struct pp_region *plane);

/* The point at height z over (x, y), moved inside the plane so that it is at least
 * inset_m from the walls: along the inward normals of the edges that are nearer. On the
 * edge itself, in a window's plane or under one, the view of the outside is not
 * defined. */
struct pp_vec3 pp_daylight_curves_off_walls(const struct pp_region *plane, double z,
                                            double inset_m, double x, double y);

#endif
