/* variant_glass.c - see variant_glass.h. */
#include "studies/research/compare/variant_glass.h"

#include <math.h>

/* Transmittance at normal incidence of a pane of transmissivity t, the fraction
 * transmitted in one passage through the glass. Each face reflects rho, for a
 * refractive index of 1.52: (1 - rho)^2 t / (1 - rho^2 t^2) [WS98]. */
static double of_transmissivity(double t)
{
    double rho = (1.52 - 1.0) / (1.52 + 1.0);
    rho *= rho;
    return (1.0 - rho) * (1.0 - rho) * t / (1.0 - rho * rho * t * t);
}

/* Glass with its normal transmittance at every angle: a film without refraction or
 * absorption (n = 1, KL = 0), scaled. */
static struct pp_glass by_normal_alone(struct pp_glass glass)
{
    return pp_glass_of_normal(1, 1.0 + 1e-9, 0.0, glass.normal);
}

/* One pane of several. If only the transmittance of the whole glazing was given, all
 * panes get the same factor; the product of these factors is glass.scale. */
static struct pp_glass one_of(struct pp_glass glass)
{
    struct pp_glass pane = pp_glass_panes(1, glass.n, glass.kl);
    return pp_glass_scaled(pane, pane.normal * pow(glass.scale, 1.0 / glass.panes));
}

struct pp_glass pp_variant_glass(struct pp_glass glass,
                                 const struct pp_room_variant *variant)
{
    if (glass.panes == 0 || variant->glass == PP_ROOM_VARIANT_GLASS_NONE)
        return pp_glass_none();
    if (glass.diffusing)
        return glass;
    if (variant->one_pane && glass.panes > 1)
        glass = one_of(glass);
    if (variant->glass == PP_ROOM_VARIANT_GLASS_TRANSMISSIVITY)
        glass = pp_glass_scaled(glass, of_transmissivity(glass.normal));
    return variant->glass == PP_ROOM_VARIANT_GLASS_NORMAL ? by_normal_alone(glass)
                                                          : glass;
}
