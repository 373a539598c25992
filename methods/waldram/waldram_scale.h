/* waldram_scale.h - the Waldram diagram: a map of the sky on which equal areas are
 * equal sky components.
 *
 * Upright lines of the sky stay upright: the abscissa X depends on the azimuth phi
 * alone (from the window's normal), the ordinate Y on the altitude gamma alone,
 *
 *     dSC = L(gamma) sin gamma cos gamma dgamma dphi = dX dY                  [WW23]
 *
 * without glass:  X = phi,  Y = sum of L sin gamma cos gamma from the horizon up:
 *                 sin^2 gamma / (2 pi) uniform,
 *                 (3 sin^2 gamma + 4 sin^3 gamma)/(14 pi) overcast.
 * with clear vertical glass the losses depend on cos i = cos gamma cos phi, which is no
 * product of a function of each. The diagram takes the losses by altitude times those
 * by azimuth, as though each stood alone, and so is right on both of its axes:
 *
 *     tau(cos gamma cos phi)  ->  tau(cos gamma) tau(cos phi) / tau(1)
 *
 * It never falls short; how far it is over is tabulated in the manual: 1 % for the mean
 * of ordinary windows, a few per cent for the largest seen from near by.
 *
 * Coordinates are fractions of Eh per unit area: a region's area is its sky component.
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
    bool glazed;           /* with the losses of clear single vertical glass */
    struct pp_glass glass; /* clear single, or none */
    double x[PP_WALDRAM_PANELS + 1]; /* X at even steps of azimuth from 0 to pi/2 */
    double y[PP_WALDRAM_PANELS + 1]; /* Y at even steps of altitude from 0 to pi/2 */
};

/* Makes the diagram of a sky whose luminance does not change with azimuth; any other is
 * refused. */
enum pp_status pp_waldram_scale_init(struct pp_waldram *waldram,
                                     const struct pp_sky *sky, bool glazed,
                                     struct pp_error *err);

/* Azimuth from -pi to pi, odd in it; with glass what lies beyond pi/2 adds nothing. */
double pp_waldram_scale_x(const struct pp_waldram *waldram, double azimuth_rad);

/* Altitude, 0 to pi/2; 0 below the horizon. Relative error of both scales 1e-9. */
double pp_waldram_scale_y(const struct pp_waldram *waldram, double altitude_rad);

/* Area of the map from azimuth -pi/2 to pi/2: 1/2 without glass. */
double pp_waldram_scale_total_area(const struct pp_waldram *waldram);

/* Area on the diagram of a region of a window's drawing, exact for the diagram's own
 * scales (relative error 1e-9): what lies below the horizon has none. Straight lines
 * of the plane become droop lines. A region round the zenith counts as it should. */
double pp_waldram_scale_area(const struct pp_waldram *waldram,
                             const struct pp_window_axes *axes,
                             const struct pp_region *region);

#endif
