/* scatter.c - shares of the lobes by material and angle, and directions of each
 * lobe. */
#include "simulate/sampling/scatter.h"

#include <math.h>

#include "simulate/sampling/bump_lobe.h"
#include "simulate/sampling/lobe.h"

/* Applies a law to each channel. */
static struct pp_rgb by_channel(const struct pp_material *material, double cosine,
                                double (*law)(const struct pp_glass *, double))
{
    const struct pp_glass *glass = material->glass;
    return pp_rgb(law(&glass[0], cosine), law(&glass[1], cosine),
                  law(&glass[2], cosine));
}

static struct pp_rgb glass_transmittance(const struct pp_material *material,
                                         double cosine)
{
    return material->curve
               ? pp_rgb_grey(pp_glass_curve_transmittance(material->curve, cosine))
               : by_channel(material, cosine, pp_glass_transmittance);
}

static struct pp_rgb glass_reflectance(const struct pp_material *material,
                                       double cosine)
{
    return material->curve
               ? pp_rgb_grey(pp_glass_curve_reflectance(material->curve, cosine))
               : by_channel(material, cosine, pp_glass_reflectance);
}

struct pp_rgb pp_scatter_regular_transmittance(const struct pp_material *material,
                                               double cos_incidence)
{
    switch (material->kind) {
    case PP_MATERIAL_AIR:
        return pp_rgb_grey(1.0);
    case PP_MATERIAL_GLASS:
        return pp_rgb_scale(glass_transmittance(material, cos_incidence),
                            material->clear_share * material->dirt);
    case PP_MATERIAL_TRANSLUCENT:
        return pp_gloss_is_mirror(material->roughness[0], material->roughness[1])
                   ? material->through_gloss
                   : pp_rgb_grey(0.0);
    default:
        return pp_rgb_grey(0.0);
    }
}

static struct pp_rgb rough_colour(bool grey, struct pp_rgb value)
{
    return grey ? pp_rgb_grey(pp_rgb_luminance(value)) : value;
}

struct pp_rgb pp_scatter_specular_reflectance(const struct pp_material *material,
                                              double cos_incidence)
{
    switch (material->kind) {
    case PP_MATERIAL_AIR:
        return pp_rgb_grey(0.0);
    case PP_MATERIAL_GLASS:
        return pp_rgb_scale(glass_reflectance(material, cos_incidence),
                            material->clear_share);
    default:
        if (material->rough)
            return rough_colour(material->rough_is_grey,
                                pp_rough_surface_spike(material->rough, cos_incidence));
        return material->gloss;
    }
}

/* Sets the frame: x along the projection of the grain on the surface, if there is a
 * grain. */
static void lay_frame(struct pp_frame *frame, const struct pp_material *material)
{
    struct pp_vec3 n = frame->z, grain = material->grain;
    struct pp_vec3 in = pp_vec_along(grain, -pp_vec_dot(grain, n), n);
    double length = pp_vec_length(in);
    if (!(length > 1e-6 * pp_vec_length(grain))) {
        pp_lobe_frame(n, &frame->x, &frame->y);
        return;
    }
    frame->x = pp_vec_scale(in, 1.0 / length);
    frame->y = pp_vec_cross(n, frame->x);
}

/* ---- scattering panes ---- */

/* Converts a direction to the axes of a pane. The frame belongs to one side of the
 * pane; x of the frame and y of the pane point up. */
static struct pp_vec3 in_pane_axes(const struct pp_frame *frame, bool is_outside,
                                   struct pp_vec3 direction)
{
    struct pp_vec3 d = pp_frame_in(frame, direction);
    return is_outside ? pp_vec(d.y, d.x, -d.z) : pp_vec(-d.y, d.x, d.z);
}

/* Converts a direction from the axes of a pane. */
static struct pp_vec3 out_of_pane_axes(const struct pp_frame *frame, bool is_outside,
                                       struct pp_vec3 d)
{
    return pp_frame_out(frame,
                        is_outside ? pp_vec(d.y, d.x, -d.z) : pp_vec(d.y, -d.x, d.z));
}

struct pp_rgb pp_scatter_straight(const struct pp_material *material, struct pp_vec3 n,
                                  struct pp_vec3 eye)
{
    if (!material->scatter)
        return pp_scatter_regular_transmittance(material, pp_vec_dot(n, eye));
    struct pp_frame frame = {.z = n};
    lay_frame(&frame, material);
    struct pp_vec3 out = in_pane_axes(&frame, material->is_outside, eye);
    const struct pp_pane_scatter *scatter =
        material->scatter->for_sun ? material->scatter->for_sun : material->scatter;
    return pp_rgb_grey(scatter->straight(scatter->data, out) * material->clear_share
                       * material->dirt);
}

