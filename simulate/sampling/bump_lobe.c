/* bump_lobe.c - see bump_lobe.h. */
#include "simulate/sampling/bump_lobe.h"

#include <math.h>
#include <stddef.h>

#include "model/light/rough/bump_facets.h"
#include "simulate/sampling/lobe.h"

/* The facets, and the shares of them that the eye sees. */
struct seen_facets {
    struct pp_bump_facets facets;
    double shares[PP_BUMP_KINDS];
};

static struct seen_facets facets_of(const struct pp_bump_lobe *lobe)
{
    struct seen_facets seen = {pp_bump_facets_of(lobe->normal, lobe->slope), {0.0}};
    pp_bump_facets_shares(&seen.facets, lobe->eye, seen.shares);
    return seen;
}

/* Value of one channel: the albedo, or the BRDF towards o if o is given. */
static double channel(const struct seen_facets *seen, double reflectance,
                      const struct pp_vec3 *o)
{
    double light[PP_BUMP_KINDS];
    pp_bump_facets_light(&seen->facets, reflectance, seen->shares, light);
    return o ? pp_bump_facets_brdf(&seen->facets, light, *o)
             : pp_bump_facets_albedo(&seen->facets, light);
}

static struct pp_rgb channels(const struct seen_facets *seen, struct pp_rgb facet,
                              const struct pp_vec3 *o)
{
    return pp_rgb(channel(seen, facet.r, o), channel(seen, facet.g, o),
                  channel(seen, facet.b, o));
}

struct pp_rgb pp_bump_lobe_albedo(const struct pp_bump_lobe *lobe)
{
    struct seen_facets seen = facets_of(lobe);
    return channels(&seen, lobe->facet, NULL);
}

struct pp_rgb pp_bump_lobe_brdf(const struct pp_bump_lobe *lobe, struct pp_vec3 o)
{
    struct seen_facets seen = facets_of(lobe);
    return channels(&seen, lobe->facet, &o);
}

/* Probability that a direction is drawn about a tilted facet. */
static double tilted_probability(const struct seen_facets *seen, struct pp_rgb facet)
{
    double light[PP_BUMP_KINDS];
    pp_bump_facets_light(&seen->facets, pp_rgb_luminance(facet), seen->shares, light);
    double sum = light[PP_BUMP_TILTED] + light[PP_BUMP_STEP];
    return sum > 0.0 ? light[PP_BUMP_TILTED] / sum : 1.0;
}

static double density(const struct seen_facets *seen, double tilted, struct pp_vec3 o)
{
    const struct pp_vec3 *normal = seen->facets.normal;
    return (tilted * fmax(pp_vec_dot(normal[PP_BUMP_TILTED], o), 0.0)
            + (1.0 - tilted) * fmax(pp_vec_dot(normal[PP_BUMP_STEP], o), 0.0))
           / PP_PI;
}

double pp_bump_lobe_pdf(const struct pp_bump_lobe *lobe, struct pp_vec3 o)
{
    struct seen_facets seen = facets_of(lobe);
    return density(&seen, tilted_probability(&seen, lobe->facet), o);
}

bool pp_bump_lobe_sample(const struct pp_bump_lobe *lobe, double u, double v,
                         struct pp_vec3 *o, struct pp_rgb *light)
{
    struct seen_facets seen = facets_of(lobe);
    double tilted = tilted_probability(&seen, lobe->facet);
    bool is_tilted = u < tilted;
    double within = is_tilted ? u / tilted : (u - tilted) / (1.0 - tilted);
    struct pp_vec3 a, b,
        about = seen.facets.normal[is_tilted ? PP_BUMP_TILTED : PP_BUMP_STEP];
    pp_lobe_frame(about, &a, &b);
    *o = pp_lobe_sample_in_frame(a, b, about, within, v);
    double cosine = pp_vec_dot(lobe->normal, *o), of = density(&seen, tilted, *o);
    if (!(cosine > 0.0 && of > 0.0))
        return false;
    *light = pp_rgb_scale(channels(&seen, lobe->facet, o), cosine / of);
    return true;
}
