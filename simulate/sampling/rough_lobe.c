/* rough_lobe.c - see rough_lobe.h. */
#include "simulate/sampling/rough_lobe.h"

#include <math.h>

/* The table of radii for one direction of the eye. */
struct rough_radii {
    const struct pp_rough_surface *surface;
    const double *low, *high; /* cumulative probabilities at two angles of incidence */
    double next;              /* weight of the second angle */
    double sine, cosine;      /* |i_xy|; cosine of the eye's direction */
};

static struct rough_radii radii_of(const struct pp_rough_surface *surface,
                                   struct pp_vec3 eye)
{
    struct rough_radii radii = {.surface = surface, .cosine = eye.z};
    int cell = pp_rough_surface_cell(eye.z, &radii.next);
    radii.low = surface->share[cell];
    radii.high = surface->share[cell + 1];
    radii.sine = sqrt(eye.x * eye.x + eye.y * eye.y);
    return radii;
}

/* Probability of a radius below that of index k. */
static double share_below(const struct rough_radii *radii, int k)
{
    return radii->low[k] + radii->next * (radii->high[k] - radii->low[k]);
}

static double radius_at(const struct rough_radii *radii, int k)
{
    return radii->surface->radius[k] * (1.0 + radii->sine);
}

/* Density per area of i_xy + r_xy, in interval k. reach: the largest azimuth (phi). */
static double density_in(const struct rough_radii *radii, int k, double reach)
{
    double low = radius_at(radii, k), high = radius_at(radii, k + 1);
    return (share_below(radii, k + 1) - share_below(radii, k))
           / ((high * high - low * low) * reach);
}

double pp_rough_lobe_sample(const struct pp_rough_surface *surface, struct pp_vec3 eye,
                            double u, double v, struct pp_vec3 *to)
{
    struct rough_radii radii = radii_of(surface, eye);
    double left = u * share_below(&radii, PP_ROUGH_RADII);
    int k = 0, end = PP_ROUGH_RADII;
    while (end - k > 1) {
        int middle = (k + end) / 2;
        if (share_below(&radii, middle) <= left)
            k = middle;
        else
            end = middle;
    }
    double below = share_below(&radii, k), own = share_below(&radii, k + 1) - below;
    if (!(own > 0.0) || !(eye.z > 0.0))
        return 0.0;
    double low = radius_at(&radii, k), high = radius_at(&radii, k + 1);
    double radius =
        sqrt(low * low + fmin((left - below) / own, 1.0) * (high * high - low * low));
    double reach = pp_rough_surface_reach(radii.sine, radius), sine, cosine;
    if (!(reach > 0.0))
        return 0.0;
    sincos(reach * (2.0 * v - 1.0), &sine, &cosine);
    /* The azimuth is measured from i_xy, or from any direction if the eye looks along
     * the normal. */
    double along = radii.sine > 0.0 ? eye.x / radii.sine : 1.0;
    double across = radii.sine > 0.0 ? eye.y / radii.sine : 0.0;
    to->x = radius * (cosine * along - sine * across) - eye.x;
    to->y = radius * (cosine * across + sine * along) - eye.y;
    double z2 = 1.0 - to->x * to->x - to->y * to->y;
    if (!(z2 > 0.0))
        return 0.0;
    to->z = sqrt(z2);
    return 1.0 / (density_in(&radii, k, reach) * to->z);
}

double pp_rough_lobe_pdf(const struct pp_rough_surface *surface, struct pp_vec3 eye,
                         struct pp_vec3 to)
{
    struct rough_radii radii = radii_of(surface, eye);
    double radius = hypot(eye.x + to.x, eye.y + to.y);
    double reach = pp_rough_surface_reach(radii.sine, radius);
    if (!(eye.z > 0.0 && to.z > 0.0 && reach > 0.0)
        || radius >= radius_at(&radii, PP_ROUGH_RADII))
        return 0.0;
    int k = 0, end = PP_ROUGH_RADII;
    while (end - k > 1) {
        int middle = (k + end) / 2;
        if (radius_at(&radii, middle) <= radius)
            k = middle;
        else
            end = middle;
    }
    return density_in(&radii, k, reach) * to.z;
}
