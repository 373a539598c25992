/* glass.c - see glass.h. */
#include "model/light/glass.h"

#include <cubature.h>
#include <math.h>
#include <stddef.h>

/* Transmittance and reflectance of a pane or a stack of panes. */
struct pane_optics {
    double t, r;
};

static struct pane_optics one_pane(double rho, double a)
{
    double t = (1.0 - rho) * (1.0 - rho) * a / (1.0 - rho * rho * a * a);
    return (struct pane_optics){t, rho * (1.0 + a * t)};
}

static struct pane_optics stack_of(struct pane_optics pane, int panes)
{
    struct pane_optics stack = pane;
    for (int i = 1; i < panes; i++) {
        double between = 1.0 / (1.0 - stack.r * pane.r);
        stack = (struct pane_optics){stack.t * pane.t * between,
                                     stack.r + stack.t * stack.t * pane.r * between};
    }
    return stack;
}

static struct pane_optics clear_stack(const struct pp_glass *glass, double cos_i)
{
    double cos_r = sqrt(1.0 - (1.0 - cos_i * cos_i) / (glass->n * glass->n));
    double s = (cos_i - glass->n * cos_r) / (cos_i + glass->n * cos_r);
    double p = (glass->n * cos_i - cos_r) / (glass->n * cos_i + cos_r);
    double a = exp(-glass->kl / cos_r);
    struct pane_optics across = stack_of(one_pane(s * s, a), glass->panes);
    struct pane_optics along = stack_of(one_pane(p * p, a), glass->panes);
    return (struct pane_optics){(across.t + along.t) / 2.0, (across.r + along.r) / 2.0};
}

double pp_glass_transmittance(const struct pp_glass *glass, double cos_incidence)
{
    if (glass->panes == 0)
        return 1.0;
    if (glass->diffusing)
        return glass->diffuse;
    if (!(cos_incidence > 0.0))
        return 0.0;
    return glass->scale * clear_stack(glass, fmin(cos_incidence, 1.0)).t;
}

double pp_glass_reflectance(const struct pp_glass *glass, double cos_incidence)
{
    if (glass->panes == 0)
        return 0.0;
    if (glass->diffusing)
        return fmin(0.1, 1.0 - glass->diffuse);
    if (!(cos_incidence > 0.0))
        return 1.0; /* grazing: the limit, which the formula has as 0/0 */
    struct pane_optics stack = clear_stack(glass, fmin(cos_incidence, 1.0));
    /* A glazing clearer than its stack can't reflect all that the stack does. */
    return fmin(stack.r, 1.0 - glass->scale * stack.t);
}

/* tau(cos i) 2 cos i, whose integral over cos i is the diffuse transmittance. */
static int diffuse_integrand(unsigned dim, const double *cos_i, void *glass,
                             unsigned fdim, double *value)
{
    (void)dim, (void)fdim;
    *value = 2.0 * cos_i[0] * pp_glass_transmittance(glass, cos_i[0]);
    return 0;
}

struct pp_glass pp_glass_panes(int panes, double n, double kl)
{
    struct pp_glass glass = {.panes = panes, .n = n, .kl = kl, .scale = 1.0};
    double low = 0.0, high = 1.0, error;
    glass.normal = pp_glass_transmittance(&glass, 1.0);
    hcubature(1, diffuse_integrand, &glass, 1, &low, &high, 20000, 0.0, 1e-12,
              ERROR_INDIVIDUAL, &glass.diffuse, &error);
    return glass;
}

struct pp_glass pp_glass_scaled(struct pp_glass glass, double normal)
{
    double more = normal / glass.normal;
    glass.scale *= more;
    glass.diffuse *= more;
    glass.normal = normal;
    return glass;
}

struct pp_glass pp_glass_of_normal(int panes, double n, double kl, double normal)
{
    return pp_glass_scaled(pp_glass_panes(panes, n, kl), normal);
}

/* pp_glass_panes(1, 1.52, 0.02), worked out once: the integral takes 10 us, and a room of
 * a thousand windows asks for this pane a million times. */
struct pp_glass pp_glass_clear_single(void)
{
    return (struct pp_glass){.panes = 1,
                             .n = 1.52,
                             .kl = 0.02,
                             .scale = 1.0,
                             .normal = 0.90007000970470386,
                             .diffuse = 0.82689646806301942};
}

struct pp_glass pp_glass_none(void)
{
    return (struct pp_glass){.scale = 1.0, .normal = 1.0, .diffuse = 1.0};
}

struct pp_glass pp_glass_diffusing(double transmittance)
{
    return (struct pp_glass){.panes = 1,
                             .n = 1.52,
                             .scale = 1.0,
                             .diffusing = true,
                             .normal = transmittance,
                             .diffuse = transmittance};
}
