/* daylight_curves.h - contours of the daylight factor and the no-sky line, as curves.
 *
 * The direct component is that of `exact` for receivers on the working plane that face
 * up. A constant may be added for the internally reflected component, as in a pair A+B
 * in which B gives an average. The no-sky line bounds the part of the working plane
 * from which no sky is seen directly, whatever the sky's luminance and the glass.
 *
 * Curves are accurate to a millimetre, or to 1/5000 of the plane's diagonal if that is
 * more; they begin and end on the plane's edge or are closed. direct_plane.h defines
 * the values close to walls and openings. The direct component of `exact` is evaluated
 * to 1e-6 of the open sky; for non-uniformly lit diffusing panes it is evaluated by
 * fixed rules, to a relative error of 1e-5, or of about 1e-4 close to the pane.
 */
#ifndef PP_METHODS_DAYLIGHT_CURVES_H
#define PP_METHODS_DAYLIGHT_CURVES_H

#include "model/light/outside_light.h"
#include "model/results/daylight_plan.h"
#include "model/base/error.h"
#include "model/base/stop.h"
#include "model/geometry/contour/field.h"
#include "model/room/world.h"

struct pp_method; /* methods/method.h */

/* Fills plan (to be cleared by the caller; empty on failure).
 *
 * irc: internally reflected component added everywhere, a fraction, and irc_name the
 * name of its method ("bre"); irc_name NULL: nothing is added, and the name is "exact".
 * levels: daylight factors to contour, fractions, ascending; level_count 0: up to 14
 * round levels (0.5, 1, 2, 3, 5, 10 per cent ...) within the room's range. */
enum pp_status pp_daylight_curves(struct pp_daylight_plan *plan,
                                  const struct pp_world *world,
                                  const struct pp_outside_light *light, double irc,
                                  const char *irc_name, const double *levels,
                                  int level_count, struct pp_error *err);

/* Levels as above, and the tolerance of the curves (m; 0: the default). All zero: the
 * defaults. */
struct pp_daylight_curves_choice {
    const double *levels;
    int level_count;
    double tolerance_m;
    struct pp_stop stop;
};

/* Fills plan as pp_daylight_curves does, but with the direct component by any method
 * that gives values at points and does not count squares or dots. The plan's name is
 * "direct+irc_name". If irc_name is NULL, the figures are the direct component only.
 * PP_BAD_INPUT with the reason if the method does not cover the room. */
enum pp_status pp_daylight_curves_by(struct pp_daylight_plan *plan,
                                     const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_method *direct, double irc,
                                     const char *irc_name,
                                     struct pp_daylight_curves_choice choice,
                                     struct pp_error *err);

/* Finds contours of any daylight factor over the working plane, at round levels as
 * above, and the no-sky line. `errors` gives the standard error, for bands about the
 * contours; NULL: no bands. Both functions are called with `context`. */
enum pp_status pp_daylight_curves_of(struct pp_daylight_plan *plan,
                                     const struct pp_world *world, const char *name,
                                     pp_field_function values, pp_field_function errors,
                                     void *context, struct pp_error *err);

/* Finds the no-sky line alone: no_sky, dark and sky_share of the plan. The caller
 * clears the plan; empty on failure. */
enum pp_status pp_daylight_curves_no_sky(struct pp_daylight_plan *plan,
                                         const struct pp_world *world,
                                         struct pp_error *err);

/* The default accuracy (m) of curves over a plane. */
double pp_daylight_curves_tolerance(const struct pp_region *plane);

#endif
