/* brs_rooflight.h - simplified daylight tables of rooflights, read at any point. */
#ifndef PP_METHODS_BRS_BRS_ROOFLIGHT_H
#define PP_METHODS_BRS_BRS_ROOFLIGHT_H

/* Sky component (a fraction) of a rooflight at 0, 30 or 60 degrees with one corner at
 * the origin of the table, from l/d or s/d and from w/d (each 0 to infinity; 0 for
 * negative ones). NAN for any other slope. */
double pp_brs_rooflight_read(int slope_deg, double up_over_d, double w_over_d);

#endif
