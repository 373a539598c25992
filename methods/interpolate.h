/* interpolate.h - interpolation in tables with equal steps and in published ones;
 * running integrals and inverses of the former. */
#ifndef PP_METHODS_INTERPOLATE_H
#define PP_METHODS_INTERPOLATE_H

/* The value at x of the cubic through the four entries nearest to x, of `count` (4 or
 * more) entries at equal steps from low to high. Outside that range it returns the
 * value at the nearer end. For a smooth function the error is 0.023 step^4 times the
 * fourth derivative, twice that in the first and last step. */
double pp_interpolate_cubic(const double *values, int count, double low, double high,
                            double x);

/* Replaces values[i] by the integral of a smooth function from low to the i-th of the
 * equal steps. Uses Gauss's rule of four points in each step, whose error falls with
 * the eighth power of the step. */
void pp_interpolate_tabulate_integral(double *values, int count, double low,
                                      double high,
                                      double (*function)(const void *context, double x),
                                      const void *context);

/* The x, within 1e-10 (high - low), at which an ascending table with equal steps
 * reaches `value`; low or high for a value outside the table. */
double pp_interpolate_inverse(const double *values, int count, double low, double high,
                              double value);

/* Linear interpolation at x between `count` (2 or more) rows {x, y}, x ascending;
 * before the first row it returns that row's y, and after the last row that row's. */
double pp_interpolate_linear(const double (*rows)[2], int count, double x);

/* The two rows that x lies between: returns the index of the upper one, 1 to count - 1,
 * and in *share the position of x from the lower (0) to the upper (1), cut to that
 * range. Rows are `width` numbers wide; `column` is the index of x in a row. */
int pp_interpolate_interval(const double *rows, int count, int width, int column,
                            double x, double *share);

#endif
