/* interpolate.h - tables with even steps: reading between their lines, filling them with
 * a running integral, and finding where they reach a value. */
#ifndef PP_METHODS_INTERPOLATE_H
#define PP_METHODS_INTERPOLATE_H

/* The cubic through the four entries nearest to x, of `count` (4 or more) at even steps
 * from low to high. x outside is taken at the nearer end. For a smooth function the
 * error is 0.023 step^4 times its fourth derivative, twice that in the first and last
 * step. */
double pp_interpolate_cubic(const double *values, int count, double low, double high,
                            double x);

/* Fills values with the integral of a smooth function from low on: Gauss's rule of four
 * points in each step, whose error falls with the eighth power of the step. */
void pp_interpolate_tabulate_integral(double *values, int count, double low,
                                      double high,
                                      double (*function)(const void *context, double x),
                                      const void *context);

/* The x, within 1e-10 of high - low, at which an ascending table reaches `value`; low
 * or high where it never does. */
double pp_interpolate_inverse(const double *values, int count, double low, double high,
                              double value);

/* interpolate.h - reading a published table between its rows, as a straight-edge does.
 */

/* The value at x of the line through `count` (2 or more) rows {x, y}, x ascending;
 * the first row's before it, the last row's beyond. */
double pp_interpolate_linear(const double (*rows)[2], int count, double x);

/* Between which rows x lies: the index of the upper one, 1 to count - 1, and in *share
 * how far x is from the lower to the upper, 0 to 1; x outside is taken at the nearer
 * end. `column` is x's place in rows `width` numbers wide. */
int pp_interpolate_interval(const double *rows, int count, int width, int column,
                            double x, double *share);

#endif
