/* material.c - see material.h. */
#include "model/light/material.h"

#include <math.h>
#include <string.h>

#include "model/light/finishes.h"

/* Largest excess of a sum of reflectances over 1 that counts as rounding. */
static const double ROUNDING = 1e-9;

static struct pp_material blank(enum pp_material_kind kind)
{
    return (struct pp_material){
        .kind = kind, .clear_share = 1.0, .dirt = 1.0, .pattern = -1};
}

struct pp_material pp_material_diffuse(struct pp_rgb reflectance)
{
    struct pp_material material = blank(PP_MATERIAL_OPAQUE);
    material.diffuse = reflectance;
    return material;
}

struct pp_material pp_material_plastic(struct pp_rgb colour, double specular,
                                       double along, double across)
{
    struct pp_material material =
        pp_material_diffuse(pp_rgb_scale(colour, 1.0 - specular));
    material.gloss = pp_rgb_grey(specular);
    material.roughness[0] = along;
    material.roughness[1] = across;
    return material;
}

struct pp_material pp_material_metal(struct pp_rgb colour, double specular,
                                     double along, double across)
{
    struct pp_material material = pp_material_plastic(colour, specular, along, across);
    material.gloss = pp_rgb_scale(colour, specular);
    return material;
}

struct pp_material pp_material_rough(const struct pp_rough_surface *surface)
{
    struct pp_material material = pp_material_diffuse(surface->optics.diffuse);
    material.gloss =
        pp_rgb_sub(pp_rough_surface_reflectance(surface), surface->optics.diffuse);
    material.rough = surface;
    return material;
}

/* Limits channels to the range from 0 to 1; NAN becomes 0. */
static struct pp_rgb limited(struct pp_rgb c)
{
    return pp_rgb(fmin(fmax(c.r, 0.0), 1.0), fmin(fmax(c.g, 0.0), 1.0),
                  fmin(fmax(c.b, 0.0), 1.0));
}

struct pp_rgb pp_material_diffuse_at(const struct pp_material *material,
                                     struct pp_vec3 point)
{
    if (!material->surface_pattern)
        return material->diffuse;
    double more = pp_surface_pattern_at(material->surface_pattern, point, NULL)
                  - material->pattern_mean;
    return limited(pp_rgb_along(material->diffuse, more, material->pattern_scale));
}

struct pp_rgb pp_material_facet_at(const struct pp_material *material,
                                   struct pp_vec3 point)
{
    return limited(
        pp_rgb_scale(material->pattern_scale,
                     pp_surface_pattern_at(material->surface_pattern, point, NULL)));
}

struct pp_material pp_material_greyed(const struct pp_material *material)
{
    struct pp_material grey = *material;
    grey.diffuse = pp_rgb_grey(pp_rgb_luminance(material->diffuse));
    grey.gloss = pp_rgb_grey(pp_rgb_luminance(material->gloss));
    grey.pattern_scale = pp_rgb_grey(pp_rgb_luminance(material->pattern_scale));
    grey.rough_is_grey = material->rough != NULL;
    return grey;
}

struct pp_material pp_material_trans(struct pp_rgb colour, double specular,
                                     double roughness, double trans,
                                     double through_specular)
{
    struct pp_material material = blank(PP_MATERIAL_TRANSLUCENT);
    struct pp_rgb inward = pp_rgb_scale(colour, 1.0 - specular);
    struct pp_rgb through = pp_rgb_scale(inward, trans);
    material.diffuse = pp_rgb_scale(inward, 1.0 - trans);
    material.gloss = pp_rgb_grey(specular);
    material.through_diffuse = pp_rgb_scale(through, 1.0 - through_specular);
    material.through_gloss = pp_rgb_scale(through, through_specular);
    material.roughness[0] = material.roughness[1] = roughness;
    return material;
}

struct pp_material pp_material_mirror(struct pp_rgb reflectance)
{
    struct pp_material material = blank(PP_MATERIAL_OPAQUE);
    material.gloss = reflectance;
    return material;
}

struct pp_material pp_material_glazing(const struct pp_glass *glass, double clear_share,
                                       double dirt, double frame)
{
    double framed = (1.0 - clear_share) * frame;
    if (glass->diffusing) {
        struct pp_material pane = blank(PP_MATERIAL_TRANSLUCENT);
        double back = pp_glass_reflectance(glass, 1.0);
        pane.diffuse = pp_rgb_grey(framed + clear_share * back);
        pane.through_diffuse = pp_rgb_grey(glass->diffuse * clear_share * dirt);
        return pane;
    }
    struct pp_material pane = blank(PP_MATERIAL_GLASS);
    pane.glass[0] = pane.glass[1] = pane.glass[2] = *glass;
    pane.clear_share = clear_share;
    pane.dirt = dirt;
    pane.diffuse = pp_rgb_grey(framed);
    return pane;
}

struct pp_material pp_material_scattering(const struct pp_pane_scatter *scatter,
                                          bool is_outside, struct pp_vec3 up,
                                          double clear_share, double dirt, double frame)
{
    struct pp_material pane = blank(PP_MATERIAL_SCATTERING);
    double back = is_outside ? scatter->reflect_outside : scatter->reflect_room;
    pane.scatter = scatter;
    pane.is_outside = is_outside;
    pane.grain = up;
    pane.clear_share = clear_share;
    pane.dirt = dirt;
    pane.diffuse = pp_rgb_grey((1.0 - clear_share) * frame + clear_share * back);
    return pane;
}

