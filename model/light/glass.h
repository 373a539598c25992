/* glass.h - transmittance and reflectance of a glazing by angle of incidence.
 *
 * Clear glass is a stack of equal plane panes, with Fresnel reflection at each surface
 * and absorption in the pane, calculated for each polarisation [TS93]:
 *
 *     tau = (1 - rho)^2 a / (1 - rho^2 a^2),  R = rho (1 + a tau)
 *     a = exp(-KL / cos r),  sin i = n sin r
 *     a pane behind a stack: T = T1 T2 / (1 - R1 R2),  R = R1 + T1^2 R2 / (1 - R1 R2)
 *
 * If only the normal transmittance t of a glazing is known, the transmittance of such a
 * stack is multiplied by t/tau(0). A diffusing glazing is Lambertian and has only a
 * hemispherical transmittance.
 */
#ifndef PP_MODEL_LIGHT_GLASS_H
#define PP_MODEL_LIGHT_GLASS_H

#include <stdbool.h>

struct pp_glass {
    int panes;      /* 0: an unglazed opening */
    double n;       /* refractive index of a pane */
    double kl;      /* absorption coefficient times thickness of a pane */
    double scale;   /* factor on the transmittance of the stack */
    bool diffusing; /* Lambertian; then normal and diffuse are equal */
    double normal;  /* transmittance at normal incidence */
    double diffuse; /* transmittance for uniformly diffuse light */
};

/* The BRS clear single pane: n = 1.52, KL = 0.02; normal 0.900, diffuse 0.827. */
struct pp_glass pp_glass_clear_single(void);

struct pp_glass pp_glass_none(void);

bool pp_glass_is_same(const struct pp_glass *a, const struct pp_glass *b);

/* Clear glazing of equal panes: panes > 0, n > 1, kl >= 0. */
struct pp_glass pp_glass_panes(int panes, double n, double kl);

/* The glazing scaled to the normal transmittance `normal`, in (0, 1]; not for diffusing
 * glazings. */
struct pp_glass pp_glass_scaled(struct pp_glass glass, double normal);

/* As pp_glass_panes, scaled to the normal transmittance `normal`, in (0, 1]. */
struct pp_glass pp_glass_of_normal(int panes, double n, double kl, double normal);

/* One clear pane of refractive index 1.52 with the absorption that gives this normal
 * transmittance: glass tinted in its mass, and Radiance's `glass`. normal: above 0, at
 * most PP_GLASS_ABSORBING_MOST, the transmittance of a pane without absorption. */
#define PP_GLASS_ABSORBING_MOST 0.918
struct pp_glass pp_glass_absorbing(double normal);

/* Diffusing glazing; hemispherical transmittance in (0, 1]. */
struct pp_glass pp_glass_diffusing(double transmittance);

/* Clear glass that represents a measured pane: one pane with the given normal and
 * diffuse transmittance (above 0; values above 1 count as 1). Its dependence on the
 * angle is that of clear single glass. */
struct pp_glass pp_glass_measured(double normal, double diffuse);

/* Transmittance for a cosine of the angle of incidence, 0 to 1. For a diffusing glazing
 * this is its hemispherical transmittance. */
double pp_glass_transmittance(const struct pp_glass *glass, double cos_incidence);

/* Specular reflectance, equal for both sides; at most 1 - transmittance. For a
 * diffusing glazing this is its diffuse reflectance: 0.1, or less if the glazing
 * transmits more than 0.9. */
double pp_glass_reflectance(const struct pp_glass *glass, double cos_incidence);

/* Calculates transmittance and reflectance together. */
void pp_glass_optics(const struct pp_glass *glass, double cos_incidence,
                     double *transmittance, double *reflectance);

#endif
