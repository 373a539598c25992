/* gauss.c - see gauss.h. */
#include "model/geometry/gauss.h"

#include <math.h>

#include "model/geometry/vec.h"

/* Legendre polynomial of that order and its derivative, |x| < 1. */
static double legendre(int order, double x, double *derivative)
{
    double before = 1.0, p = x;
    for (int k = 2; k <= order; k++) {
        double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
    }
    *derivative = order * (x * p - before) / (x * x - 1.0);
    return p;
}

void pp_gauss_legendre(double *nodes, double *weights, int order)
{
    for (int i = 0; i < order; i++) {
        double x = -cos(PP_PI * (i + 0.75) / (order + 0.5)), slope;
        for (int round = 0; round < 8; round++)
            x -= legendre(order, x, &slope) / slope;
        legendre(order, x, &slope);
        nodes[i] = x;
        weights[i] = 2.0 / ((1.0 - x * x) * slope * slope);
    }
}
