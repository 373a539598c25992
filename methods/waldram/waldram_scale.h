/* waldram_scale.h - the Waldram diagram: a map of the sky on which equal areas are
 * equal sky components [WW23].
 *
 * Vertical lines of the sky stay vertical: the abscissa X depends on the azimuth phi
 * alone (from the window's normal), the ordinate Y on the altitude gamma alone,
 *
 *     dSC = L(gamma) sin gamma cos gamma dgamma dphi = dX dY                  [WW23]
 *
 * Without glass, with Y the integral of L sin gamma cos gamma from the horizon up:
 *
 *     X = phi
 *     Y = p sin^2 gamma / pi + q sin^3 gamma / 2             p, q of graded_sky.h
 *
 * With clear vertical glass the losses depend on cos i = cos gamma cos phi, which is
 * not a product of a function of gamma and one of phi. The diagram uses the product of
 * the losses at azimuth 0 and those at the horizon, which is exact on both axes:
 *
 *     tau(cos gamma cos phi)  ->  tau(cos gamma) tau(cos phi) / tau(1)
 *
 * This never underestimates the sky component. The manual tabulates the overestimate: 1
 * % on average for ordinary windows, a few per cent close to the largest ones.
 *
 * Luminances are divided by Eh, so that the area of a region is its sky component, a
 * fraction.
 *
 * A second diagram is for a vertical receiver, as used in [BR209] for the vertical sky
 * component of a wall. There, cos i = cos gamma cos phi is already a product, so that
 * without glass
 *
 *     dVSC = L(gamma) cos^2 gamma dgamma cos phi dphi = dX dY
 *
 *     X = sin phi
 *     Y = p (gamma + sin gamma cos gamma) / pi + q (1 - cos^3 gamma) / 2
 *
 * Its total area is p + q: 39.6 % for the overcast sky, 1/2 for the uniform one.
 */
#ifndef PP_METHODS_WALDRAM_WALDRAM_SCALE_H
#define PP_METHODS_WALDRAM_WALDRAM_SCALE_H

#include <stdbool.h>

#include "methods/view/window_drawing.h"
#include "model/base/error.h"
#include "model/light/glass.h"
#include "model/geometry/region.h"
#include "model/light/sky.h"
#include "model/geometry/vec.h"

enum { PP_WALDRAM_PANELS = 256 };

struct pp_waldram {
    struct pp_sky sky;     /* without azimuth dependence */
    bool glazed;           /* true: with the losses of clear single vertical glass */
    bool upright;          /* true: the receiver is a wall's outside; false: it faces
                            * up */
    struct pp_vec3 facing; /* normal of a vertical receiver, unit, horizontal */
    struct pp_glass glass; /* clear single, or none */
    double x[PP_WALDRAM_PANELS + 1]; /* X at equal steps of azimuth from 0 to pi/2 */
    double y[PP_WALDRAM_PANELS + 1]; /* Y at equal steps of altitude from 0 to pi/2 */
};

/* Makes the diagram of a sky whose luminance does not depend on azimuth; PP_BAD_INPUT
 * for any other. */
enum pp_status pp_waldram_scale_init(struct pp_waldram *waldram,
                                     const struct pp_sky *sky, bool glazed,
                                     struct pp_error *err);

/* Makes the diagram of a vertical receiver with that normal (unit, horizontal), without
 * glass. */
enum pp_status pp_waldram_scale_init_upright(struct pp_waldram *waldram,
                                             const struct pp_sky *sky,
                                             struct pp_vec3 facing,
                                             struct pp_error *err);

/* Direction of a point of a window's drawing in the diagram's axes: x to the right, y
 * ahead, z up; not of unit length. Ahead is the normal of a vertical receiver,
 * otherwise the horizontal direction perpendicular to `along`: that of `out`, unless
 * the opening is horizontal. */
struct pp_vec3 pp_waldram_scale_direction(const struct pp_waldram *waldram,
                                          const struct pp_window_axes *axes,
                                          const double xy[2]);

/* X of an azimuth from -pi to pi, odd in the azimuth; with glass X is constant from
 * pi/2 on. */
double pp_waldram_scale_x(const struct pp_waldram *waldram, double azimuth_rad);

/* Y of an altitude, 0 to pi/2; 0 below the horizon. Relative error of both scales
 * 1e-9. */
double pp_waldram_scale_y(const struct pp_waldram *waldram, double altitude_rad);

/* Y of the altitude of a direction, of any length. */
double pp_waldram_scale_y_toward(const struct pp_waldram *waldram, struct pp_vec3 u);

/* Area of the map from azimuth -pi/2 to pi/2: 1/2 without glass for a receiver that
 * faces up. */
double pp_waldram_scale_total_area(const struct pp_waldram *waldram);

/* Area on the diagram of a region of a window's drawing, for the diagram's own scales
 * (relative error 1e-9); the part below the horizon has no area. Straight lines of the
 * drawing are droop lines on the diagram. The region may contain the zenith. */
double pp_waldram_scale_area(const struct pp_waldram *waldram,
                             const struct pp_window_axes *axes,
                             const struct pp_region *region);

#endif
