/* moving_fit.h - moving least squares fit of a quadratic: the value at a position is a
 * weighted sum of the values at points around it.
 *
 * The weights reproduce any quadratic that the points determine. If there are few
 * points, or all points are on a line, fewer terms are fitted. */
#ifndef PP_STUDIES_MOVING_FIT_H
#define PP_STUDIES_MOVING_FIT_H

/* Replaces the weights of the points (greater than 0) by the coefficients of the fit.
 * offsets: vectors from the position to the points, scaled to the order of 1. */
void pp_moving_fit_coefficients(double *weights, const double (*offsets)[2], int count);

#endif
