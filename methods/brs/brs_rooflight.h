/* brs_rooflight.h - simplified daylight tables of rooflights, read at any point. */
#ifndef PP_METHODS_BRS_BRS_ROOFLIGHT_H
#define PP_METHODS_BRS_BRS_ROOFLIGHT_H

/* Sky component (a fraction) of a rooflight that slopes at 0, 30 or 60 degrees and has
 * one corner at the origin of the table. The arguments are l/d or s/d, and w/d, each up
 * to infinity; the component is 0 if one is negative. NAN for any other slope. */
double pp_brs_rooflight_read(int slope_deg, double up_over_d, double w_over_d);

#endif
