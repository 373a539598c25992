/* gauss.h - Gauss-Legendre quadrature of any order. */
#ifndef PP_MODEL_GEOMETRY_GAUSS_H
#define PP_MODEL_GEOMETRY_GAUSS_H

enum { PP_GAUSS_MOST = 64 };

/* Finds the nodes, ascending in (-1, 1), and the weights of the rule with `order`
 * points, 1 to PP_GAUSS_MOST. The rule is exact for polynomials of degree 2 order - 1.
 * Nodes are found by Newton's iteration on the Legendre polynomial, to 1e-15. */
void pp_gauss_legendre(double *nodes, double *weights, int order);

#endif
