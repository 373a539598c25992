/* hunt_switching.h - probability that occupants switch the light on when they arrive
 * [HUNT80].
 *
 *   P = a + c/(1 + exp(-b (x - m))),  x = lg(E)
 *
 * E is the lowest daylight illuminance on the working area (lx). The formula is valid
 * from 10^0.843 = 7 to 10^2.818 = 658 lx; P is 1 below and 0 above. According to Hunt's
 * observations, people do not switch the light off before they leave.
 */
#ifndef PP_STUDIES_LIGHTING_HUNT_SWITCHING_H
#define PP_STUDIES_LIGHTING_HUNT_SWITCHING_H

double pp_hunt_switching_probability(double E);

#endif