/* Sets the shares of the lobes of a scattering pane. */
static void init_pane(struct pp_lobes *lobes, const struct pp_material *material)
{
    const struct pp_pane_scatter *scatter = material->scatter;
    lobes->scatter = scatter;
    lobes->is_outside = material->is_outside;
    struct pp_vec3 out = in_pane_axes(&lobes->frame, lobes->is_outside, lobes->eye);
    double passing = material->clear_share * material->dirt;
    lobes->share[PP_LOBE_DIFFUSE] = material->diffuse;
    lobes->share[PP_LOBE_STRAIGHT] =
        pp_rgb_grey(scatter->straight(scatter->data, out) * passing);
    lobes->share[PP_LOBE_THROUGH_GLOSS] =
        pp_rgb_grey(scatter->arriving(scatter->data, out) * passing);
}

/* Density of light that arrives from direction o. */
static double pane_pdf(const struct pp_lobes *lobes, struct pp_vec3 o)
{
    if (!(pp_vec_dot(o, lobes->frame.z) < 0.0))
        return 0.0;
    struct pp_vec3 from = pp_vec_scale(o, -1.0);
    return lobes->scatter->density(
        lobes->scatter->data, in_pane_axes(&lobes->frame, lobes->is_outside, from),
        in_pane_axes(&lobes->frame, lobes->is_outside, lobes->eye));
}

static bool sample_pane(const struct pp_lobes *lobes, double u, double v,
                        struct pp_vec3 *o, struct pp_rgb *factor)
{
    struct pp_vec3 in;
    double weight = lobes->scatter->sample(
        lobes->scatter->data,
        in_pane_axes(&lobes->frame, lobes->is_outside, lobes->eye), u, v, &in);
    *factor = pp_rgb_grey(weight);
    if (!(weight > 0.0))
        return false;
    *o = pp_vec_scale(out_of_pane_axes(&lobes->frame, lobes->is_outside, in), -1.0);
    return true;
}

/* ---- lobes ---- */

void pp_scatter_init(struct pp_lobes *lobes, const struct pp_material *material,
                     const struct pp_gloss *gloss, struct pp_vec3 n, struct pp_vec3 eye)
{
    *lobes = (struct pp_lobes){.frame = {.z = n},
                               .eye = eye,
                               .gloss = gloss,
                               .rough = material->rough,
                               .rough_is_grey = material->rough_is_grey};
    lay_frame(&lobes->frame, material);
    if (material->scatter) {
        init_pane(lobes, material);
        return;
    }
    double cosine = fabs(pp_vec_dot(n, eye));
    struct pp_rgb *share = lobes->share;
    share[PP_LOBE_STRAIGHT] = pp_scatter_regular_transmittance(material, cosine);
    if (material->kind == PP_MATERIAL_AIR)
        return;
    share[PP_LOBE_DIFFUSE] = material->diffuse;
    share[gloss ? PP_LOBE_GLOSS : PP_LOBE_MIRROR] =
        pp_scatter_specular_reflectance(material, cosine);
    if (material->rough)
        share[PP_LOBE_GLOSS] = rough_colour(
            material->rough_is_grey, pp_rough_surface_lobe(material->rough, cosine));
    if (material->kind == PP_MATERIAL_TRANSLUCENT) {
        share[PP_LOBE_THROUGH_DIFFUSE] = material->through_diffuse;
        if (gloss)
            share[PP_LOBE_THROUGH_GLOSS] = material->through_gloss;
    }
}

static struct pp_bump_lobe bumps_of(const struct pp_lobes *lobes)
{
    return (struct pp_bump_lobe){lobes->bump_slope, lobes->bump_facet, lobes->frame.z,
                                 lobes->eye};
}

/* Tangent of the least slope; smaller slopes do not count. */
static const double LEAST_SLOPE = 1e-6;

void pp_scatter_add_bumps(struct pp_lobes *lobes, const struct pp_material *material,
                          struct pp_vec3 point)
{
    struct pp_vec3 slope =
        pp_surface_pattern_slope(material->bumps, point, lobes->frame.z, NULL);
    struct pp_rgb facet = pp_material_facet_at(material, point);
    lobes->share[PP_LOBE_DIFFUSE] = facet;
    double steepness = pp_vec_length(slope);
    if (!(steepness > LEAST_SLOPE && isfinite(steepness)))
        return;
    lobes->has_bumps = true;
    lobes->bump_slope = slope;
    lobes->bump_facet = facet;
    const struct pp_bump_lobe bumps = bumps_of(lobes);
    lobes->share[PP_LOBE_DIFFUSE] = pp_rgb_grey(0.0);
    lobes->share[PP_LOBE_GLOSS] = pp_bump_lobe_albedo(&bumps);
}

