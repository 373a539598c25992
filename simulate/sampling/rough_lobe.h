/* rough_lobe.h - samples the lobe of a physically rough surface
 * (model/light/rough/rough_surface.h).
 *
 * i is the direction of the eye, r the sampled direction. The length of i_xy + r_xy is
 * drawn from the surface's table of the lobe's light, interpolated between two angles
 * of incidence. Its azimuth is drawn uniformly among those for which r exists. Density
 * per steradian of r:
 *
 *     p = P cos r / ((R1^2 - R0^2) phi)
 *
 * where P is the probability of the table's interval from radius R0 to R1, and phi the
 * largest azimuth. All directions are in the surface's frame: z is its normal.
 */
#ifndef PP_SIMULATE_SAMPLING_ROUGH_LOBE_H
#define PP_SIMULATE_SAMPLING_ROUGH_LOBE_H

#include "model/light/rough/rough_surface.h"

/* Samples a direction for the eye by two numbers in (0, 1). Returns 1 divided by its
 * density; 0 if there is no lobe. */
double pp_rough_lobe_sample(const struct pp_rough_surface *surface, struct pp_vec3 eye,
                            double u, double v, struct pp_vec3 *to);

/* Density (per steradian) with which pp_rough_lobe_sample gives direction `to`. */
double pp_rough_lobe_pdf(const struct pp_rough_surface *surface, struct pp_vec3 eye,
                         struct pp_vec3 to);

#endif
