/* he_torrance.h - reflectance of a rough surface by physical optics: the model of He,
 * Torrance, Sillion and Greenberg [HTSG91], for unpolarised light.
 *
 * The surface is Gaussian and isotropic: s0 is the RMS deviation of its height, T the
 * length over which heights are correlated, l the wavelength (all in micrometres), and
 * n + ik its refractive index. With unit directions i and r away from the surface,
 * their sum v, vz = ci + cr the sum of their cosines, and vxy the length of v along the
 * surface:
 *
 *     spike = F(ci) exp(-g) S1(i)^2                 in the mirror direction        (1)
 *     dd    = F(|v|/2) G S1(i) S1(r) D / (pi ci cr)                      1/sr      (2)
 *     g     = (2 pi s vz / l)^2                                                    (3)
 *     D     = (pi T / 2 l)^2 sum_{m>=1} g^m exp(-g) / (m m!) exp(-e/m),
 *             e = (pi vxy T / l)^2                                                 (4)
 *     G     = (|v|^2 / vz)^2                                                       (5)
 *     s     = s0 / sqrt(1 + x^2),  x exp(x^2/2) = (K(i) + K(r)) / sqrt(8 pi),
 *             K = tan t erfc(u)                                                    (6)
 *     S1    = (1 - erfc(u)/2) / (1 + L),  u = T cot t / (2 s0),
 *             L = (exp(-u^2) / (sqrt(pi) u) - erfc(u)) / 2                         (7)
 *
 * with t the angle from the normal and F Fresnel's reflectance, the mean of both
 * polarisations. The published L lacks exp(-u^2), which is restored here. The published
 * G contains a quotient that equals 1, but is 0/0 where the light returns to its
 * source; the quotient is left out here. The model is reciprocal. It describes only
 * light that the surface reflects once. At grazing incidence it can reflect up to 2 %
 * more than it receives; rough_surface.h corrects that.
 */
#ifndef PP_MODEL_LIGHT_ROUGH_HE_TORRANCE_H
#define PP_MODEL_LIGHT_ROUGH_HE_TORRANCE_H

#include "model/geometry/vec.h"

/* F at the cosine of the angle of incidence, from air. */
double pp_he_torrance_fresnel(double n, double k, double cosine);

/* Sum in (4), for g >= 0 and e >= 0, to 1e-12. */
double pp_he_torrance_series(double g, double e);

/* A direction over a surface of height deviation s0 and correlation length T. Below a
 * cosine of 1e-6 the values of 1e-6 are used. */
struct pp_he_torrance_direction {
    struct pp_vec3 to;        /* unit; z is the normal */
    double cosine, shadow, k; /* to.z, S1 and K */
};
struct pp_he_torrance_direction pp_he_torrance_towards(struct pp_vec3 to, double s0,
                                                       double correlation);

/* The effective roughness s, in the unit of s0. */
double pp_he_torrance_roughness(const struct pp_he_torrance_direction *i,
                                const struct pp_he_torrance_direction *r, double s0);

/* Surface at one wavelength; lengths in micrometres. */
struct pp_he_torrance {
    double n, k, wavelength;
    double roughness, correlation; /* s0 and T */
};

/* (1), and its factor exp(-g) S1^2. */
double pp_he_torrance_spike(const struct pp_he_torrance *surface,
                            const struct pp_he_torrance_direction *i);
double pp_he_torrance_spike_share(const struct pp_he_torrance *surface,
                                  const struct pp_he_torrance_direction *i);

/* (2) without the factor F; s: result of pp_he_torrance_roughness. The caller
 * multiplies by Fresnel's reflectance at the cosine *half = |v|/2. */
double pp_he_torrance_lobe(const struct pp_he_torrance *surface, double s,
                           const struct pp_he_torrance_direction *i,
                           const struct pp_he_torrance_direction *r, double *half);

/* (2), in 1/sr. */
double pp_he_torrance_diffuse(const struct pp_he_torrance *surface,
                              const struct pp_he_torrance_direction *i,
                              const struct pp_he_torrance_direction *r);

#endif
