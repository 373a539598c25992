/* en17037_grid.h - how densely EN 17037 wants the reference plane to be covered. */
#ifndef PP_DESIGN_EN17037_GRID_H
#define PP_DESIGN_EN17037_GRID_H

/* Largest distance of neighbouring points (m), after [EN17037] annex B:
 *
 *     p = 0.5 * 5^(log10 d),   at most 10 m
 *
 * d is the longer side of the plane, or the shorter one where the longer is twice as
 * long or more (m, both greater than 0). */
double pp_en17037_spacing(double width_m, double depth_m);

#endif
