/* glass_curve.h - optics of a clear glazing by angle, tabulated for use millions of
 * times, faster than by glass.h. */
#ifndef PP_MODEL_LIGHT_GLASS_CURVE_H
#define PP_MODEL_LIGHT_GLASS_CURVE_H

#include "model/light/glass.h"

/* Cubics over equal steps of the cosine of incidence, 0 to 1. In the first steps, where
 * clear panes have a sharp bend, the formulae of glass.h are evaluated. */
enum { PP_GLASS_CURVE_STEPS = 256, PP_GLASS_CURVE_GRAZING = 8 };
typedef double pp_glass_cubic[4];
struct pp_glass_curve {
    struct pp_glass glass;
    pp_glass_cubic transmittance[PP_GLASS_CURVE_STEPS];
    pp_glass_cubic reflectance[PP_GLASS_CURVE_STEPS];
};

/* Makes the curve of glass that is not diffusing; errors are at most 1e-8. */
void pp_glass_curve_init(struct pp_glass_curve *curve, const struct pp_glass *glass);

/* Equal to pp_glass_transmittance and pp_glass_reflectance within 1e-8, for a cosine of
 * 0 to 1. */
double pp_glass_curve_transmittance(const struct pp_glass_curve *curve, double cosine);
double pp_glass_curve_reflectance(const struct pp_glass_curve *curve, double cosine);

#endif
