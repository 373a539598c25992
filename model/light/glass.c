/* glass.c - see glass.h. */
#include "model/light/glass.h"

#include <cubature.h>
#include <math.h>
#include <stddef.h>

#include "model/geometry/min_max.h"

/* Values for light polarised perpendicular and parallel to the plane of incidence, in
 * one vector so that the compiler can use vector instructions. */
typedef double polarised __attribute__((vector_size(16)));

/* Transmittance and reflectance of a pane, or of a stack of panes. */
struct pane_optics {
    polarised t, r;
};

static struct pane_optics one_pane(polarised rho, double a)
{
    polarised t = (1.0 - rho) * (1.0 - rho) * a / (1.0 - rho * rho * a * a);
    return (struct pane_optics){t, rho * (1.0 + a * t)};
}

static struct pane_optics stack_of(struct pane_optics pane, int panes)
{
    struct pane_optics stack = pane;
    for (int i = 1; i < panes; i++) {
        polarised between = 1.0 / (1.0 - stack.r * pane.r);
        stack = (struct pane_optics){stack.t * pane.t * between,
                                     stack.r + stack.t * stack.t * pane.r * between};
    }
    return stack;
}

/* Cosine of grazing incidence: below it, the reflectance of a surface rounds to 1. */
static const double GRAZING = 1e-12;

/* Calculates Fresnel reflectances, adds the panes one by one, and returns the means of
 * both polarisations. */
static void clear_stack(const struct pp_glass *glass, double cos_i, double *t,
                        double *r)
{
    double n = glass->n;
    double cos_r = sqrt(1.0 - (1.0 - cos_i * cos_i) / (n * n));
    polarised amplitude = (polarised){cos_i - n * cos_r, n * cos_i - cos_r}
                          / (polarised){cos_i + n * cos_r, n * cos_i + cos_r};
    double a = exp(-glass->kl / cos_r);
    struct pane_optics stack =
        stack_of(one_pane(amplitude * amplitude, a), glass->panes);
    *t = (stack.t[0] + stack.t[1]) / 2.0;
    *r = (stack.r[0] + stack.r[1]) / 2.0;
}

void pp_glass_optics(const struct pp_glass *glass, double cos_incidence,
                     double *transmittance, double *reflectance)
{
    if (glass->panes == 0) {
        *transmittance = 1.0;
        *reflectance = 0.0;
    } else if (glass->diffusing) {
        *transmittance = glass->diffuse;
        *reflectance = fmin(0.1, 1.0 - glass->diffuse);
    } else if (!(cos_incidence > GRAZING)) {
        *transmittance = 0.0;
        *reflectance = 1.0; /* limit at grazing incidence, where the formula is 0/0 */
    } else {
        double t, r;
        clear_stack(glass, pp_min(cos_incidence, 1.0), &t, &r);
        *transmittance = glass->scale * t;
        /* A scaled glazing cannot transmit and reflect more light than it receives. */
        *reflectance = pp_min(r, 1.0 - glass->scale * t);
    }
}

double pp_glass_transmittance(const struct pp_glass *glass, double cos_incidence)
{
    double transmittance, reflectance;
    pp_glass_optics(glass, cos_incidence, &transmittance, &reflectance);
    return transmittance;
}

double pp_glass_reflectance(const struct pp_glass *glass, double cos_incidence)
{
    double transmittance, reflectance;
    pp_glass_optics(glass, cos_incidence, &transmittance, &reflectance);
    return reflectance;
}

/* Integrand tau(cos i) 2 cos i; its integral over cos i is the diffuse
 * transmittance. */
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

struct pp_glass pp_glass_absorbing(double normal)
{
    /* tau = (1 - rho)^2 a/(1 - rho^2 a^2), solved for a. */
    static const double n = 1.52;
    double rho = (n - 1.0) * (n - 1.0) / ((n + 1.0) * (n + 1.0));
    double passed = (1.0 - rho) * (1.0 - rho), back = rho * normal;
    double a = 2.0 * normal / (passed + sqrt(passed * passed + 4.0 * back * back));
    return pp_glass_panes(1, n, fmax(0.0, -log(a)));
}

struct pp_glass pp_glass_of_normal(int panes, double n, double kl, double normal)
{
    return pp_glass_scaled(pp_glass_panes(panes, n, kl), normal);
}

/* Returns the stored result of pp_glass_panes(1, 1.52, 0.02), whose integral would take
 * too long in a room with many windows and points. */
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

bool pp_glass_is_same(const struct pp_glass *a, const struct pp_glass *b)
{
    return a->panes == b->panes && a->n == b->n && a->kl == b->kl
           && a->scale == b->scale && a->diffusing == b->diffusing
           && a->normal == b->normal && a->diffuse == b->diffuse;
}

struct pp_glass pp_glass_measured(double normal, double diffuse)
{
    struct pp_glass glass =
        pp_glass_scaled(pp_glass_clear_single(), normal < 1.0 ? normal : 1.0);
    glass.diffuse = diffuse < 1.0 ? diffuse : 1.0;
    return glass;
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
