/* axial_table.h - the light of a polygon with a luminance that is a function of the
 * angle to one axis, times a polynomial in direction. Examples: glass under graded
 * skies, a gradation about the zenith, the circumsolar part of a clear sky.
 *
 *     f(u) = F(a.u) [ p + q.u + (n.u)(g.u) ]                                        (1)
 *
 * With c = a.u, s^2 = 1 - c^2, N = n.u - c n.a, and Q and G likewise for q and g, the
 * potential of arc_sum.h about the axis a is
 *
 *     B = p k1 + (q.a) kc + Q ks
 *         + (n.a)(g.a) kcc + [(n.a) G + (g.a) N] kcs + N G kss                      (2)
 *     kij = 1/s^(j+2) integral from c to 1 of F(c') c'^i s'^j dc'
 *
 * The six functions k depend on c alone and are smooth at c = 1. These functions are
 * tabulated as piecewise polynomials of degree 5 in rho = sqrt(1 - c). One table serves
 * all receivers, windows and planes.
 */
#ifndef PP_METHODS_FAST_AXIAL_TABLE_H
#define PP_METHODS_FAST_AXIAL_TABLE_H

#include "methods/fast/arc_sum.h"

enum { PP_AXIAL_CELLS = 64, PP_AXIAL_POWERS = 6, PP_AXIAL_MOMENTS = 6 };

struct pp_axial_table {
    double border;       /* border between coarse and fine cells, in rho */
    double coarse, fine; /* cells per unit of rho */
    int coarse_cells;
    double balance[3]; /* constants of (3), set by pp_axial_table_init_balanced; else
                        * 0 */
    double cells[PP_AXIAL_CELLS][PP_AXIAL_POWERS][PP_AXIAL_MOMENTS];
};

/* F at c = a.u. */
typedef double pp_axial_function(const void *context, double c);

/* Fills a table for c from 0 to 1. */
void pp_axial_table_init(struct pp_axial_table *table, pp_axial_function *function,
                         const void *context);

/* Fills a table for all directions, c from -1 to 1. A constant is subtracted from each
 * of F, F c and F s / s, so that their integrals over a whole meridian are 0 and the
 * potential is also regular opposite to the axis: k1, kc and ks are then those of
 *
 *     F(c) p - balance[0] p + (q.a) (F(c) c - balance[1]) + Q (F(c) - balance[2])   (3)
 *
 * The other three functions are not balanced: the table is for lights that are not
 * quadratic. */
void pp_axial_table_init_balanced(struct pp_axial_table *table,
                                  pp_axial_function *function, const void *context);

/* The terms of (1) other than F. */
struct pp_axial_light {
    const struct pp_axial_table *table;
    struct pp_vec3 axis;
    double constant;       /* p of (1) */
    struct pp_vec3 linear; /* q of (1) */
    bool quadratic;        /* true if n and g are given */
    struct pp_vec3 n, g;
};

/* The potential (2) about the light's axis, for pp_arc_sum. */
double pp_axial_table_potential(const void *light, const struct pp_arc_nodes *nodes);

/* Light from the part of a ring within the half-spaces, by a table of
 * pp_axial_table_init. longest: longest arc for one rule. width: F changes fast where
 * |a.u| is below this value. */
double pp_axial_table_sum(const struct pp_axial_light *light, double longest,
                          double width, const struct pp_vec3 *vertices, int count,
                          const struct pp_vec3 *half_spaces, int half_space_count);

#endif
