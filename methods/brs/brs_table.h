/* brs_table.h - the BRS simplified daylight table [HLG58], read at any point. */
#ifndef PP_METHODS_BRS_BRS_TABLE_H
#define PP_METHODS_BRS_BRS_TABLE_H

/* Sky component (a fraction, 0 to 0.15) of a window with its sill level with the point
 * and one jamb on the normal through the point. h/d and w/d may be infinite; the
 * component is 0 if either is negative. Printed values are reproduced; brs_table.c
 * describes the interpolation between them. */
double pp_brs_table_read(double h_over_d, double w_over_d);

/* Position of a reading in the table; h/d and w/d are above 0. Rows run from 0
 * (infinity) to 28 (0.1); row 29 is zero. Columns run from 0 (0.1) to 19 (infinity);
 * column -1 is zero. Values between rows or columns are linear in these positions. */
void pp_brs_table_place(double h_over_d, double w_over_d, double *row, double *column);

/* Printed h/d of a row, w/d of a column, and value in per cent. */
double pp_brs_table_h_over_d(int row);
double pp_brs_table_w_over_d(int column);
double pp_brs_table_percent(int row, int column);

#endif
