/* scatter.h - where light goes from a surface: a material's lobes at one point.
 *
 * Diffuse lobes go by the cosine, a gloss as gloss.h has it; what goes through as a
 * gloss is the same with its direction mirrored in the surface.
 */
#ifndef PP_SIMULATE_SAMPLING_SCATTER_H
#define PP_SIMULATE_SAMPLING_SCATTER_H

#include <stdbool.h>

#include "model/light/material.h"
#include "model/light/rgb.h"
#include "model/geometry/vec.h"
#include "simulate/sampling/gloss.h"

enum pp_lobe {
    PP_LOBE_DIFFUSE,
    PP_LOBE_THROUGH_DIFFUSE,
    PP_LOBE_GLOSS,
    PP_LOBE_THROUGH_GLOSS,
    PP_LOBE_MIRROR,
    PP_LOBE_STRAIGHT,
    PP_LOBE_COUNT,
};

/* All for light that comes to an eye in direction `eye`; n on the eye's side. */
struct pp_lobes {
    struct pp_rgb share[PP_LOBE_COUNT]; /* how much of it each sends on, all in all */
    struct pp_vec3 a, b, n;             /* right-handed; a along the grain */
    struct pp_vec3 eye;
    const struct pp_gloss *gloss; /* NULL: none, or a mirror; not owned */
};

/* gloss: the material's; NULL where it has none, or is a mirror. */
void pp_scatter_init(struct pp_lobes *lobes, const struct pp_material *material,
                     const struct pp_gloss *gloss, struct pp_vec3 n,
                     struct pp_vec3 eye);

/* What passes straight through the material without being scattered, at the cosine of
 * the angle of incidence. */
struct pp_rgb pp_scatter_regular_transmittance(const struct pp_material *material,
                                               double cos_incidence);

/* What it mirrors, or gives back as a gloss, at that cosine. */
struct pp_rgb pp_scatter_specular_reflectance(const struct pp_material *material,
                                              double cos_incidence);

/* f of the glosses between the eye and direction o (unit, any side), 1/sr. */
struct pp_rgb pp_scatter_gloss_brdf(const struct pp_lobes *lobes, struct pp_vec3 o);

/* How wide the gloss looks, in radians: the side of a square as large as its ellipse.
 */
double pp_scatter_gloss_width(const struct pp_lobes *lobes);

/* A direction of that lobe by two numbers in (0, 1), and the factor that its share is
 * then worth; false where it would go into the surface. */
bool pp_scatter_sample(const struct pp_lobes *lobes, enum pp_lobe lobe, double u,
                       double v, struct pp_vec3 *o, double *factor);

#endif
