/* moving_fit.h - a moving least squares fit of a quadratic: the value at a place is a sum of
 * the values at points around it.
 *
 * Coefficients c reproduce every quadratic that the points tell apart; of few points, or
 * points on a line, less. */
#ifndef PP_STUDIES_MOVING_FIT_H
#define PP_STUDIES_MOVING_FIT_H

/* Replaces the points' weights (above 0) by the coefficients of the fit. offsets: from
 * the place, in any unit of length of their own order. */
void pp_moving_fit_coefficients(double *weights, const double (*offsets)[2], int count);

#endif
