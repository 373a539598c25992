/* cache_derivatives.h - derivatives of irradiance with the position and the normal of a
 * surface.
 *
 * The cells of the hemisphere are treated as patches of constant radiance at the ends
 * of their rays. The normal of the surface is n. With r from the place to points of a
 * patch's outline, counter-clockwise seen from above the surface, a patch of radiance L
 * causes the irradiance L S:
 *
 *     S = sum over edges of 1/2 n . (r0 x e) I1,   I1 = int_0^1 dt / |r0 + t e|^2   (1)
 *
 * (Lambert's formula, e = r1 - r0). Two cells share an edge, which therefore counts by
 * the difference of their radiances. The edge lies on the nearer of the two surfaces,
 * which hides the other one. When the place moves by d, r0 becomes r0 - d, and (1) can
 * be differentiated under the integral [SWJ12]:
 *
 *     grad S = 1/2 (A g - w I1)                                                    (2)
 *     hess S = 1/2 (A H - w g^T - g w^T)                                           (3)
 *
 *     A = n . (r0 x e),  w = e x n,  g = 2 int r/|r|^4,
 *     H = int (8 r r^T/|r|^6 - 2/|r|^4).
 *
 * A cell's radiance L_k affects the gradient through the edges of the cell, with
 * dgrad/dL_k = p_k. It affects the irradiance with dE/dL_k = pi/n, where n is the
 * number of cells. If the noise of the cells is independent, the noise of the gradient
 * divided by the noise of the irradiance is
 *
 *     sqrt(n sum p_k^2/2)/pi                                                       (4)
 *
 * and likewise for second derivatives.
 *
 * Along the horizon, an edge contributes half the difference of the azimuths of its
 * ends. When the normal turns, the irradiance changes by the integral of L times the
 * tangential part of the direction [WH92].
 */
#ifndef PP_SIMULATE_CACHE_CACHE_DERIVATIVES_H
#define PP_SIMULATE_CACHE_CACHE_DERIVATIVES_H

#include "simulate/cache/cache_hemisphere.h"

/* Derivatives in the frame (a, b, normal) of the hemisphere. */
struct pp_irradiance_change {
    double along[3][2];  /* red, green, blue: gradient with respect to position, 1/m */
    double turned[3][2]; /* gradient with respect to the direction of the normal,
                          * 1/rad */
    double curvature[3]; /* second derivatives aa, ab, bb of the luminance, 1/m2 */
    /* Noise relative to the noise of the irradiance, if the noise of cells is
     * independent: of the gradient along either axis (1/m), and of the curvature
     * (1/m2). */
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
