/* moving_fit.h - a moving least squares fit of a quadratic: the value at a place is a
 * weighted sum of the values at points around it.
 *
 * The weights reproduce every quadratic that the points can determine; with few points,
 * or points on a line, fewer terms are fitted. */
#ifndef PP_STUDIES_MOVING_FIT_H
#define PP_STUDIES_MOVING_FIT_H

/* Replaces the points' weights (above 0) by the coefficients of the fit. offsets: from
 * the place to the points, scaled to be of order 1. */
void pp_moving_fit_coefficients(double *weights, const double (*offsets)[2], int count);

#endif