struct pp_material pp_material_pane(struct pp_rgb transmissivity, double n)
{
    struct pp_material pane = blank(PP_MATERIAL_GLASS);
    const double channels[3] = {transmissivity.r, transmissivity.g, transmissivity.b};
    for (int i = 0; i < 3; i++) {
        int like = 0; /* an earlier channel with equal values */
        while (channels[like] != channels[i])
            like++;
        pane.glass[i] =
            like < i ? pane.glass[like] : pp_glass_panes(1, n, -log(channels[i]));
    }
    return pane;
}

struct pp_material pp_material_light(struct pp_rgb radiance)
{
    struct pp_material material = blank(PP_MATERIAL_OPAQUE);
    material.emits = PP_EMITS_CONCENTRATED;
    material.radiance = radiance;
    return material;
}

struct pp_material pp_material_glow(struct pp_rgb radiance)
{
    struct pp_material material = pp_material_light(radiance);
    material.emits = PP_EMITS_EXTENDED;
    return material;
}

struct pp_material pp_material_air(void)
{
    return blank(PP_MATERIAL_AIR);
}

double pp_material_reflectance(const struct pp_material *material)
{
    if (material->kind == PP_MATERIAL_AIR)
        return 0.0;
    if (material->kind == PP_MATERIAL_GLASS)
        return 0.1;
    return pp_rgb_luminance(pp_rgb_add(material->diffuse, material->gloss));
}

static double or_grey(double channel)
{
    return isnan(channel) ? 1.0 : channel;
}

struct pp_material pp_material_finish(const struct pp_finish *finish,
                                      double reflectance)
{
    struct pp_rgb hue =
        pp_rgb(or_grey(finish->red), or_grey(finish->green), or_grey(finish->blue));
    hue = pp_rgb_scale(hue, 1.0 / pp_rgb_luminance(hue));
    double scale = finish->reflectance > 0.0 ? reflectance / finish->reflectance : 0.0;
    double gloss = isnan(finish->specular) ? 0.0 : scale * finish->specular;

    struct pp_material material =
        pp_material_diffuse(pp_rgb_scale(hue, reflectance - gloss));
    bool metal = strcmp(finish->metal, "yes") == 0;
    material.gloss = metal ? pp_rgb_scale(hue, gloss) : pp_rgb_grey(gloss);
    if (gloss > 0.0) {
        material.roughness[0] = finish->along;
        material.roughness[1] = isnan(finish->across) ? finish->along : finish->across;
    }
    if (material.roughness[0] != material.roughness[1])
        material.grain = pp_vec(1.0, 1.0, 0.0);
    return material;
}

/* ---- checks ---- */

static bool within(struct pp_rgb a, double most)
{
    return a.r >= 0.0 && a.g >= 0.0 && a.b >= 0.0 && a.r <= most && a.g <= most
           && a.b <= most;
}

static enum pp_status wrong(const struct pp_material *material, const char *what,
                            struct pp_error *err)
{
    return pp_fail(err, PP_BAD_INPUT, "material \"%s\": %s", material->name, what);
}

static enum pp_status check_scatter(const struct pp_material *material,
                                    struct pp_error *err)
{
    bool through = material->kind == PP_MATERIAL_TRANSLUCENT;
    struct pp_rgb zero = pp_rgb_grey(0.0);
    struct pp_rgb sum = pp_rgb_add(material->diffuse, material->gloss);
    if (through)
        sum = pp_rgb_add(
            sum, pp_rgb_add(material->through_diffuse, material->through_gloss));
    if (!within(material->diffuse, INFINITY) || !within(material->gloss, INFINITY)
        || !within(through ? material->through_diffuse : zero, INFINITY)
        || !within(through ? material->through_gloss : zero, INFINITY))
        return wrong(material,
                     "a reflectance or transmittance is below 0; expected 0 or more",
                     err);
    if (!within(sum, 1.0 + ROUNDING))
        return wrong(material,
                     "the material reflects and transmits more light than it receives; "
                     "expected the sum of reflectance and transmittance to be at most "
                     "1 in each channel",
                     err);
    for (int i = 0; i < 2; i++)
        if (!(material->roughness[i] >= 0.0 && material->roughness[i] <= 1.0))
            return wrong(material, "expected a roughness from 0 to 1", err);
    return PP_OK;
}

static enum pp_status check_glass(const struct pp_material *material,
                                  struct pp_error *err)
{
    for (int i = 0; i < 3; i++) {
        const struct pp_glass *glass = &material->glass[i];
        if (glass->panes > 0 && !(glass->n > 1.0))
            return wrong(material, "expected a refractive index above 1", err);
        if (glass->panes < 0 || glass->diffusing
            || (glass->panes > 0 && !(glass->kl >= 0.0)) || !(glass->normal >= 0.0)
            || !(glass->normal <= 1.0))
            return wrong(material, "expected a transmittance from 0 to 1", err);
    }
    if (!(material->clear_share >= 0.0 && material->clear_share <= 1.0)
        || !(material->dirt >= 0.0 && material->dirt <= 1.0)
        || !within(material->diffuse, 1.0 - material->clear_share + ROUNDING))
        return wrong(material, "expected fractions from 0 to 1", err);
    return PP_OK;
}

enum pp_status pp_material_check(const struct pp_material *material,
                                 struct pp_error *err)
{
    if (!within(material->radiance, INFINITY) || isinf(pp_rgb_most(material->radiance)))
        return wrong(material, "expected a radiance of 0 or more", err);
    switch (material->kind) {
    case PP_MATERIAL_AIR:
    case PP_MATERIAL_SCATTERING: /* its reader has checked the data */
        return PP_OK;
    case PP_MATERIAL_GLASS:
        return check_glass(material, err);
    default:
        return check_scatter(material, err);
    }
}
