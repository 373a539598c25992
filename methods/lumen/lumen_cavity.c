/* lumen_cavity.c - the exitances of three zones that reflect one another's
 * light, solved in closed form. */
#include "methods/lumen/lumen_cavity.h"

#include "methods/lumen/rectangle_factor.h"

/* Form factor from one end of a box to the other. */
static double end_to_end(double width, double length, double depth)
{
    const struct pp_aligned_rectangle top = {2, {0, 0, depth}, {width, length, depth}};
    const struct pp_aligned_rectangle bottom = {2, {0, 0, 0}, {width, length, 0}};
    return pp_rectangle_factor_exchange_area(&top, &bottom) / (width * length);
}

double pp_lumen_cavity(double rcr, double ceiling, double walls, double plane)
{
    if (!(rcr > 0.0))
        return 1.0 / (1.0 - ceiling * plane);
    /* A box with a square plan of side 10/RCR and height 1: the area of its walls is
     * 0.4 RCR times that of its plan. */
    double f = end_to_end(10.0 / rcr, 10.0 / rcr, 1.0);
    double from_walls = (1.0 - f) / (0.4 * rcr); /* form factor to either level */
    double among_walls = 1.0 - 2.0 * from_walls;

    /* Exitances C, P and W of ceiling, plane and walls, if the openings emit 1:
     *
     *     C = 1 + ceiling (f P + (1 - f) W),  P = plane (f C + (1 - f) W)
     *     W = walls (from_walls (C + P) + among_walls W)
     *
     * From the first two equations, C = c0 + c1 W and P = p0 + p1 W. */
    double c0 = 1.0 / (1.0 - ceiling * plane * f * f);
    double c1 = ceiling * (1.0 - f) * (1.0 + plane * f) * c0;
    double p0 = plane * f * c0;
    double p1 = plane * (f * c1 + 1.0 - f);
    double W = walls * from_walls * (c0 + p0)
               / (1.0 - walls * (among_walls + from_walls * (c1 + p1)));
    return f * (c0 + c1 * W) + (1.0 - f) * W;
}
