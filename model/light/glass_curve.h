/* glass_curve.h - a clear glazing's law by angle, tabulated for use millions of times:
 * a fifth of the work of glass.h. */
#ifndef PP_MODEL_LIGHT_GLASS_CURVE_H
#define PP_MODEL_LIGHT_GLASS_CURVE_H

#include "model/light/glass.h"

/* Cubics over even steps of the cosine of incidence from 0 to 1. In the first steps,
 * where clear panes have a sharp bend, the law itself is evaluated. */
enum { PP_GLASS_CURVE_STEPS = 256, PP_GLASS_CURVE_GRAZING = 8 };
typedef double pp_glass_cubic[4];
struct pp_glass_curve {
    struct pp_glass glass;
    pp_glass_cubic transmittance[PP_GLASS_CURVE_STEPS];
    pp_glass_cubic reflectance[PP_GLASS_CURVE_STEPS];
};

/* Makes the curve of glass that is not diffusing. Errors are up to 1e-8. */
void pp_glass_curve_init(struct pp_glass_curve *curve, const struct pp_glass *glass);

/* Equivalents of pp_glass_transmittance and pp_glass_reflectance, at a cosine of 0 to
 * 1. */
double pp_glass_curve_transmittance(const struct pp_glass_curve *curve, double cosine);
double pp_glass_curve_reflectance(const struct pp_glass_curve *curve, double cosine);

#endif