struct pp_rgb pp_scatter_gloss_brdf(const struct pp_lobes *lobes, struct pp_vec3 o)
{
    bool through = pp_vec_dot(o, lobes->frame.z) < 0.0;
    struct pp_rgb share = lobes->share[through ? PP_LOBE_THROUGH_GLOSS : PP_LOBE_GLOSS];
    if (pp_rgb_is_black(share))
        return share;
    if (lobes->has_bumps) {
        const struct pp_bump_lobe bumps = bumps_of(lobes);
        return pp_bump_lobe_brdf(&bumps, o);
    }
    if (lobes->scatter) {
        struct pp_vec3 out = in_pane_axes(&lobes->frame, lobes->is_outside, lobes->eye);
        struct pp_vec3 in =
            in_pane_axes(&lobes->frame, lobes->is_outside, pp_vec_scale(o, -1.0));
        return pp_rgb_scale(share,
                            lobes->scatter->btdf(lobes->scatter->data, in, out)
                                / lobes->scatter->arriving(lobes->scatter->data, out));
    }
    struct pp_vec3 eye = pp_frame_in(&lobes->frame, lobes->eye);
    o = pp_frame_in(&lobes->frame, o);
    o.z = fabs(o.z);
    if (lobes->rough)
        return rough_colour(lobes->rough_is_grey,
                            pp_rough_surface_value(lobes->rough, eye, o));
    return pp_rgb_scale(share, pp_gloss_value(lobes->gloss, eye, o));
}

double pp_scatter_gloss_pdf(const struct pp_lobes *lobes, struct pp_vec3 o)
{
    if (lobes->scatter)
        return pane_pdf(lobes, o);
    if (lobes->has_bumps) {
        const struct pp_bump_lobe bumps = bumps_of(lobes);
        return pp_bump_lobe_pdf(&bumps, o);
    }
    o = pp_frame_in(&lobes->frame, o);
    struct pp_vec3 eye = pp_frame_in(&lobes->frame, lobes->eye);
    if (lobes->rough)
        return pp_rough_lobe_pdf(lobes->rough, eye, o);
    o.z = fabs(o.z);
    return pp_gloss_pdf(lobes->gloss, eye, o);
}

static bool sample_gloss(const struct pp_lobes *lobes, bool through, double u, double v,
                         struct pp_vec3 *o, struct pp_rgb *factor)
{
    double weight =
        pp_gloss_sample(lobes->gloss, pp_frame_in(&lobes->frame, lobes->eye), u, v, o);
    *factor = pp_rgb_grey(weight);
    if (through)
        o->z = -o->z;
    *o = pp_frame_out(&lobes->frame, *o);
    return weight > 0.0;
}

static double over_share(double value, double share)
{
    return share > 0.0 ? value / share : 0.0;
}

/* Divides light by the share of the gloss. */
static struct pp_rgb over_gloss(const struct pp_lobes *lobes, struct pp_rgb light)
{
    struct pp_rgb share = lobes->share[PP_LOBE_GLOSS];
    return pp_rgb(over_share(light.r, share.r), over_share(light.g, share.g),
                  over_share(light.b, share.b));
}

static bool sample_rough(const struct pp_lobes *lobes, double u, double v,
                         struct pp_vec3 *o, struct pp_rgb *factor)
{
    struct pp_vec3 eye = pp_frame_in(&lobes->frame, lobes->eye), own;
    double weight = pp_rough_lobe_sample(lobes->rough, eye, u, v, &own);
    if (!(weight > 0.0))
        return false;
    struct pp_rgb f = rough_colour(lobes->rough_is_grey,
                                   pp_rough_surface_value(lobes->rough, eye, own));
    *factor = over_gloss(lobes, pp_rgb_scale(f, own.z * weight));
    *o = pp_frame_out(&lobes->frame, own);
    return !pp_rgb_is_black(*factor);
}

static bool sample_bumps(const struct pp_lobes *lobes, double u, double v,
                         struct pp_vec3 *o, struct pp_rgb *factor)
{
    const struct pp_bump_lobe bumps = bumps_of(lobes);
    struct pp_rgb light;
    if (!pp_bump_lobe_sample(&bumps, u, v, o, &light))
        return false;
    *factor = over_gloss(lobes, light);
    return true;
}

bool pp_scatter_sample(const struct pp_lobes *lobes, enum pp_lobe lobe, double u,
                       double v, struct pp_vec3 *o, struct pp_rgb *factor)
{
    struct pp_vec3 n = lobes->frame.z;
    *factor = pp_rgb_grey(1.0);
    switch (lobe) {
    case PP_LOBE_DIFFUSE:
        *o = pp_lobe_sample_in_frame(lobes->frame.x, lobes->frame.y, n, u, v);
        return true;
    case PP_LOBE_THROUGH_DIFFUSE:
        *o = pp_vec_mirrored(
            pp_lobe_sample_in_frame(lobes->frame.x, lobes->frame.y, n, u, v), n);
        return true;
    case PP_LOBE_GLOSS:
    case PP_LOBE_THROUGH_GLOSS:
        if (lobes->scatter)
            return sample_pane(lobes, u, v, o, factor);
        if (lobes->rough)
            return sample_rough(lobes, u, v, o, factor);
        if (lobes->has_bumps)
            return sample_bumps(lobes, u, v, o, factor);
        return sample_gloss(lobes, lobe == PP_LOBE_THROUGH_GLOSS, u, v, o, factor);
    case PP_LOBE_MIRROR:
        *o = pp_vec_mirrored(pp_vec_scale(lobes->eye, -1.0), n);
        return true;
    case PP_LOBE_STRAIGHT:
        *o = pp_vec_scale(lobes->eye, -1.0);
        return true;
    default:
        return false;
    }
}
