/* cache_derivatives.h - derivatives of irradiance with the position and the normal of a
 * surface.
 *
 * The cells of the hemisphere are treated as patches of constant radiance at the ends
 * of their rays. With r from the place to points of a patch's outline, ccw seen from
 * above the surface with normal n, its irradiance is L times
 *
 *     S = sum over edges of 1/2 n . (r0 x e) I1,   I1 = int_0^1 dt / |r0 + t e|^2   (1)
 *
 * (Lambert's formula, e = r1 - r0). An edge is shared by two cells and so counts by the
 * difference of their radiances; it lies on the nearer of the two surfaces, which is
 * the one that hides the other. When the place moves by d, r0 becomes r0 - d, and (1)
 * can be differentiated under the integral [SWJ12]:
 *
 *     grad S = 1/2 (A g - w I1)                                                    (2)
 *     hess S = 1/2 (A H - w g^T - g w^T)                                           (3)
 *
 *     A = n . (r0 x e),  w = e x n,  g = 2 int r/|r|^4,
 *     H = int (8 r r^T/|r|^6 - 2/|r|^4).
 *
 * A cell's radiance L_k enters the gradient by its edges, with dgrad/dL_k = p_k, and
 * the irradiance with dE/dL_k = pi/n where there are n cells. So noise that is
 * independent from cell to cell is, in the gradient over that in the irradiance,
 *
 *     sqrt(n sum p_k^2/2)/pi                                                       (4)
 *
 * and likewise for second derivatives.
 *
 * Along the horizon an edge counts by the azimuths of its ends. When the normal turns,
 * the irradiance changes by the sum of L times the tangential part of its direction
 * [WH92].
 */
#ifndef PP_SIMULATE_CACHE_CACHE_DERIVATIVES_H
#define PP_SIMULATE_CACHE_CACHE_DERIVATIVES_H

#include "simulate/cache/cache_hemisphere.h"

/* Derivatives in the frame (a, b, normal) of the hemisphere. */
struct pp_irradiance_change {
    double along[3][2];  /* red, green, blue: gradient with the position, 1/m */
    double turned[3][2]; /* gradient with the direction of the normal, 1/rad */
    double curvature[3]; /* luminance's second derivatives aa, ab, bb, 1/m2 */
    /* Noise per noise of the irradiance, if the noise of cells is independent: of the
     * gradient along either axis (1/m), and of the curvature (1/m2). */
    double along_noise, curvature_noise;
};

void pp_cache_derivatives_hemisphere(struct pp_cache_hemisphere *hemisphere,
                                     struct pp_irradiance_change *change);

/* Terms (1) to (3) of one edge from r0 to r1 (relative to the place), in the frame
 * whose z is n: the gradient and aa, ab, bb of the Hessian. Both are 0 for an edge
 * collinear with the place. */
void pp_cache_derivatives_edge(struct pp_vec3 r0, struct pp_vec3 r1, double gradient[2],
                               double hessian[3]);

#endif
