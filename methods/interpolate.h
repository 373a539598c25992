/* interpolate.h - tables with even steps: reading between their lines, filling them with
 * a running integral, and finding where they reach a value. */
#ifndef PP_METHODS_EVEN_TABLE_H
#define PP_METHODS_EVEN_TABLE_H

/* The cubic through the four entries nearest to x, of `count` (4 or more) at even steps
 * from low to high. x outside is taken at the nearer end. For a smooth function the
 * error is 0.023 step^4 times its fourth derivative, twice that in the first and last
 * step. */
double pp_even_table(const double *values, int count, double low, double high,
                     double x);

/* Fills values with the integral of a smooth function from low on: Gauss's rule of four
 * points in each step, whose error falls with the eighth power of the step. */
void pp_even_table_integrate(double *values, int count, double low, double high,
                             double (*function)(const void *context, double x),
                             const void *context);

/* The x, within 1e-10 of high - low, at which an ascending table reaches `value`; low
 * or high where it never does. */
double pp_even_table_find(const double *values, int count, double low, double high,
                          double value);

#endif
