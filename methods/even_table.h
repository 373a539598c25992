/* even_table.h - reading between the lines of a table with even steps. */
#ifndef PP_METHODS_EVEN_TABLE_H
#define PP_METHODS_EVEN_TABLE_H

/* The cubic through the four entries nearest to x, of `count` (4 or more) at even steps
 * from low to high. x outside is taken at the nearer end. For a smooth function the
 * error is 0.023 step^4 times its fourth derivative, twice that in the first and last
 * step. */
double pp_even_table(const double *values, int count, double low, double high,
                     double x);

#endif
