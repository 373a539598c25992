/* polynomial.h - the polynomial through given values, for piecewise tables. */
#ifndef PP_MODEL_GEOMETRY_POLYNOMIAL_H
#define PP_MODEL_GEOMETRY_POLYNOMIAL_H

enum { PP_POLYNOMIAL_MOST = 8 };

/* Finds the polynomial of least degree that has values[i] at at[i], by Newton's divided
 * differences. powers[k] is the coefficient of t^k. The `count` positions, 1 to
 * PP_POLYNOMIAL_MOST, must differ. */
static inline void pp_polynomial_through(double *powers, const double *at,
                                         const double *values, int count)
{
    double of[PP_POLYNOMIAL_MOST];
    for (int i = 0; i < count; i++) {
        of[i] = values[i];
        powers[i] = 0.0;
    }
    for (int order = 1; order < count; order++)
        for (int i = count - 1; i >= order; i--)
            of[i] = (of[i] - of[i - 1]) / (at[i] - at[i - order]);
    powers[0] = of[count - 1];
    for (int i = count - 2; i >= 0; i--) { /* times t - at[i], plus the difference */
        for (int k = count - 1; k > 0; k--)
            powers[k] = powers[k - 1] - at[i] * powers[k];
        powers[0] = of[i] - at[i] * powers[0];
    }
}

#endif
