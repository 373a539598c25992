/* glass_curve.c - interpolates at Chebyshev nodes of each step. */
#include "model/light/glass_curve.h"

#include <math.h>

#include "model/geometry/polynomial.h"
#include "model/geometry/vec.h"

enum { POINTS = 4 };

/* Weighted sum of cubics. */
static void add_up(double *sum, const pp_glass_cubic cubics[POINTS],
                   const double values[POINTS])
{
    for (int k = 0; k < POINTS; k++)
        sum[k] = cubics[0][k] * values[0];
    for (int i = 1; i < POINTS; i++)
        for (int k = 0; k < POINTS; k++)
            sum[k] += cubics[i][k] * values[i];
}

void pp_glass_curve_init(struct pp_glass_curve *curve, const struct pp_glass *glass)
{
    curve->glass = *glass;
    double at[POINTS], through[POINTS], back[POINTS];
    pp_glass_cubic one_at[POINTS]; /* Lagrange basis: 1 at node i, 0 at the others */
    for (int i = 0; i < POINTS; i++)
        at[i] = 0.5 - 0.5 * cos((2 * i + 1) * PP_PI / (2.0 * POINTS));
    for (int i = 0; i < POINTS; i++) {
        double values[POINTS] = {0.0};
        values[i] = 1.0;
        pp_polynomial_through(one_at[i], at, values, POINTS);
    }
    for (int step = 0; step < PP_GLASS_CURVE_STEPS; step++) {
        for (int i = 0; i < POINTS; i++) {
            double cosine = (step + at[i]) / PP_GLASS_CURVE_STEPS;
            pp_glass_optics(glass, cosine, &through[i], &back[i]);
        }
        add_up(curve->transmittance[step], one_at, through);
        add_up(curve->reflectance[step], one_at, back);
    }
}

/* True near grazing incidence, where the formulae of glass.h are evaluated directly. */
static bool is_grazing(double cosine)
{
    return !(cosine * PP_GLASS_CURVE_STEPS >= PP_GLASS_CURVE_GRAZING);
}

static double read_cubic(const pp_glass_cubic cubics[PP_GLASS_CURVE_STEPS],
                         double cosine)
{
    double place = cosine * PP_GLASS_CURVE_STEPS;
    int step = place < PP_GLASS_CURVE_STEPS ? (int)place : PP_GLASS_CURVE_STEPS - 1;
    const double *c = cubics[step];
    double t = place - step;
    return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}

double pp_glass_curve_transmittance(const struct pp_glass_curve *curve, double cosine)
{
    return is_grazing(cosine) ? pp_glass_transmittance(&curve->glass, cosine)
                              : read_cubic(curve->transmittance, cosine);
}

double pp_glass_curve_reflectance(const struct pp_glass_curve *curve, double cosine)
{
    return is_grazing(cosine) ? pp_glass_reflectance(&curve->glass, cosine)
                              : read_cubic(curve->reflectance, cosine);
}
