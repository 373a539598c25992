/* waldram_droop_lines.h - droop lines of Waldram's diagram: horizontal edges as drawn
 * on the diagram.
 *
 * With gamma the altitude and phi the azimuth from the window's normal [WW23]:
 *
 *     edges parallel to the window       tan gamma = tan gamma0 cos phi
 *     edges perpendicular to it          tan gamma = tan gamma90 |sin phi|
 *     edges at an angle delta to it      tan gamma = tan gamma_d cos(phi - delta)
 */
#ifndef PP_METHODS_WALDRAM_WALDRAM_DROOP_LINES_H
#define PP_METHODS_WALDRAM_WALDRAM_DROOP_LINES_H

#include "methods/waldram/waldram_scale.h"
#include "model/geometry/curve.h"

/* Lines of horizontal edges at the altitudes 10, 20 ... 80 degrees, in squares of
 * `width` by `height`. nearest: azimuth delta at which the edges are nearest (radians);
 * NAN: edges perpendicular to the window, on both sides. False: out of memory; the
 * caller clears the list in any case. */
bool pp_waldram_droop_lines(struct pp_curve_list *curves,
                            const struct pp_waldram *waldram, double nearest,
                            double width, double height);

#endif
