/* quadrature.h - illuminance of a receiver from a part of a view, for any luminance L:
 *
 *     integral over the part of L(u) (n.u) domega
 *
 * The part is divided into cells, each bounded by two edges of the part and two lines
 * across. The variables over a cell are the azimuth alpha and the sine s of the
 * altitude about the view's `up`. Solid angle is uniform in these variables (domega =
 * dalpha ds), however close the eye is to the plane. The integral over s is nested in
 * the integral over alpha. Both use adaptive Gauss-Kronrod rules (hcubature in one
 * dimension), or short Gauss-Legendre rules in small cells where two such rules agree;
 * rough results use fixed Gauss-Legendre rules, and luminances with grain midpoint
 * sums.
 */
#ifndef PP_METHODS_EXACT_QUADRATURE_H
#define PP_METHODS_EXACT_QUADRATURE_H

#include "model/geometry/projection.h"
#include "model/base/error.h"
#include "model/geometry/region.h"

/* Relative error bounds of `exact` without a table (pane_light.h), with glass and
 * without. The actual errors are far smaller. */
#define PP_QUADRATURE_GLAZED 1e-5
#define PP_QUADRATURE_UNGLAZED 1e-9

/* Relative error bound for the light on a diffusing pane from a sky without a closed
 * form, which is evaluated at many points. The actual errors are about 1e-7. */
#define PP_QUADRATURE_PANE 5e-4

/* Error bound at or above which fixed Gauss-Legendre rules replace the adaptive ones.
 * Fixed rules are much faster and give no error estimate. Their errors
 * are largest within a few centimetres of the pane. */
#define PP_QUADRATURE_ROUGH 1e-3

/* A luminance with grain is summed in steps of its grain, or in steps this many times
 * larger if the error bound is PP_QUADRATURE_ROUGH or more. */
#define PP_QUADRATURE_GRAINS_ROUGH 3.0

/* Luminance towards the eye from direction u (unit, room's axes). */
typedef double pp_luminance_function(const void *context, struct pp_vec3 u);

struct pp_integrand {
    pp_luminance_function *luminance;
    const void *context;
    const struct pp_vec3
        *cusp;        /* a direction where the luminance is not smooth, or NULL */
    double grain_rad; /* angle of a pixel of a photographed sky (rad); 0: the luminance
                       * is smooth */
};

struct pp_quadrature {
    double value;
    double error; /* estimated bound of the absolute error; 0 for fixed rules */
    long evaluations;
};

/* The integral over the part of `region` (in the view's coordinates) within the
 * half-spaces (in the room's axes). normal must be one of the half-spaces, so that n.u
 * is not negative. */
enum pp_status pp_quadrature_over(struct pp_quadrature *result,
                                  const struct pp_projection *view,
                                  const struct pp_region *region,
                                  const struct pp_vec3 *half_spaces,
                                  int half_space_count, struct pp_vec3 normal,
                                  const struct pp_integrand *integrand,
                                  double relative_error, struct pp_error *err);

#endif
