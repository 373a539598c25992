/* brs_table.h - the BRS simplified daylight table [HLG58], read at any point. */
#ifndef PP_METHODS_BRS_BRS_TABLE_H
#define PP_METHODS_BRS_BRS_TABLE_H

/* Sky component (a fraction, 0 to 0.15) of a window with its sill level with the point
 * and one jamb on the normal through the point, from h/d and w/d (each 0 to infinity;
 * 0 for negative ones). Equal to the printed value where there is one; the rules of
 * interpolation are in brs_table.c. */
double pp_brs_table_read(double h_over_d, double w_over_d);

#endif
