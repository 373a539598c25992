/* scatter.h - the BRDF and BTDF of a material at one point, as a sum of lobes.
 *
 * Diffuse lobes are Lambertian; glosses are those of gloss.h. The lobe of a transmitted
 * gloss is the same, with its direction mirrored in the surface. The spike of a
 * physically rough surface is a mirror lobe; the rest of its reflection replaces the
 * gloss. The reflection of a matt surface with bumps replaces the gloss too. For a
 * scattering pane, the BTDF (model/light/pane_scatter.h) replaces the transmitted
 * gloss.
 */
#ifndef PP_SIMULATE_SAMPLING_SCATTER_H
#define PP_SIMULATE_SAMPLING_SCATTER_H

#include <stdbool.h>

#include "model/geometry/frame.h"
#include "model/light/material.h"
#include "model/light/rgb.h"
#include "simulate/sampling/gloss.h"
#include "simulate/sampling/rough_lobe.h"

enum pp_lobe {
    PP_LOBE_DIFFUSE,
    PP_LOBE_THROUGH_DIFFUSE,
    PP_LOBE_GLOSS,
    PP_LOBE_THROUGH_GLOSS,
    PP_LOBE_MIRROR,
    PP_LOBE_STRAIGHT,
    PP_LOBE_COUNT,
};

/* True if the lobe goes through the surface. */
static inline bool pp_scatter_goes_through(enum pp_lobe lobe)
{
    return lobe == PP_LOBE_THROUGH_DIFFUSE || lobe == PP_LOBE_THROUGH_GLOSS
           || lobe == PP_LOBE_STRAIGHT;
}

/* The lobes for light that is scattered towards an eye in direction `eye`. */
struct pp_lobes {
    struct pp_rgb share[PP_LOBE_COUNT]; /* each lobe's albedo */
    struct pp_frame frame; /* x along the grain, z the normal on the eye's side */
    struct pp_vec3 eye;
    const struct pp_gloss *gloss;         /* NULL: none, or a mirror; not owned */
    const struct pp_rough_surface *rough; /* NULL: none; not owned */
    bool rough_is_grey;
    bool has_bumps;
    struct pp_vec3 bump_slope; /* as in bump_lobe.h; only with has_bumps */
    struct pp_rgb bump_facet;
    const struct pp_pane_scatter *scatter; /* BTDF of the lobe PP_LOBE_THROUGH_GLOSS;
                                            * NULL: a gloss; not owned */
    bool is_outside;                       /* as in the material */
};

/* True if there is a gloss, a rough surface, a BTDF or bumps. */
static inline bool pp_scatter_has_gloss(const struct pp_lobes *lobes)
{
    return lobes->gloss || lobes->rough || lobes->scatter || lobes->has_bumps;
}

/* gloss: gloss of the material; NULL if the material has no gloss or is a mirror. */
void pp_scatter_init(struct pp_lobes *lobes, const struct pp_material *material,
                     const struct pp_gloss *gloss, struct pp_vec3 n,
                     struct pp_vec3 eye);

/* Replaces the diffuse lobe by that of the bumps of the material at a point of the
 * room. */
void pp_scatter_add_bumps(struct pp_lobes *lobes, const struct pp_material *material,
                          struct pp_vec3 point);

/* Transmittance of the material for light that is not scattered (regular
 * transmittance), at the cosine of the angle of incidence. Not for scattering panes. */
struct pp_rgb pp_scatter_regular_transmittance(const struct pp_material *material,
                                               double cos_incidence);

/* Regular transmittance of any material, including scattering panes, for light that
 * leaves towards `eye`. If the pane has a state for sunlight (for_sun), that state
 * counts. n: the normal on the eye's side. */
struct pp_rgb pp_scatter_straight(const struct pp_material *material, struct pp_vec3 n,
                                  struct pp_vec3 eye);

/* Reflectance of the material's mirror, spike or gloss, at this cosine of the angle of
 * incidence. */
struct pp_rgb pp_scatter_specular_reflectance(const struct pp_material *material,
                                              double cos_incidence);

/* BRDF, or BTDF, of the glosses between the eye and direction o (unit, any side),
 * 1/sr. */
struct pp_rgb pp_scatter_gloss_brdf(const struct pp_lobes *lobes, struct pp_vec3 o);

/* Density (per steradian) of direction o (unit, on either side) in the gloss lobe of
 * that side, if drawn by pp_scatter_sample. */
double pp_scatter_gloss_pdf(const struct pp_lobes *lobes, struct pp_vec3 o);

/* Samples a direction of the lobe from two numbers in (0, 1). *factor: BRDF times
 * cosine, divided by the density and by the lobe's share. False if the direction would
 * point into the surface. */
bool pp_scatter_sample(const struct pp_lobes *lobes, enum pp_lobe lobe, double u,
                       double v, struct pp_vec3 *o, struct pp_rgb *factor);

#endif
