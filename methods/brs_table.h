/* brs_table.h - the BRS simplified daylight table, read at any point. */
#ifndef PP_METHODS_BRS_TABLE_H
#define PP_METHODS_BRS_TABLE_H

/* Sky component (a fraction, 0 to 0.15) of a window with its sill level with the point
 * and one jamb square before it, from h/d and w/d (each 0 to infinity; 0 for less):
 * the printed value where there is one. Rules of reading: brs_table.c. */
double pp_brs_table_read(double h_over_d, double w_over_d);

#endif
