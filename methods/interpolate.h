/* interpolate.h - interpolation in published tables and in tables with equal steps;
 * also integrals and inverses of tables with equal steps. */
#ifndef PP_METHODS_INTERPOLATE_H
#define PP_METHODS_INTERPOLATE_H

/* The value at x of the cubic through the four entries nearest to x, of `count` (4 or
 * more) entries at equal steps from low to high. Outside that range, returns the value
 * at the nearer end. For a smooth function the error is 0.023 step^4 times the fourth
 * derivative, and twice as much in the first and last step. */
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

/* Linear interpolation at x between `count` (2 or more) rows {x, y}, x ascending.
 * Outside the range of x, returns y of the nearest row. */
double pp_interpolate_linear(const double (*rows)[2], int count, double x);

/* Finds the two rows between which x lies. Returns the index of the upper row, 1 to
 * count - 1. *share is the position of x from the lower row (0) to the upper row (1),
 * limited to that range. Rows have `width` numbers; `column` is the index of x in a
 * row. */
int pp_interpolate_interval(const double *rows, int count, int width, int column,
                            double x, double *share);

#endif
