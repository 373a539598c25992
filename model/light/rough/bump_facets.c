/* bump_facets.c - see bump_facets.h. */
#include "model/light/rough/bump_facets.h"

#include <math.h>

/* Sets areas and leaving light for the tangent of A. In section a tilted facet, a step
 * and the opening to the sky are a triangle with the sides 1/cos A, tan A and 1. The
 * light that two sides of a triangle exchange, if both have a radiance of 1/pi, is half
 * of their sum minus the third side. */
static void set_areas(struct pp_bump_facets *facets, double tangent)
{
    double secant = sqrt(1.0 + tangent * tangent);
    double exchanged = (secant + tangent - 1.0) / 2.0;
    facets->area[PP_BUMP_TILTED] = secant;
    facets->area[PP_BUMP_STEP] = tangent;
    for (int i = 0; i < PP_BUMP_KINDS; i++)
        facets->leaving[i] = 1.0 - exchanged / facets->area[i];
}

struct pp_bump_facets pp_bump_facets_of(struct pp_vec3 normal, struct pp_vec3 slope)
{
    double tangent = pp_vec_length(slope);
    struct pp_bump_facets facets = {
        .surface = normal,
        .normal = {[PP_BUMP_TILTED] = pp_vec_unit(pp_vec_sub(normal, slope)),
                   [PP_BUMP_STEP] = pp_vec_scale(slope, 1.0 / tangent)}};
    set_areas(&facets, tangent);
    return facets;
}

void pp_bump_facets_shares(const struct pp_bump_facets *facets, struct pp_vec3 o,
                           double shares[PP_BUMP_KINDS])
{
    double sum = 0.0;
    for (int i = 0; i < PP_BUMP_KINDS; i++) {
        shares[i] = facets->area[i] * fmax(pp_vec_dot(facets->normal[i], o), 0.0);
        sum += shares[i];
    }
    bool above = pp_vec_dot(facets->surface, o) > 0.0 && sum > 0.0;
    for (int i = 0; i < PP_BUMP_KINDS; i++)
        shares[i] = above ? shares[i] / sum : 0.0;
}

void pp_bump_facets_light(const struct pp_bump_facets *facets, double reflectance,
                          const double shares[PP_BUMP_KINDS],
                          double light[PP_BUMP_KINDS])
{
    /* light_p = r (shares_p + from_t light_t), light_t = r (shares_t + from_p light_p) */
    double r = reflectance;
    double from_p = 1.0 - facets->leaving[PP_BUMP_TILTED],
           from_t = 1.0 - facets->leaving[PP_BUMP_STEP];
    double p = shares[PP_BUMP_TILTED], t = shares[PP_BUMP_STEP];
    double factor = r / (1.0 - r * r * from_p * from_t);
    light[PP_BUMP_TILTED] = factor * (p + r * from_t * t);
    light[PP_BUMP_STEP] = factor * (t + r * from_p * p);
}

double pp_bump_facets_brdf(const struct pp_bump_facets *facets,
                           const double light[PP_BUMP_KINDS], struct pp_vec3 o)
{
    double shares[PP_BUMP_KINDS], sum = 0.0;
    pp_bump_facets_shares(facets, o, shares);
    for (int i = 0; i < PP_BUMP_KINDS; i++)
        sum += shares[i] * light[i] / facets->area[i];
    return sum / PP_PI;
}

double pp_bump_facets_albedo(const struct pp_bump_facets *facets,
                             const double light[PP_BUMP_KINDS])
{
    double sum = 0.0;
    for (int i = 0; i < PP_BUMP_KINDS; i++)
        sum += facets->leaving[i] * light[i];
    return sum;
}

double pp_bump_facets_reflectance(double slope, double reflectance)
{
    if (!(slope > 0.0))
        return reflectance;
    struct pp_bump_facets facets = {.area = {0.0}};
    double shares[PP_BUMP_KINDS], light[PP_BUMP_KINDS];
    set_areas(&facets, slope);
    /* A facet receives from the sky in proportion to the light that it sends there. */
    for (int i = 0; i < PP_BUMP_KINDS; i++)
        shares[i] = facets.area[i] * facets.leaving[i];
    pp_bump_facets_light(&facets, reflectance, shares, light);
    return pp_bump_facets_albedo(&facets, light);
}
