/* obstruction_factor.h - how much falls on a window from the sky and from what stands
 * before it.
 */
#ifndef PP_METHODS_REFLECTED_OBSTRUCTION_FACTOR_H
#define PP_METHODS_REFLECTED_OBSTRUCTION_FACTOR_H

/* Factor C of the BRE inter-reflection formula: illuminance of a vertical window from
 * above the horizon over Eh, CIE overcast sky, before an endless obstruction of
 * altitude angle_rad (0 to pi/2). A fraction, 0.39 to 0.05. The printed table
 * [BRE310], linear between its angles, its last value beyond them. What the
 * obstruction reflects is in it. */
double pp_obstruction_factor(double angle_rad);

#endif
