/* moving_fit.h - a moving least squares fit of a quadratic: the value at a place is a sum of
 * the values at points around it.
 *
 * Coefficients c reproduce every quadratic that the points tell apart; of few points, or
 * points on a line, less. */
#ifndef PP_STUDIES_MOVING_FIT_H
#define PP_STUDIES_MOVING_FIT_H

/* From the points' weights (above 0) and their offsets from the place, over any length of
 * the order of theirs, the coefficients: in place of the weights. */
void pp_moving_fit_coefficients(double *weights, const double (*offsets)[2], int count);

#endif
