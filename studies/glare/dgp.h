/* dgp.h - daylight glare probability, and the position index of a glare source.
 *
 * After Wienold and Christoffersen [WC06]:
 *
 *     DGP = 5.87e-5 Ev + 0.0918 lg(1 + sum of L^2 omega / (Ev^1.87 P^2)) + 0.16     (1)
 *
 *   Ev     vertical illuminance at the eye, lx
 *   L      luminance of a source, cd/m2;  omega  its solid angle, sr
 *   P      its position index
 *
 * DGP is the fraction of people disturbed, at most 1. The formula was fitted to DGP of
 * 0.2 to 0.8 and Ev above 380 lx. If Ev is below 1000 lx, the program evalglare
 * multiplies DGP by
 *
 *     exp(0.024 Ev - 4)/(1 + exp(0.024 Ev - 4))                                     (2)
 *
 * and so does pepperpot. evalglare 3.06 has the constants 0.092 and 0.159 in (1), which
 * changes DGP by at most 0.001 if the logarithm is at most 5.
 *
 * P is Guth's index above the line of sight [WC06] and Iwata and Tokura's index below
 * it [IT97], as in evalglare 3.06. s is the angle from the line of sight, t the angle
 * from the vertical plane through the line of sight, both in degrees:
 *
 *     above  P = exp[(35.2 - 0.31889 t - 1.22 exp(-2 t/9)) 1e-3 s                   (3)
 *                    + (21 + 0.26667 t - 0.002963 t^2) 1e-5 s^2]
 *     below  P = exp(6.49e-3 B + 21e-5 B^2),  tan B = tan s sqrt(1 + 0.3225 cos^2 t)
 *
 * P is at most 16.
 */
#ifndef PP_STUDIES_GLARE_DGP_H
#define PP_STUDIES_GLARE_DGP_H

#include "model/geometry/frame.h"

/* Position index P in unit direction u. view: x to the right of the eye, y up, z along
 * the line of sight. P is 16 at 90 degrees or more from the line of sight. */
double pp_dgp_position_index(const struct pp_frame *view, struct pp_vec3 u);

/* DGP from (1) and (2); 0 if there is no light. eye_lx: Ev; sum: sum of L^2 omega/P^2,
 * cd2/m4 sr. */
double pp_dgp(double eye_lx, double sum);

#endif
