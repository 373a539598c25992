/* daylight_curves.h - contours of the daylight factor and the no-sky line, as curves.
 *
 * The direct component is `exact`'s at the working plane, facing up; a constant may
 * stand for the internally reflected one, as it does in A+B for a formula that has only
 * an average. The no-sky line bounds the part of the working plane from which no sky
 * can be seen directly; it does not ask how bright the sky or how clear the glass is.
 *
 * Curves are true to a tolerance of a millimetre, or of 1/5000 of the plane's diagonal
 * where that is more; they begin and end on the plane's edge or are closed. Next to
 * a wall, within 20 mm or 1/500 of that diagonal, the daylight factor is taken as it is
 * there. It is evaluated by fixed rules: to 1e-5 of itself, to some 1e-4 close to a pane,
 * where it changes so fast that this is less than a millimetre of the curve's place.
 */
#ifndef PP_METHODS_DAYLIGHT_CURVES_H
#define PP_METHODS_DAYLIGHT_CURVES_H

#include "model/results/daylight_plan.h"
#include "model/base/error.h"
#include "model/room/world.h"

/* Fills plan (to be cleared by the caller; empty on failure).
 *
 * irc: added everywhere, a fraction, with the name of the method it is by ("bre");
 * irc_name NULL: nothing is added and the name is "exact".
 * levels: daylight factors to contour, fractions, ascending; level_count 0: seven or so
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

/* The tolerance (m) that curves over a plane are true to. */
double pp_daylight_curves_tolerance(const struct pp_region *plane);

#endif
