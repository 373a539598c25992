/* scatter.c - see scatter.h. */
#include "simulate/scatter.h"

#include <math.h>

#include "simulate/lobe.h"

static const double SMOOTH = 1e-3;

static struct pp_rgb glass_law(const struct pp_material *material, double cosine,
                               double (*law)(const struct pp_glass *, double))
{
    double value[3];
    for (int i = 0; i < 3; i++) {
        const struct pp_glass *glass = &material->glass[i],
                              *first = &material->glass[0];
        bool like = i > 0 && glass->kl == first->kl && glass->n == first->n
                    && glass->panes == first->panes && glass->scale == first->scale;
        value[i] = like ? value[0] : law(glass, cosine);
    }
    return pp_rgb(value[0], value[1], value[2]);
}

static bool is_smooth(const struct pp_material *material)
{
    return material->roughness[0] < SMOOTH || material->roughness[1] < SMOOTH;
}

struct pp_rgb pp_straight_through(const struct pp_material *material,
                                  double cos_incidence)
{
    switch (material->kind) {
    case PP_MATERIAL_AIR:
        return pp_rgb_grey(1.0);
    case PP_MATERIAL_GLASS:
        return pp_rgb_scale(glass_law(material, cos_incidence, pp_glass_transmittance),
                            material->clear_share * material->dirt);
    case PP_MATERIAL_TRANSLUCENT:
        return is_smooth(material) ? material->through_gloss : pp_rgb_grey(0.0);
    default:
        return pp_rgb_grey(0.0);
    }
}

/* The frame: along the grain's part in the surface where there is any. */
static void lay_frame(struct pp_lobes *lobes, const struct pp_material *material)
{
    struct pp_vec3 n = lobes->n, grain = material->grain;
    struct pp_vec3 in = pp_along(grain, -pp_dot(grain, n), n);
    double length = pp_length(in);
    if (!(length > 1e-6 * pp_length(grain))) {
        pp_frame_about(n, &lobes->a, &lobes->b);
        return;
    }
    lobes->a = pp_scale(in, 1.0 / length);
    lobes->b = pp_cross(n, lobes->a);
}

void pp_lobes_init(struct pp_lobes *lobes, const struct pp_material *material,
                   struct pp_vec3 n, struct pp_vec3 eye)
{
    *lobes = (struct pp_lobes){
        .n = n,
        .eye = eye,
        .roughness = {material->roughness[0], material->roughness[1]}};
    lay_frame(lobes, material);
    double cosine = fabs(pp_dot(n, eye));
    struct pp_rgb *share = lobes->share;
    share[PP_LOBE_STRAIGHT] = pp_straight_through(material, cosine);
    if (material->kind == PP_MATERIAL_AIR)
        return;
    share[PP_LOBE_DIFFUSE] = material->diffuse;
    if (material->kind == PP_MATERIAL_GLASS) {
        share[PP_LOBE_MIRROR] = pp_rgb_scale(
            glass_law(material, cosine, pp_glass_reflectance), material->clear_share);
        return;
    }
    bool smooth = is_smooth(material);
    share[smooth ? PP_LOBE_MIRROR : PP_LOBE_GLOSS] = material->gloss;
    if (material->kind == PP_MATERIAL_TRANSLUCENT) {
        share[PP_LOBE_THROUGH_DIFFUSE] = material->through_diffuse;
        if (!smooth)
            share[PP_LOBE_THROUGH_GLOSS] = material->through_gloss;
    }
}

double pp_lobes_width(const struct pp_lobes *lobes)
{
    return lobes->roughness[0] < lobes->roughness[1] ? lobes->roughness[0]
                                                     : lobes->roughness[1];
}

static struct pp_vec3 mirrored(struct pp_vec3 v, struct pp_vec3 n)
{
    return pp_along(v, -2.0 * pp_dot(v, n), n);
}

struct pp_rgb pp_lobes_gloss(const struct pp_lobes *lobes, struct pp_vec3 o)
{
    bool through = pp_dot(o, lobes->n) < 0.0;
    struct pp_rgb share = lobes->share[through ? PP_LOBE_THROUGH_GLOSS : PP_LOBE_GLOSS];
    if (pp_rgb_is_black(share))
        return share;
    if (through)
        o = mirrored(o, lobes->n);
    struct pp_vec3 h = pp_add(lobes->eye, o);
    double hn = pp_dot(h, lobes->n), ax = lobes->roughness[0], ay = lobes->roughness[1];
    if (!(hn > 0.0))
        return pp_rgb_grey(0.0);
    double x = pp_dot(h, lobes->a) / (ax * hn), y = pp_dot(h, lobes->b) / (ay * hn);
    double f =
        exp(-(x * x + y * y)) / (PP_PI * ax * ay) * pp_dot(h, h) / (hn * hn * hn * hn);
    return pp_rgb_scale(share, f);
}

/* The eye's direction mirrored in a facet of random slope. */
static bool sample_gloss(const struct pp_lobes *lobes, double u, double v,
                         struct pp_vec3 *o, double *factor)
{
    double r = sqrt(-log(u)), sine, cosine;
    sincos(2.0 * PP_PI * v, &sine, &cosine);
    struct pp_vec3 h =
        pp_unit(pp_along(pp_along(lobes->n, lobes->roughness[0] * r * cosine, lobes->a),
                         lobes->roughness[1] * r * sine, lobes->b));
    *o = pp_along(pp_scale(lobes->eye, -1.0), 2.0 * pp_dot(h, lobes->eye), h);
    double to = pp_dot(*o, lobes->n), from = pp_dot(lobes->eye, lobes->n);
    *factor = 2.0 * to / (from + to);
    return to > 0.0 && from > 0.0;
}

bool pp_lobes_sample(const struct pp_lobes *lobes, enum pp_lobe lobe, double u,
                     double v, struct pp_vec3 *o, double *factor)
{
    struct pp_vec3 n = lobes->n;
    *factor = 1.0;
    switch (lobe) {
    case PP_LOBE_DIFFUSE:
        *o = pp_sample_lobe(lobes->a, lobes->b, n, u, v);
        return true;
    case PP_LOBE_THROUGH_DIFFUSE:
        *o = mirrored(pp_sample_lobe(lobes->a, lobes->b, n, u, v), n);
        return true;
    case PP_LOBE_GLOSS:
        return sample_gloss(lobes, u, v, o, factor);
    case PP_LOBE_THROUGH_GLOSS:
        if (!sample_gloss(lobes, u, v, o, factor))
            return false;
        *o = mirrored(*o, n);
        return true;
    case PP_LOBE_MIRROR:
        *o = mirrored(pp_scale(lobes->eye, -1.0), n);
        return true;
    case PP_LOBE_STRAIGHT:
        *o = pp_scale(lobes->eye, -1.0);
        return true;
    default:
        return false;
    }
}
